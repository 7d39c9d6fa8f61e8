#include "tests/model/matching/friend_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"

namespace knotspan::testing {

std::vector<PlacedSurface> FriendModel::placed() const
{
    std::vector<PlacedSurface> result;
    for (size_t k = 0; k < surfaces.size(); ++k)
        result.push_back({&surfaces[k], transform(k)});
    return result;
}

Vec3 FriendModel::pointAt(const PointMove& move) const
{
    return surfaces[move.surface].controlPoint(move.index.i, move.index.j).position;
}

void FriendModel::join(size_t a, Side sideA, size_t b, Side sideB)
{
    const auto whole = [&](size_t k, Side side) -> EdgePart {
        const KnotVector& along =
            side == Side::startU || side == Side::endU ? surfaces[k].knotsV() : surfaces[k].knotsU();
        return {static_cast<std::uint32_t>(k), side, along.domainStart(), along.domainEnd()};
    };
    FriendEdge edge;
    edge.a = whole(a, sideA);
    edge.b = whole(b, sideB);
    edge.continuity = Continuity::g1;
    edges.push_back(edge);
}

void FriendModel::findEdges()
{
    edges = Friends(placed()).edges();
}

void FriendModel::apply(const std::vector<PointMove>& moves)
{
    std::set<std::uint32_t> moved;
    for (const PointMove& move : moves)
        moved.insert(move.surface);
    for (const std::uint32_t k : moved)
        surfaces[k] = withMoves(surfaces[k], k, moves);
}

namespace {

SurfacePoint onEdge(const NurbsSurface& surface, const EdgePart& part, double t)
{
    const double u = part.side == Side::startU ? surface.knotsU().domainStart()
                     : part.side == Side::endU ? surface.knotsU().domainEnd()
                                               : t;
    const double v = part.side == Side::startV ? surface.knotsV().domainStart()
                     : part.side == Side::endV ? surface.knotsV().domainEnd()
                                               : t;
    return evaluate(surface, u, v);
}

}  // namespace

EdgeBreak breakOf(const FriendModel& model, const FriendEdge& edge)
{
    EdgeBreak worst;
    for (int k = 0; k <= 30; ++k) {
        const double part = k / 30.0;
        SurfacePoint at[2];
        Vec3 normals[2];
        Vec3 inward[2];
        int side = 0;
        for (const EdgePart& on : {edge.a, edge.b}) {
            const double share = side == 1 && edge.reversed ? 1 - part : part;
            at[side] = onEdge(model.surfaces[on.surface], on, std::lerp(on.from, on.to, share));
            const glm::dmat3 linear(model.transform(on.surface));
            at[side].position = transformed(at[side].position, model.transform(on.surface));
            const Vec3 du = linear * at[side].du;
            const Vec3 dv = linear * at[side].dv;
            normals[side] = glm::normalize(glm::cross(du, dv));
            const bool acrossU = on.side == Side::startU || on.side == Side::endU;
            const double sign = on.side == Side::startU || on.side == Side::startV ? 1 : -1;
            inward[side] = sign * glm::cross(acrossU ? du : dv, acrossU ? dv : du);
            at[side].du = acrossU ? dv : du;  // along
            ++side;
        }
        worst.gap = std::max(worst.gap, glm::length(at[0].position - at[1].position));
        const double sine = glm::length(glm::cross(normals[0], normals[1]));
        worst.angleDeg =
            std::max(worst.angleDeg,
                     std::atan2(sine, std::abs(glm::dot(normals[0], normals[1]))) * 180 / std::numbers::pi);
        // Both frames (into, along) have to turn opposite ways round the normal when `along` is the same.
        const double along = glm::dot(at[0].du, at[1].du) > 0 ? 1 : -1;
        worst.runsOn = worst.runsOn && along * glm::dot(inward[0], inward[1]) < 0;
    }
    return worst;
}

}  // namespace knotspan::testing
