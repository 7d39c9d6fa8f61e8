#include "model/geometry/local_net.h"

#include <cmath>

#include <glm/common.hpp>

namespace knotspan {

Vec3 LocalNet::origin() const
{
    const ControlPoint* heaviest = &point(0, 0);
    double most = -1;
    for (int i = 0; i <= surface.degreeU(); ++i)
        for (int j = 0; j <= surface.degreeV(); ++j)
            if (const double share = factor(0, 0, i, j) * point(i, j).weight; share > most) {
                most = share;
                heaviest = &point(i, j);
            }
    return heaviest->position;
}

Vec4 LocalNet::sum(int orderU, int orderV, const Vec3& from) const
{
    Vec4 result{0};
    for (int i = 0; i <= surface.degreeU(); ++i)
        for (int j = 0; j <= surface.degreeV(); ++j) {
            const ControlPoint& at = point(i, j);
            const double share = factor(orderU, orderV, i, j) * at.weight;
            result += Vec4(share * (at.position - from), share);
        }
    return result;
}

Vec4 LocalNet::sumOfSizes(int orderU, int orderV, const Vec3& from) const
{
    Vec4 result{0};
    for (int i = 0; i <= surface.degreeU(); ++i)
        for (int j = 0; j <= surface.degreeV(); ++j) {
            const ControlPoint& at = point(i, j);
            const double share = std::abs(factor(orderU, orderV, i, j)) * at.weight;
            result += Vec4(share * glm::abs(at.position - from), share);
        }
    return result;
}

LocalNet localNet(const NurbsSurface& surface, double u, double v)
{
    const KnotVector& knotsU = surface.knotsU();
    const KnotVector& knotsV = surface.knotsV();
    const int spanU = knotsU.findSpan(u);
    const int spanV = knotsV.findSpan(v);
    return {surface, spanU - knotsU.degree(), spanV - knotsV.degree(), basisDerivatives(knotsU, spanU, u),
            basisDerivatives(knotsV, spanV, v)};
}

}  // namespace knotspan
