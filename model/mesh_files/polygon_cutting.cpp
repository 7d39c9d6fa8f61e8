#include "model/mesh_files/polygon_cutting.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

namespace knotspan::formats {

void PolygonCutting::cut(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices,
                         std::vector<Triangle>& triangles)
{
    constexpr double kPatience = 100;
    patience_ += kPatience * static_cast<double>(corners.size());
    if (corners.size() > 3 && project(corners, vertices)) {
        ring_.resize(corners.size());
        std::iota(ring_.begin(), ring_.end(), size_t{0});
        if (!isConvex())
            return cutEars(corners, triangles);
        const auto length = [&](size_t a, size_t b) {
            return glm::distance(vertices[corners[a]], vertices[corners[b]]);
        };
        if (corners.size() == 4 && length(1, 3) < length(0, 2)) {
            triangles.push_back({corners[0], corners[1], corners[3]});
            triangles.push_back({corners[1], corners[2], corners[3]});
            return;
        }
    }
    ring_.resize(corners.size());
    std::iota(ring_.begin(), ring_.end(), size_t{0});
    cutFan(corners, triangles);
}

// Onto the coordinate plane that the polygon faces most, counter-clockwise. False where it has no area.
bool PolygonCutting::project(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices)
{
    const Vec3 origin = vertices[corners[0]];
    Vec3 normal(0);  // Newell's: the areas of its projections
    for (size_t k = 0; k < corners.size(); ++k)
        normal +=
            glm::cross(vertices[corners[k]] - origin, vertices[corners[(k + 1) % corners.size()]] - origin);
    const Vec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    if (!(size[axis] > 0) || !std::isfinite(size[axis]))
        return false;
    const double sign = normal[axis] > 0 ? 1 : -1;
    flat_.clear();
    for (const std::uint32_t corner : corners) {
        const Vec3 from = vertices[corner] - origin;
        flat_.emplace_back(sign * from[(axis + 1) % 3], from[(axis + 2) % 3]);
    }
    return true;
}

// Above zero where c lies to the left of the way from a to b.
double PolygonCutting::turn(size_t a, size_t b, size_t c) const
{
    const Vec2 along = flat_[b] - flat_[a];
    const Vec2 to = flat_[c] - flat_[a];
    return along.x * to.y - along.y * to.x;
}

bool PolygonCutting::isConvex() const
{
    const size_t count = flat_.size();
    for (size_t k = 0; k < count; ++k)
        if (turn(k, (k + 1) % count, (k + 2) % count) < 0)
            return false;
    return true;
}

// Whether the corner stands out and no other corner lies in the triangle that cutting it off makes.
bool PolygonCutting::isEar(size_t at) const
{
    const size_t count = ring_.size();
    const size_t a = ring_[(at + count - 1) % count];
    const size_t b = ring_[at];
    const size_t c = ring_[(at + 1) % count];
    if (!(turn(a, b, c) > 0))
        return false;
    return std::none_of(ring_.begin(), ring_.end(), [&](size_t other) {
        const bool isCorner =
            flat_[other] == flat_[a] || flat_[other] == flat_[b] || flat_[other] == flat_[c];
        return !isCorner && turn(a, b, other) >= 0 && turn(b, c, other) >= 0 && turn(c, a, other) >= 0;
    });
}

void PolygonCutting::cutEars(std::span<const std::uint32_t> corners, std::vector<Triangle>& triangles)
{
    for (size_t at = 0, failures = 0; ring_.size() > 3 && failures < ring_.size() && patience_ > 0;) {
        at %= ring_.size();
        patience_ -= static_cast<double>(ring_.size());
        if (!isEar(at)) {
            ++failures;
            ++at;
            continue;
        }
        const size_t count = ring_.size();
        triangles.push_back(
            {corners[ring_[(at + count - 1) % count]], corners[ring_[at]], corners[ring_[(at + 1) % count]]});
        ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(at));
        failures = 0;
        // Not the next one: ears cut one after the other at one corner are needles.
        ++at;
    }
    cutFan(corners, triangles);
}

void PolygonCutting::cutFan(std::span<const std::uint32_t> corners, std::vector<Triangle>& triangles) const
{
    for (size_t k = 2; k < ring_.size(); ++k)
        triangles.push_back({corners[ring_[0]], corners[ring_[k - 1]], corners[ring_[k]]});
}

}  // namespace knotspan::formats
