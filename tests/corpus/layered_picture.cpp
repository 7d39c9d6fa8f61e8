#include "tests/corpus/layered_picture.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace knotspan::corpus {

LayeredPicture::LayeredPicture(const FineMesh& mesh, const Camera& camera, int width, int height)
    : width_(width),
      height_(height),
      nearestOnEdge_(static_cast<size_t>(width) * static_cast<size_t>(height), Layer{0, -1})
{
    const PixelProjection toPixel(camera, width, height);
    const Vec3 forward = camera.forward();
    for (const FineTriangle& triangle : mesh.triangles) {
        Vec3 corners[3];
        bool inFront = true;
        for (size_t k = 0; k < 3; ++k) {
            const auto place = toPixel(triangle.corners[k]);
            inFront = inFront && place.has_value();
            if (place)
                corners[k] = Vec3(*place, glm::dot(triangle.corners[k] - camera.eye, forward));
        }
        if (inFront)
            paint(corners, camera.orthographic, triangle.face);
    }
    sortByPixel();
}

void LayeredPicture::paint(const Vec3 (&corners)[3], bool orthographic, int face)
{
    const Vec2 a(corners[0]);
    const Vec2 b(corners[1]);
    const Vec2 c(corners[2]);
    const auto twiceArea = [](const Vec2& p, const Vec2& q, const Vec2& r) {
        return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    };
    const double all = twiceArea(a, b, c);
    const auto [lowX, highX] = std::minmax({a.x, b.x, c.x});
    const auto [lowY, highY] = std::minmax({a.y, b.y, c.y});
    if (std::abs(all) < kThinPx * std::max(highX - lowX, highY - lowY))
        markOnEdge(corners, face);
    if (all == 0)
        return;
    const auto first = [](double low) { return std::max(0, static_cast<int>(std::ceil(low - 0.5))); };
    const int endX = std::min(width_ - 1, static_cast<int>(std::floor(highX - 0.5)));
    const int endY = std::min(height_ - 1, static_cast<int>(std::floor(highY - 0.5)));
    // On an edge that two triangles share, rounding may count a centre to neither: both take it.
    constexpr double kOnEdge = 1e-7;
    const double least = -kOnEdge * std::max(highX - lowX, highY - lowY);
    for (int y = first(lowY); y <= endY; ++y)
        for (int x = first(lowX); x <= endX; ++x) {
            const Vec2 centre(x + 0.5, y + 0.5);
            const double sign = all > 0 ? 1 : -1;
            const double ofA = twiceArea(b, c, centre) * sign;
            const double ofB = twiceArea(c, a, centre) * sign;
            const double ofC = twiceArea(a, b, centre) * sign;
            if (std::min({ofA, ofB, ofC}) < least)
                continue;
            const Vec3 part = Vec3(ofA, ofB, ofC) / (ofA + ofB + ofC);
            const Vec3 depths(corners[0].z, corners[1].z, corners[2].z);
            const double depth =
                orthographic ? glm::dot(part, depths) : 1 / glm::dot(part, Vec3(1.0) / depths);
            const auto pixel = static_cast<std::uint32_t>(y * width_ + x);
            fragments_.push_back({pixel, {static_cast<float>(depth), face}});
        }
}

// Along its longest side, which the two others lie beside.
void LayeredPicture::markOnEdge(const Vec3 (&corners)[3], int face)
{
    Vec3 from(0.0);
    Vec3 way(0.0);
    for (int k = 0; k < 3; ++k)
        if (const Vec3 side = corners[(k + 1) % 3] - corners[k];
            glm::length(Vec2(side)) >= glm::length(Vec2(way))) {
            from = corners[k];
            way = side;
        }
    const int steps = 1 + static_cast<int>(glm::length(Vec2(way)));
    for (int k = 0; k <= steps; ++k) {
        const Vec3 place = from + way * (static_cast<double>(k) / steps);
        if (place.x < 0 || place.y < 0 || place.x >= width_ || place.y >= height_)
            continue;
        const auto pixel =
            static_cast<std::uint32_t>(static_cast<int>(place.y) * width_ + static_cast<int>(place.x));
        // A wall is thousands of triangles in the same pixels.
        Layer& nearest = nearestOnEdge_[pixel];
        const auto depth = static_cast<float>(place.z);
        if (nearest.face == face && nearest.depth <= depth)
            continue;
        nearest = {depth, face};
        onEdge_.push_back({pixel, nearest});
    }
}

bool LayeredPicture::onEdge(int x, int y, int face, double depth) const
{
    const auto pixel = static_cast<std::uint32_t>(y * width_ + x);
    auto it = std::lower_bound(onEdge_.begin(), onEdge_.end(), pixel,
                               [](const Fragment& one, std::uint32_t wanted) { return one.pixel < wanted; });
    for (; it != onEdge_.end() && it->pixel == pixel; ++it)
        if (it->layer.face == face && it->layer.depth <= depth)
            return true;
    return false;
}

void LayeredPicture::sortByPixel()
{
    std::sort(onEdge_.begin(), onEdge_.end(),
              [](const Fragment& a, const Fragment& b) { return a.pixel < b.pixel; });
    starts_.assign(static_cast<size_t>(width_) * static_cast<size_t>(height_) + 1, 0);
    for (const Fragment& fragment : fragments_)
        ++starts_[fragment.pixel + 1];
    for (size_t k = 1; k < starts_.size(); ++k)
        starts_[k] += starts_[k - 1];
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    layers_.resize(fragments_.size());
    for (const Fragment& fragment : fragments_)
        layers_[next[fragment.pixel]++] = fragment.layer;
    fragments_ = {};
    for (size_t k = 0; k + 1 < starts_.size(); ++k)
        std::sort(layers_.begin() + starts_[k], layers_.begin() + starts_[k + 1],
                  [](const Layer& a, const Layer& b) { return a.depth < b.depth; });
}

}  // namespace knotspan::corpus
