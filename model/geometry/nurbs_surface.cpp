#include "model/geometry/nurbs_surface.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "model/geometry/basis.h"

namespace knotspan {

namespace {

bool isFinite(const Vec3& point)
{
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

std::string named(size_t index, size_t countV)
{
    return "Control point (" + std::to_string(index / countV) + ", " + std::to_string(index % countV) + ")";
}

// The control points of a boundary curve: of u = start or end where `alongV`, else of v = start or end. The
// ends of a vector that is not clamped are no control points themselves.
std::vector<ControlPoint> boundary(const NurbsSurface& surface, bool alongV, bool atEnd)
{
    const KnotVector& across = alongV ? surface.knotsU() : surface.knotsV();
    const int span = atEnd ? across.spans().back() : across.spans().front();
    const BasisRow basis = basisOfDegrees(across, span, atEnd ? across.domainEnd() : across.domainStart())[0];
    const Vec3 origin = surface.controlPoint(0, 0).position;
    std::vector<ControlPoint> result(static_cast<size_t>(alongV ? surface.countV() : surface.countU()));
    for (size_t k = 0; k < result.size(); ++k) {
        Vec3 sum{0};
        double weight = 0;
        for (int r = 0; r <= across.degree(); ++r) {
            const int row = span - across.degree() + r;
            const int along = static_cast<int>(k);
            const ControlPoint& point =
                alongV ? surface.controlPoint(row, along) : surface.controlPoint(along, row);
            sum += basis[static_cast<size_t>(r)] * point.weight * (point.position - origin);
            weight += basis[static_cast<size_t>(r)] * point.weight;
        }
        result[k] = {origin + sum / weight, weight};
    }
    return result;
}

// One curve, where the points agree and the weights do up to one factor.
bool isClosed(const NurbsSurface& surface, bool alongV)
{
    const std::vector<ControlPoint> start = boundary(surface, alongV, false);
    const std::vector<ControlPoint> end = boundary(surface, alongV, true);
    const double near = 1e-9 * surface.bounds().diagonal();
    const double factor = end[0].weight / start[0].weight;
    for (size_t k = 0; k < start.size(); ++k)
        if (!(glm::length(end[k].position - start[k].position) <= near) ||
            !(std::abs(end[k].weight - factor * start[k].weight) <= 1e-9 * end[k].weight))
            return false;
    return true;
}

}  // namespace

Result<NurbsSurface> NurbsSurface::create(KnotVector knotsU, KnotVector knotsV,
                                          std::vector<ControlPoint> controlPoints)
{
    const auto countU = static_cast<size_t>(knotsU.controlPointCount());
    const auto countV = static_cast<size_t>(knotsV.controlPointCount());
    if (controlPoints.size() != countU * countV)
        return failure("The knots ask for " + std::to_string(countU) + " x " + std::to_string(countV) +
                       " = " + std::to_string(countU * countV) + " control points, but there are " +
                       std::to_string(controlPoints.size()));
    for (size_t k = 0; k < controlPoints.size(); ++k) {
        const ControlPoint& point = controlPoints[k];
        if (!isFinite(point.position))
            return failure(named(k, countV) + " has a coordinate that is not a finite number");
        if (!std::isfinite(point.weight))
            return failure(named(k, countV) + " has a weight that is not a finite number");
        if (!(point.weight > 0))
            return failure(named(k, countV) + " has a weight that is not above zero");
    }
    return NurbsSurface(std::move(knotsU), std::move(knotsV), std::move(controlPoints));
}

NurbsSurface::NurbsSurface(KnotVector knotsU, KnotVector knotsV, std::vector<ControlPoint> controlPoints)
    : knotsU_(std::move(knotsU)),
      knotsV_(std::move(knotsV)),
      controlPoints_(std::move(controlPoints))
{
    for (const ControlPoint& point : controlPoints_) {
        bounds_.add(point.position);
        rational_ = rational_ || point.weight != controlPoints_.front().weight;
    }
}

bool NurbsSurface::isClosedU() const
{
    return isClosed(*this, true);
}

bool NurbsSurface::isClosedV() const
{
    return isClosed(*this, false);
}

}  // namespace knotspan
