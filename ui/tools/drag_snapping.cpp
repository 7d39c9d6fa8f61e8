#include "ui/tools/drag_snapping.h"

#include <utility>

#include <glm/geometric.hpp>

#include "model/sculpting/snapping.h"

namespace knotspan {

DragSnapping::DragSnapping(const Scene& scene, const SnapSettings& settings, Moving moving)
    : scene_(scene),
      settings_(settings),
      moving_(std::move(moving))
{
    std::set<ObjectId> standing;
    for (const auto& [id, object] : scene.objects()) {
        if (!object->visible || moving_.objects.count(id) != 0)
            continue;
        pointObjects_.insert(id);
        if (moving_.points.objects().count(id) == 0)
            standing.insert(id);
    }
    if (settings.knotLines)
        knotLines_.emplace(scene, standing, SnapTarget::knotLines);
    if (settings.surfaces)
        surfaces_.emplace(scene, standing, SnapTarget::surface);
    if (moving_.friends) {
        std::vector<Vec3> places;
        for (const auto& [id, chosen] : moving_.points.objects())
            for (const ControlPointIndex index : chosen.points)
                places.push_back(controlPointInModel(*scene.find(id), index));
        friendPlaces_.emplace(places);
    }
}

bool DragSnapping::goesAlong(const ScenePoint& point) const
{
    if (moving_.points.contains(point))
        return true;
    if (!friendPlaces_)
        return false;
    const SceneObject& object = *scene_.find(point.object);
    constexpr double kSame = 1e-6;  // of the object's size
    const Vec3 place = controlPointInModel(object, point.index);
    return friendPlaces_->nearest(place, kSame * object.bounds().diagonal()).has_value();
}

// Again only where the view was turned meanwhile.
void DragSnapping::look(const PictureView& view)
{
    if (view_ == view)
        return;
    view_ = view;
    seen_.clear();
    std::vector<Vec3> pixels;
    const PixelProjection projection(view.camera, view.width, view.height);
    for (const ProjectedNet& net : projected(scene_, pointObjects_, projection))
        for (size_t place = 0; place < net.pixels.size(); ++place) {
            const ScenePoint point{net.object, net.net.indexAt(place)};
            if (!net.pixels[place] || goesAlong(point))
                continue;
            seen_.push_back({*net.pixels[place], point});
            pixels.emplace_back(*net.pixels[place], 0);
        }
    tree_.emplace(pixels);
}

std::optional<Vec3> DragSnapping::pointAt(const PictureView& view, const Vec3& hand) const
{
    const auto pixel = view.camera.toPixel(hand, view.width, view.height);
    if (!pixel)
        return std::nullopt;
    const Vec3 at(*pixel, 0);
    const auto nearest = tree_->nearest(at, settings_.reachPx * view.pixelRatio);
    if (!nearest)
        return std::nullopt;
    // Behind each other on the picture: the one that is least far in depth.
    constexpr double kAlikePx = 0.5;
    std::optional<Vec3> best;
    for (const size_t k : tree_->within(at, nearest->distance + kAlikePx)) {
        const ScenePoint& point = seen_[k].point;
        const Vec3 place = controlPointInModel(*scene_.find(point.object), point.index);
        if (!best || glm::distance(place, hand) < glm::distance(*best, hand))
            best = place;
    }
    return best;
}

std::optional<Vec3> DragSnapping::target(const PictureView& view, const Vec3& hand, const Vec3& place)
{
    if (settings_.points) {
        look(view);
        if (const auto found = pointAt(view, hand))
            return found;
    }
    const double reach = settings_.reachPx * view.pixelRatio * view.camera.unitsPerPixel(place, view.height);
    for (const auto* snap : {&knotLines_, &surfaces_})
        if (*snap)
            if (const auto found = (*snap)->nearest(place, reach))
                return found->position;
    if (settings_.grid)
        return snappedToGrid(place, settings_.gridStep);
    return std::nullopt;
}

void showTarget(const PictureView& view, const Vec3& target, Overlays& overlays)
{
    constexpr double kArmPx = 8;
    constexpr std::uint32_t kColour = 0xf2d13c;
    const auto pixel = view.camera.toPixel(target, view.width, view.height);
    if (!pixel)
        return;
    const auto width = static_cast<float>(2 * view.pixelRatio);
    for (const Vec2 arm : {Vec2(1, 1), Vec2(1, -1)}) {
        const Vec2 half = kArmPx * view.pixelRatio * arm;
        overlays.strokes.push_back({*pixel - half, *pixel + half, kColour, width, width, 1});
    }
}

}  // namespace knotspan
