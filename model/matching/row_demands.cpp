#include "model/matching/row_demands.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/core/check.h"
#include "model/matching/edge_first.h"

namespace knotspan {

std::vector<RowSample> tangentDemands(const NurbsSurface& surface, const TargetFrames& target,
                                      const std::vector<double>& parameters)
{
    const KnotVector& along = surface.knotsV();
    const std::vector<ControlPoint> edge = rowOf(surface, 0);
    const std::vector<ControlPoint> row = rowOf(surface, 1);
    std::vector<RowSample> samples;
    for (const double v : parameters) {
        const EdgeFrame frame = target.at(v);
        const Vec3 chord = rowPoint(along, row, v).position - rowPoint(along, edge, v).position;
        samples.push_back(
            {v, frame.normal, -glm::dot(chord, frame.normal), std::abs(glm::dot(chord, frame.across))});
    }
    return samples;
}

// With X_k(v) the curve of row k and w_k its weight, the homogeneous surface at the edge has X_uu = c_0 w_0
// X_0 + c_1 w_1 X_1 + c_2 w_2 X_2 with c_0 + c_1 + c_2 = 0, and w_0 x_uu = X_uu - w_uu x - 2 w_u x_u with x =
// X_0.
std::vector<RowSample> curvatureDemands(const NurbsSurface& surface, const TargetFrames& target,
                                        const std::vector<double>& parameters)
{
    const int p = surface.degreeU();
    check(p >= 2, "a curvature across takes at least degree 2");
    const KnotVector& across = surface.knotsU();
    const double first = p / (across[p + 1] - across[1]);
    const double next = p / (across[p + 2] - across[2]);
    const double second = (p - 1) / (across[p + 1] - across[2]);
    const double c1 = -second * (first + next);
    const double c2 = second * next;

    const KnotVector& along = surface.knotsV();
    const std::vector<ControlPoint> rows[3] = {rowOf(surface, 0), rowOf(surface, 1), rowOf(surface, 2)};
    std::vector<RowSample> samples;
    for (const double v : parameters) {
        const EdgeFrame frame = target.at(v);
        const ControlPoint x = rowPoint(along, rows[0], v);
        const ControlPoint x1 = rowPoint(along, rows[1], v);
        const ControlPoint x2 = rowPoint(along, rows[2], v);
        const Vec3 tangent = first * x1.weight / x.weight * (x1.position - x.position);
        const double skew = glm::dot(tangent, frame.along);
        const double width = glm::dot(tangent, frame.across);
        // What row 1 and the edge say already is the surface's own; only the curvature across is asked for.
        const EdgeFrame own = frameInto(surface, v);
        const double form = skew * skew * own.alongAlong + 2 * skew * width * own.alongAcross +
                            width * width * frame.acrossAcross;
        const double present = c1 * x1.weight * glm::dot(x1.position - x.position, frame.normal) +
                               c2 * x2.weight * glm::dot(x2.position - x.position, frame.normal) -
                               2 * first * (x1.weight - x.weight) * glm::dot(tangent, frame.normal);
        const double lever = c2 * x2.weight;
        samples.push_back(
            {v, frame.normal, (x.weight * form - present) / lever, x.weight * width * width / lever});
    }
    return samples;
}

}  // namespace knotspan
