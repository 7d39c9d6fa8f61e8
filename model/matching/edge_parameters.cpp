#include "model/matching/edge_parameters.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"

namespace knotspan {

namespace {

Vec3 pointAt(const PlacedSurface& placed, Side side, double t)
{
    const KnotVector& u = placed.surface->knotsU();
    const KnotVector& v = placed.surface->knotsV();
    const Vec2 at = side == Side::startU ? Vec2(u.domainStart(), t)
                    : side == Side::endU ? Vec2(u.domainEnd(), t)
                                         : Vec2(t, side == Side::startV ? v.domainStart() : v.domainEnd());
    return transformed(evaluate(*placed.surface, at.x, at.y).position, placed.transform);
}

bool isNoLonger(const PlacedSurface& placed, Side side, double from, double to, double gap)
{
    const KnotVector& along = knotsAlong(*placed.surface, side);
    if (to - from <= kSameKnot * (along.domainEnd() - along.domainStart()))
        return true;
    constexpr int kChords = 16;
    double length = 0;
    Vec3 last = pointAt(placed, side, from);
    for (int k = 1; k <= kChords && length <= gap; ++k) {
        const Vec3 next = pointAt(placed, side, std::lerp(from, to, static_cast<double>(k) / kChords));
        length += glm::distance(last, next);
        last = next;
    }
    return length <= gap;
}

}  // namespace

const KnotVector& knotsAlong(const NurbsSurface& surface, Side side)
{
    return side == Side::startU || side == Side::endU ? surface.knotsV() : surface.knotsU();
}

EdgePart upToNearEnds(const PlacedSurface& placed, EdgePart part, double gap)
{
    const KnotVector& along = knotsAlong(*placed.surface, part.side);
    if (isNoLonger(placed, part.side, along.domainStart(), part.from, gap))
        part.from = along.domainStart();
    if (isNoLonger(placed, part.side, part.to, along.domainEnd(), gap))
        part.to = along.domainEnd();
    return part;
}

bool isWholeSide(const NurbsSurface& surface, const EdgePart& part)
{
    const KnotVector& along = knotsAlong(surface, part.side);
    return part.from == along.domainStart() && part.to == along.domainEnd();
}

}  // namespace knotspan
