#include "model/sculpting/screen_selection.h"

#include <algorithm>

#include <glm/common.hpp>

#include "model/core/check.h"

namespace knotspan {

namespace {

constexpr size_t kMostBands = 1024;

template <class IsInside>
PointSelection chosen(const std::vector<ProjectedNet>& nets, const IsInside& isInside)
{
    PointSelection result;
    for (const ProjectedNet& net : nets) {
        check(net.pixels.size() == net.net.count(), "each control point of the net has its place, or none");
        std::vector<ControlPointIndex> points;
        for (size_t place = 0; place < net.pixels.size(); ++place)
            if (net.pixels[place] && isInside(*net.pixels[place]))
                points.push_back(net.net.indexAt(place));
        result.add(PointSelection(net.object, net.net, std::move(points)));
    }
    return result;
}

}  // namespace

std::vector<ProjectedNet> projected(const Scene& scene, const std::set<ObjectId>& objects,
                                    const Projection& projection)
{
    std::vector<ProjectedNet> nets;
    for (const ObjectId id : objects) {
        const SharedObject object = scene.find(id);
        if (!object)
            continue;
        ProjectedNet net{id, netSizeOf(object->surface), {}};
        net.pixels.reserve(net.net.count());
        for (const ControlPoint& point : object->surface.controlPoints())
            net.pixels.push_back(projection(transformed(point.position, object->transform)));
        nets.push_back(std::move(net));
    }
    return nets;
}

PointSelection insideBox(const std::vector<ProjectedNet>& nets, const Vec2& a, const Vec2& b)
{
    const Vec2 low = glm::min(a, b);
    const Vec2 high = glm::max(a, b);
    return chosen(nets, [&](const Vec2& pixel) {
        return pixel.x >= low.x && pixel.x <= high.x && pixel.y >= low.y && pixel.y <= high.y;
    });
}

Lasso::Lasso(std::vector<Vec2> corners)
{
    if (corners.empty())
        return;
    low_ = high_ = corners.front();
    for (const Vec2& corner : corners) {
        low_ = glm::min(low_, corner);
        high_ = glm::max(high_, corner);
    }
    bands_.resize(std::min(corners.size(), kMostBands));
    for (size_t k = 0; k < corners.size(); ++k) {
        const Edge edge{corners[k], corners[(k + 1) % corners.size()]};
        const size_t last = bandAt(std::max(edge.from.y, edge.to.y));
        for (size_t band = bandAt(std::min(edge.from.y, edge.to.y)); band <= last; ++band)
            bands_[band].push_back(edge);
    }
}

size_t Lasso::bandAt(double y) const
{
    const double height = high_.y - low_.y;
    if (!(height > 0))
        return 0;
    const double band = (y - low_.y) / height * static_cast<double>(bands_.size());
    return std::min(static_cast<size_t>(std::max(band, 0.0)), bands_.size() - 1);
}

bool Lasso::contains(const Vec2& place) const
{
    if (bands_.empty() ||
        !(place.x >= low_.x && place.x <= high_.x && place.y >= low_.y && place.y <= high_.y))
        return false;
    bool inside = false;
    for (const auto& [from, to] : bands_[bandAt(place.y)])
        if ((from.y > place.y) != (to.y > place.y) &&
            place.x < from.x + (place.y - from.y) / (to.y - from.y) * (to.x - from.x))
            inside = !inside;
    return inside;
}

PointSelection insideLasso(const std::vector<ProjectedNet>& nets, const Lasso& lasso)
{
    return chosen(nets, [&](const Vec2& pixel) { return lasso.contains(pixel); });
}

}  // namespace knotspan
