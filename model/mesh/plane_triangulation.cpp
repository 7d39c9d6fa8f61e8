#include "model/mesh/plane_triangulation.h"

#include <algorithm>
#include <cmath>

namespace knotspan {

namespace {

__extension__ using Wide = __int128;

// Above zero where a, b, c turn left. Coordinates take 30 bits, so products fit.
std::int64_t area(const GridPlace& a, const GridPlace& b, const GridPlace& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

int signOf(std::int64_t value)
{
    return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0);
}

// Whether d lies within the circle through a, b, c, which turn left.
bool inCircle(const GridPlace& a, const GridPlace& b, const GridPlace& c, const GridPlace& d)
{
    const std::int64_t ax = a.x - d.x;
    const std::int64_t ay = a.y - d.y;
    const std::int64_t bx = b.x - d.x;
    const std::int64_t by = b.y - d.y;
    const std::int64_t cx = c.x - d.x;
    const std::int64_t cy = c.y - d.y;
    const std::int64_t aa = ax * ax + ay * ay;
    const std::int64_t bb = bx * bx + by * by;
    const std::int64_t cc = cx * cx + cy * cy;
    const std::int64_t ab = ax * by - ay * bx;
    const std::int64_t bc = bx * cy - by * cx;
    const std::int64_t ca = cx * ay - cy * ax;
    const double rough = static_cast<double>(aa) * static_cast<double>(bc) +
                         static_cast<double>(bb) * static_cast<double>(ca) +
                         static_cast<double>(cc) * static_cast<double>(ab);
    const double size = std::abs(static_cast<double>(aa) * static_cast<double>(bc)) +
                        std::abs(static_cast<double>(bb) * static_cast<double>(ca)) +
                        std::abs(static_cast<double>(cc) * static_cast<double>(ab));
    if (std::abs(rough) > 1e-14 * size)
        return rough > 0;
    return Wide(aa) * bc + Wide(bb) * ca + Wide(cc) * ab > 0;
}

size_t after(size_t k)
{
    return (k + 1) % 3;
}

size_t before(size_t k)
{
    return (k + 2) % 3;
}

}  // namespace

PlaneTriangulation::PlaneTriangulation()
{
    constexpr std::int64_t kBeyond = kMost / 4;
    places_ = {{-kBeyond, -kBeyond},
               {kMost + kBeyond, -kBeyond},
               {kMost + kBeyond, kMost + kBeyond},
               {-kBeyond, kMost + kBeyond}};
    triangles_ = {{{0, 1, 2}, {kNone, 1, kNone}, {}, false}, {{0, 2, 3}, {kNone, kNone, 0}, {}, false}};
    triangleOf_ = {0, 0, 0, 1};
}

int PlaneTriangulation::turn(std::uint32_t a, std::uint32_t b, const GridPlace& c) const
{
    return signOf(area(places_[a], places_[b], c));
}

// Walks across edges that have the place on their other side, beginning with another one in each triangle:
// where edges are fixed a walk that always begins with the same could go round.
PlaneTriangulation::Location PlaneTriangulation::locate(const GridPlace& place)
{
    std::uint32_t at = last_;
    for (size_t first = 0;; first = after(first)) {
        const Corners& triangle = triangles_[at];
        Location found{at, -1, -1};
        int zeros = 0;
        std::uint32_t next = kNone;
        for (size_t step = 0; step < 3 && next == kNone; ++step) {
            const size_t k = (first + step) % 3;
            const int side = turn(triangle.vertices[after(k)], triangle.vertices[before(k)], place);
            if (side < 0) {
                next = triangle.neighbours[k];
            } else if (side == 0) {
                ++zeros;
                found.onEdge = static_cast<int>(k);
            }
        }
        if (next == kNone) {
            last_ = at;
            if (zeros == 2) {
                for (size_t k = 0; k < 3; ++k)
                    if (places_[triangle.vertices[k]] == place)
                        found.onVertex = static_cast<int>(k);
                found.onEdge = -1;
            }
            return found;
        }
        at = next;
    }
}

std::uint32_t PlaneTriangulation::add(const GridPlace& place)
{
    return addAt(locate(place), place);
}

std::optional<std::uint32_t> PlaneTriangulation::addInside(const GridPlace& place)
{
    const Location location = locate(place);
    const Corners& triangle = triangles_[location.triangle];
    if (location.onVertex >= 0)
        return triangle.vertices[static_cast<size_t>(location.onVertex)];
    if (!triangle.inside || (location.onEdge >= 0 && triangle.fixed[static_cast<size_t>(location.onEdge)]))
        return std::nullopt;
    return addAt(location, place);
}

std::uint32_t PlaneTriangulation::addAt(const Location& location, const GridPlace& place)
{
    if (location.onVertex >= 0)
        return triangles_[location.triangle].vertices[static_cast<size_t>(location.onVertex)];
    const auto vertex = static_cast<std::uint32_t>(places_.size());
    places_.push_back(place);
    triangleOf_.push_back(location.triangle);
    if (location.onEdge >= 0)
        splitAt(location.triangle, location.onEdge, vertex);
    else
        splitTriangle(location.triangle, vertex);
    std::vector<EdgeAt> edges;
    std::uint32_t at = triangleOf_[vertex];
    const std::uint32_t first = at;
    do {
        size_t k = 0;
        while (triangles_[at].vertices[k] != vertex)
            ++k;
        edges.push_back({at, static_cast<int>(k)});
        at = triangles_[at].neighbours[after(k)];
    } while (at != first);
    legalize(std::move(edges));
    return vertex;
}

void PlaneTriangulation::redirect(std::uint32_t triangle, std::uint32_t from, std::uint32_t to)
{
    if (triangle == kNone)
        return;
    for (std::uint32_t& neighbour : triangles_[triangle].neighbours)
        if (neighbour == from) {
            neighbour = to;
            return;
        }
}

int PlaneTriangulation::cornerTowards(std::uint32_t triangle, std::uint32_t neighbour) const
{
    const auto& neighbours = triangles_[triangle].neighbours;
    return static_cast<int>(std::find(neighbours.begin(), neighbours.end(), neighbour) - neighbours.begin());
}

void PlaneTriangulation::splitTriangle(std::uint32_t triangle, std::uint32_t vertex)
{
    const Corners old = triangles_[triangle];
    const auto [a, b, c] = old.vertices;
    const auto second = static_cast<std::uint32_t>(triangles_.size());
    const std::uint32_t third = second + 1;
    triangles_[triangle] = {
        {vertex, a, b}, {old.neighbours[2], second, third}, {old.fixed[2], false, false}, old.inside};
    triangles_.push_back(
        {{vertex, b, c}, {old.neighbours[0], third, triangle}, {old.fixed[0], false, false}, old.inside});
    triangles_.push_back(
        {{vertex, c, a}, {old.neighbours[1], triangle, second}, {old.fixed[1], false, false}, old.inside});
    redirect(old.neighbours[0], triangle, second);
    redirect(old.neighbours[1], triangle, third);
    triangleOf_[a] = triangleOf_[b] = triangleOf_[vertex] = triangle;
    triangleOf_[c] = second;
}

// Both triangles along the edge become two.
void PlaneTriangulation::splitAt(std::uint32_t triangle, int corner, std::uint32_t vertex)
{
    const auto i = static_cast<size_t>(corner);
    const std::uint32_t other = triangles_[triangle].neighbours[i];
    const auto j = static_cast<size_t>(cornerTowards(other, triangle));
    const Corners one = triangles_[triangle];
    const Corners two = triangles_[other];
    const std::uint32_t p = one.vertices[i];
    const std::uint32_t a = one.vertices[after(i)];
    const std::uint32_t b = one.vertices[before(i)];
    const std::uint32_t q = two.vertices[j];
    const bool fixed = one.fixed[i];
    const auto third = static_cast<std::uint32_t>(triangles_.size());
    const std::uint32_t fourth = third + 1;
    // p a vertex, p vertex b; q b vertex, q vertex a.
    triangles_[triangle] = {{p, a, vertex},
                            {fourth, third, one.neighbours[before(i)]},
                            {fixed, false, one.fixed[before(i)]},
                            one.inside};
    triangles_.push_back({{p, vertex, b},
                          {other, one.neighbours[after(i)], triangle},
                          {fixed, one.fixed[after(i)], false},
                          one.inside});
    triangles_[other] = {{q, b, vertex},
                         {third, fourth, two.neighbours[before(j)]},
                         {fixed, false, two.fixed[before(j)]},
                         two.inside};
    triangles_.push_back({{q, vertex, a},
                          {triangle, two.neighbours[after(j)], other},
                          {fixed, two.fixed[after(j)], false},
                          two.inside});
    redirect(one.neighbours[after(i)], triangle, third);
    redirect(two.neighbours[after(j)], other, fourth);
    triangleOf_[a] = triangleOf_[p] = triangleOf_[vertex] = triangle;
    triangleOf_[b] = triangleOf_[q] = other;
}

void PlaneTriangulation::flip(std::uint32_t triangle, int corner)
{
    const auto i = static_cast<size_t>(corner);
    const std::uint32_t other = triangles_[triangle].neighbours[i];
    const auto j = static_cast<size_t>(cornerTowards(other, triangle));
    const Corners one = triangles_[triangle];
    const Corners two = triangles_[other];
    const std::uint32_t p = one.vertices[i];
    const std::uint32_t a = one.vertices[after(i)];
    const std::uint32_t b = one.vertices[before(i)];
    const std::uint32_t q = two.vertices[j];
    triangles_[triangle] = {{p, a, q},
                            {two.neighbours[after(j)], other, one.neighbours[before(i)]},
                            {two.fixed[after(j)], false, one.fixed[before(i)]},
                            one.inside};
    triangles_[other] = {{p, q, b},
                         {two.neighbours[before(j)], one.neighbours[after(i)], triangle},
                         {two.fixed[before(j)], one.fixed[after(i)], false},
                         one.inside};
    redirect(two.neighbours[after(j)], other, triangle);
    redirect(one.neighbours[after(i)], triangle, other);
    triangleOf_[p] = triangleOf_[a] = triangleOf_[q] = triangle;
    triangleOf_[b] = other;
}

bool PlaneTriangulation::isConvex(std::uint32_t triangle, int corner) const
{
    const auto i = static_cast<size_t>(corner);
    const Corners& one = triangles_[triangle];
    const std::uint32_t other = one.neighbours[i];
    const std::uint32_t q = triangles_[other].vertices[static_cast<size_t>(cornerTowards(other, triangle))];
    const std::uint32_t p = one.vertices[i];
    return turn(p, one.vertices[after(i)], places_[q]) > 0 &&
           turn(q, one.vertices[before(i)], places_[p]) > 0;
}

void PlaneTriangulation::legalize(std::vector<EdgeAt> edges)
{
    while (!edges.empty()) {
        const EdgeAt edge = edges.back();
        edges.pop_back();
        const auto i = static_cast<size_t>(edge.corner);
        const Corners& one = triangles_[edge.triangle];
        const std::uint32_t other = one.neighbours[i];
        if (other == kNone || one.fixed[i])
            continue;
        const auto j = static_cast<size_t>(cornerTowards(other, edge.triangle));
        const auto& v = one.vertices;
        const std::uint32_t far = triangles_[other].vertices[j];
        if (!inCircle(places_[v[0]], places_[v[1]], places_[v[2]], places_[far]) ||
            !isConvex(edge.triangle, edge.corner))
            continue;
        flip(edge.triangle, edge.corner);
        // All four sides of the two triangles may have changed.
        edges.insert(edges.end(), {{edge.triangle, 0}, {edge.triangle, 2}, {other, 0}, {other, 1}});
    }
}

std::optional<std::uint32_t> PlaneTriangulation::splitEdge(std::uint32_t triangle, int corner,
                                                           const GridPlace& place)
{
    const auto i = static_cast<size_t>(corner);
    const Corners& one = triangles_[triangle];
    const std::uint32_t other = one.neighbours[i];
    if (other == kNone)
        return std::nullopt;
    const std::uint32_t q = triangles_[other].vertices[static_cast<size_t>(cornerTowards(other, triangle))];
    const std::uint32_t p = one.vertices[i];
    const std::uint32_t a = one.vertices[after(i)];
    const std::uint32_t b = one.vertices[before(i)];
    if (turn(p, a, place) <= 0 || turn(b, p, place) <= 0 || turn(q, b, place) <= 0 || turn(a, q, place) <= 0)
        return std::nullopt;
    const auto vertex = static_cast<std::uint32_t>(places_.size());
    places_.push_back(place);
    triangleOf_.push_back(triangle);
    splitAt(triangle, corner, vertex);
    return vertex;
}

}  // namespace knotspan
