#include "model/geometry/evaluation.h"

#include <algorithm>
#include <cmath>

#include "model/geometry/local_net.h"

namespace knotspan {

namespace {

bool isFinite(const Vec3& vector)
{
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

Vec3 inRange(const Vec3& derivative)
{
    return isFinite(derivative) ? derivative : Vec3(0);
}

}  // namespace

SurfacePoint evaluate(const NurbsSurface& surface, double u, double v)
{
    const LocalNet net(surface, surface.knotsU().inDomain(u), surface.knotsV().inDomain(v));
    const Vec4 first = net.sum(0, 0, Vec3(0));
    const Vec3 point = Vec3(first) / first.w;

    // The NURBS Book, A4.4, written out for the second order. Relative to the point itself, S is only what
    // rounding left of it, and its products with the weights' derivatives take nothing away from the sums.
    const Vec4 a00 = net.sum(0, 0, point);
    const Vec4 a10 = net.sum(1, 0, point) / a00.w;
    const Vec4 a01 = net.sum(0, 1, point) / a00.w;
    const Vec4 a20 = net.sum(2, 0, point) / a00.w;
    const Vec4 a11 = net.sum(1, 1, point) / a00.w;
    const Vec4 a02 = net.sum(0, 2, point) / a00.w;
    const Vec3 s = Vec3(a00) / a00.w;
    const Vec3 du = Vec3(a10) - a10.w * s;
    const Vec3 dv = Vec3(a01) - a01.w * s;
    const double grow = 1 / net.shrinking();
    SurfacePoint result;
    result.position = (net.heaviest() + point) * grow;
    result.du = inRange(du * grow);
    result.dv = inRange(dv * grow);
    result.duu = inRange((Vec3(a20) - 2.0 * a10.w * du - a20.w * s) * grow);
    result.duv = inRange((Vec3(a11) - a10.w * dv - a01.w * du - a11.w * s) * grow);
    result.dvv = inRange((Vec3(a02) - 2.0 * a01.w * dv - a02.w * s) * grow);
    return result;
}

}  // namespace knotspan
