// Constrained Delaunay triangulation of places with whole-number coordinates: every question has an exact
// answer in 128 bits, so nothing is ever decided by rounding.
//
// Places go in one by one, edges that must be there after those. Lawson's flips keep it Delaunay but for such
// edges; an edge is made by flipping what crosses it (Sloan, A fast algorithm for generating constrained
// Delaunay triangulations, Computers and Structures 47, 1993).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace knotspan {

struct GridPlace {
    std::int64_t x = 0;
    std::int64_t y = 0;
    [[nodiscard]] bool operator==(const GridPlace&) const = default;
};

class PlaneTriangulation {
public:
    static constexpr std::int64_t kMost = std::int64_t{1} << 28;  // of a coordinate, which begin at 0
    static constexpr std::uint32_t kCorners = 4;  // vertices 0 to 3 are those of a square around everything
    static constexpr std::uint32_t kNone = 0xffffffffU;

    struct Corners {
        std::array<std::uint32_t, 3> vertices{};    // counter-clockwise
        std::array<std::uint32_t, 3> neighbours{};  // opposite each vertex
        std::array<bool, 3> fixed{};                // the edges opposite
        bool inside = false;
    };

    PlaneTriangulation();

    // The vertex there, which may be one that was there before.
    std::uint32_t add(const GridPlace& place);
    // The same unless the place is in a triangle that is not inside, or on a fixed edge.
    std::optional<std::uint32_t> addInside(const GridPlace& place);
    // A new vertex on the edge opposite corner `corner` of a triangle; nothing is flipped. A fixed edge
    // becomes two. Nothing where rounding would leave no triangle at one of its sides.
    std::optional<std::uint32_t> splitEdge(std::uint32_t triangle, int corner, const GridPlace& place);

    // What is in the way of an edge.
    struct Obstacle {
        std::uint32_t from = kNone;  // a fixed edge that crosses; from == to: a vertex on it
        std::uint32_t to = kNone;
    };
    // Fixes the edge between two vertices; or says why not, and changes nothing.
    std::optional<Obstacle> connect(std::uint32_t from, std::uint32_t to);
    // Whether the edge leaves its first end within a triangle that is inside, or along one's side.
    [[nodiscard]] bool startsInside(std::uint32_t from, std::uint32_t to) const;

    // `isBorder(from, to)`, of fixed edges: whether inside and outside change there. Outside begins beyond.
    template <class IsBorder>
    void markInside(const IsBorder& isBorder)
    {
        std::vector<char> seen(triangles_.size(), 0);
        std::vector<std::uint32_t> open{triangleOf_[0]};
        seen[triangleOf_[0]] = 1;
        triangles_[triangleOf_[0]].inside = false;
        while (!open.empty()) {
            const Corners at = triangles_[open.back()];
            open.pop_back();
            for (size_t k = 0; k < 3; ++k) {
                const std::uint32_t next = at.neighbours[k];
                if (next == kNone || seen[next] != 0)
                    continue;
                seen[next] = 1;
                const bool changes =
                    at.fixed[k] && isBorder(at.vertices[(k + 1) % 3], at.vertices[(k + 2) % 3]);
                triangles_[next].inside = at.inside != changes;
                open.push_back(next);
            }
        }
    }

    // Where edges that must be there are not: `isInside(corners)` says it.
    template <class IsInside>
    void markEach(const IsInside& isInside)
    {
        for (Corners& triangle : triangles_)
            triangle.inside = isInside(triangle);
    }

    [[nodiscard]] const std::vector<Corners>& triangles() const { return triangles_; }
    [[nodiscard]] const std::vector<GridPlace>& places() const { return places_; }
    // The triangle with that edge counter-clockwise, and the corner opposite to it.
    struct EdgeAt {
        std::uint32_t triangle = kNone;
        int corner = 0;
    };
    [[nodiscard]] EdgeAt find(std::uint32_t from, std::uint32_t to) const;

private:
    struct Location {
        std::uint32_t triangle = 0;
        int onEdge = -1;    // opposite that corner
        int onVertex = -1;  // that corner
    };
    [[nodiscard]] Location locate(const GridPlace& place);
    std::uint32_t addAt(const Location& location, const GridPlace& place);
    void splitTriangle(std::uint32_t triangle, std::uint32_t vertex);
    void splitAt(std::uint32_t triangle, int corner, std::uint32_t vertex);
    void flip(std::uint32_t triangle, int corner);
    void legalize(std::vector<EdgeAt> edges);
    void redirect(std::uint32_t triangle, std::uint32_t from, std::uint32_t to);
    [[nodiscard]] int cornerTowards(std::uint32_t triangle, std::uint32_t neighbour) const;
    [[nodiscard]] bool isConvex(std::uint32_t triangle, int corner) const;
    [[nodiscard]] int turn(std::uint32_t a, std::uint32_t b, const GridPlace& c) const;
    [[nodiscard]] EdgeAt firstCrossed(std::uint32_t from, std::uint32_t to) const;
    void fix(std::uint32_t from, std::uint32_t to);

    std::vector<GridPlace> places_;
    std::vector<Corners> triangles_;
    std::vector<std::uint32_t> triangleOf_;  // one of those around each vertex
    std::uint32_t last_ = 0;                 // where the last search ended
};

}  // namespace knotspan
