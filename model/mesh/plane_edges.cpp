// PlaneTriangulation: edges that must be there.
#include <algorithm>

#include "model/mesh/plane_triangulation.h"

namespace knotspan {

namespace {

size_t after(size_t k)
{
    return (k + 1) % 3;
}

size_t before(size_t k)
{
    return (k + 2) % 3;
}

}  // namespace

PlaneTriangulation::EdgeAt PlaneTriangulation::find(std::uint32_t from, std::uint32_t to) const
{
    const std::uint32_t first = triangleOf_[from];
    for (const bool forwards : {true, false}) {
        std::uint32_t at = first;
        do {
            const Corners& triangle = triangles_[at];
            size_t k = 0;
            while (triangle.vertices[k] != from)
                ++k;
            if (triangle.vertices[after(k)] == to)
                return {at, static_cast<int>(before(k))};
            at = triangle.neighbours[forwards ? after(k) : before(k)];
        } while (at != first && at != kNone);
    }
    return {};
}

// Of the triangles around `from`, the one that the way to `to` leaves through its opposite edge, or whose
// second vertex lies on it.
PlaneTriangulation::EdgeAt PlaneTriangulation::firstCrossed(std::uint32_t from, std::uint32_t to) const
{
    const std::uint32_t first = triangleOf_[from];
    const GridPlace& end = places_[to];
    std::uint32_t at = first;
    do {
        const Corners& triangle = triangles_[at];
        size_t k = 0;
        while (triangle.vertices[k] != from)
            ++k;
        if (turn(from, triangle.vertices[after(k)], end) >= 0 &&
            turn(from, triangle.vertices[before(k)], end) < 0)
            return {at, static_cast<int>(k)};
        at = triangle.neighbours[after(k)];
    } while (at != first && at != kNone);
    return {};
}

bool PlaneTriangulation::startsInside(std::uint32_t from, std::uint32_t to) const
{
    const EdgeAt start = firstCrossed(from, to);
    return start.triangle != kNone && triangles_[start.triangle].inside;
}

void PlaneTriangulation::fix(std::uint32_t from, std::uint32_t to)
{
    for (const EdgeAt& edge : {find(from, to), find(to, from)})
        if (edge.triangle != kNone)
            triangles_[edge.triangle].fixed[static_cast<size_t>(edge.corner)] = true;
}

std::optional<PlaneTriangulation::Obstacle> PlaneTriangulation::connect(std::uint32_t from, std::uint32_t to)
{
    if (from == to)
        return std::nullopt;
    if (find(from, to).triangle != kNone) {
        fix(from, to);
        return std::nullopt;
    }
    EdgeAt at = firstCrossed(from, to);
    if (at.triangle == kNone)
        return Obstacle{from, from};
    std::vector<std::array<std::uint32_t, 2>> crossed;
    for (;;) {
        const auto k = static_cast<size_t>(at.corner);
        const Corners& triangle = triangles_[at.triangle];
        const std::uint32_t right = triangle.vertices[after(k)];
        const std::uint32_t left = triangle.vertices[before(k)];
        if (turn(from, to, places_[right]) == 0)
            return Obstacle{right, right};
        if (triangle.fixed[k])
            return Obstacle{right, left};
        crossed.push_back({right, left});
        const std::uint32_t next = triangle.neighbours[k];
        const auto far = static_cast<size_t>(cornerTowards(next, at.triangle));
        const std::uint32_t vertex = triangles_[next].vertices[far];
        if (vertex == to)
            break;
        const int side = turn(from, to, places_[vertex]);
        if (side == 0)
            return Obstacle{vertex, vertex};
        // Out through the edge that has its ends on both sides.
        at = {next, static_cast<int>(side > 0 ? after(far) : before(far))};
    }
    std::vector<std::array<std::uint32_t, 2>> made;
    for (size_t next = 0; next < crossed.size(); ++next) {
        const EdgeAt edge = find(crossed[next][0], crossed[next][1]);
        if (!isConvex(edge.triangle, edge.corner)) {
            crossed.push_back(crossed[next]);
            continue;
        }
        flip(edge.triangle, edge.corner);
        const auto& v = triangles_[edge.triangle].vertices;  // p a q: the new edge is p q
        const std::uint32_t p = v[0];
        const std::uint32_t q = v[2];
        const bool crosses = p != from && q != from && p != to && q != to &&
                             turn(from, to, places_[p]) * turn(from, to, places_[q]) < 0;
        (crosses ? crossed : made).push_back({p, q});
    }
    fix(from, to);
    for (const auto& [p, q] : made)
        if (const EdgeAt edge = find(p, q); edge.triangle != kNone)
            legalize({edge});
    return std::nullopt;
}

}  // namespace knotspan
