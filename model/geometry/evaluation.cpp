#include "model/geometry/evaluation.h"

#include <algorithm>
#include <cmath>

#include "model/geometry/local_net.h"

namespace knotspan {

namespace {

double inDomain(const KnotVector& knots, double u)
{
    return u > knots.domainStart() ? std::min(u, knots.domainEnd()) : knots.domainStart();
}

}  // namespace

SurfacePoint evaluate(const NurbsSurface& surface, double u, double v)
{
    u = inDomain(surface.knotsU(), u);
    v = inDomain(surface.knotsV(), v);
    const LocalNet net = localNet(surface, u, v);
    const Vec3 origin = net.origin();

    // The NURBS Book, A4.4, written out for the second order.
    const Vec4 a00 = net.sum(0, 0, origin);
    const Vec4 a10 = net.sum(1, 0, origin) / a00.w;
    const Vec4 a01 = net.sum(0, 1, origin) / a00.w;
    const Vec4 a20 = net.sum(2, 0, origin) / a00.w;
    const Vec4 a11 = net.sum(1, 1, origin) / a00.w;
    const Vec4 a02 = net.sum(0, 2, origin) / a00.w;
    const Vec3 s = Vec3(a00) / a00.w;
    SurfacePoint result;
    result.position = origin + s;
    result.du = Vec3(a10) - a10.w * s;
    result.dv = Vec3(a01) - a01.w * s;
    result.duu = Vec3(a20) - 2.0 * a10.w * result.du - a20.w * s;
    result.duv = Vec3(a11) - a10.w * result.dv - a01.w * result.du - a11.w * s;
    result.dvv = Vec3(a02) - 2.0 * a01.w * result.dv - a02.w * s;
    return result;
}

}  // namespace knotspan
