#include "model/mesh/quad_triangles.h"

namespace knotspan {

void QuadTriangles::add(const MeshVertices& vertices, std::uint32_t surface, std::uint32_t a, std::uint32_t b,
                        std::uint32_t ksquad, bool rising)
{
    for (const Side side : {Side::startU, Side::endU, Side::startV, Side::endV})
        vertices.side(surface, a, b, side, sides_[static_cast<size_t>(side)]);
    const Grid& grid = vertices.grid(ksquad);
    if (grid.u < 2 || grid.v < 2) {
        addBand(grid);
        return;
    }
    addInside(grid, vertices.inside(ksquad), rising);
    addRing(grid, vertices.inside(ksquad));
}

void QuadTriangles::addTriangle(const Corner& a, const Corner& b, const Corner& c)
{
    if (a.vertex == b.vertex || b.vertex == c.vertex || c.vertex == a.vertex)
        return;
    triangles_.push_back({a.vertex, b.vertex, c.vertex});
    parameters_.push_back({a.t, b.t, c.t});
}

void QuadTriangles::addInside(const Grid& grid, std::uint32_t first, bool rising)
{
    const auto corner = [&](int i, int j) {
        return Corner{first + static_cast<std::uint32_t>((i - 1) * (grid.v - 1) + j - 1),
                      {double(i) / grid.u, double(j) / grid.v},
                      0};
    };
    for (int i = 1; i + 1 < grid.u; ++i)
        for (int j = 1; j + 1 < grid.v; ++j) {
            const Corner low = corner(i, j);
            const Corner right = corner(i + 1, j);
            const Corner up = corner(i, j + 1);
            const Corner high = corner(i + 1, j + 1);
            addTriangle(low, right, rising ? high : up);
            addTriangle(rising ? low : right, high, up);
        }
}

QuadTriangles::Chain QuadTriangles::chainAlong(Side side, bool backwards) const
{
    const auto& points = sides_[static_cast<size_t>(side)];
    const bool alongV = side == Side::startU || side == Side::endU;
    const double across = side == Side::endU || side == Side::endV ? 1 : 0;
    Chain chain;
    chain.reserve(points.size());
    for (size_t k = 0; k < points.size(); ++k) {
        const auto& point = points[backwards ? points.size() - 1 - k : k];
        chain.push_back({point.vertex, alongV ? Vec2{across, point.t} : Vec2{point.t, across},
                         backwards ? 1 - point.t : point.t});
    }
    return chain;
}

void QuadTriangles::addRing(const Grid& grid, std::uint32_t first)
{
    struct Section {
        Side side;
        bool backwards;
    };
    for (const Section& section : {Section{Side::startV, false}, Section{Side::endU, false},
                                   Section{Side::endV, true}, Section{Side::startU, true}}) {
        const bool alongU = section.side == Side::startV || section.side == Side::endV;
        const int steps = alongU ? grid.u : grid.v;
        Chain inner;
        for (int k = 1; k < steps; ++k) {
            const int along = section.backwards ? steps - k : k;
            const int i = alongU ? along : (section.side == Side::endU ? grid.u - 1 : 1);
            const int j = alongU ? (section.side == Side::endV ? grid.v - 1 : 1) : along;
            inner.push_back({first + static_cast<std::uint32_t>((i - 1) * (grid.v - 1) + j - 1),
                             {double(i) / grid.u, double(j) / grid.v},
                             double(k) / steps});
        }
        zip(chainAlong(section.side, section.backwards), inner, true);
    }
}

// A grid of one cell in some direction has no vertices inside. One chain goes along the long side at the
// start, then across the end; the other across the start, then along the other long side. What lies across is
// as far as where it is.
void QuadTriangles::addBand(const Grid& grid)
{
    const bool alongV = grid.u == 1;
    Chain outer = chainAlong(alongV ? Side::startU : Side::startV, false);
    Chain acrossEnd = chainAlong(alongV ? Side::endV : Side::endU, false);
    Chain inner = chainAlong(alongV ? Side::startV : Side::startU, false);
    const Chain other = chainAlong(alongV ? Side::endU : Side::endV, false);
    for (Corner& corner : acrossEnd)
        corner.position = 1;
    for (Corner& corner : inner)
        corner.position = 0;
    // The common corners: the outer chain has the first, the inner one the last.
    outer.insert(outer.end(), acrossEnd.begin() + 1, acrossEnd.end() - 1);
    inner.erase(inner.begin());
    inner.insert(inner.end(), other.begin() + 1, other.end());
    zip(outer, inner, !alongV);
}

void QuadTriangles::zip(const Chain& outer, const Chain& inner, bool left)
{
    size_t o = 0;
    size_t i = 0;
    const auto add = [&](const Corner& a, const Corner& b, const Corner& c) {
        left ? addTriangle(a, b, c) : addTriangle(b, a, c);
    };
    while (o + 1 < outer.size() || i + 1 < inner.size()) {
        // A band's first triangle is that of the common corner.
        const bool stepsOuter = o + 1 < outer.size() &&
                                (i + 1 == inner.size() || outer[o + 1].position <= inner[i + 1].position ||
                                 (o == 0 && i == 0 && inner.front().position == 0));
        if (stepsOuter) {
            add(outer[o], outer[o + 1], inner[i]);
            ++o;
        } else {
            add(outer[o], inner[i + 1], inner[i]);
            ++i;
        }
    }
}

}  // namespace knotspan
