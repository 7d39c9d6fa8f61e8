#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/geometry/local_net.h"

namespace knotspan {

namespace {

// Tangents closer to parallel than this (sine of their angle) count as parallel; control points closer than
// this part of their net as one.
constexpr double kVanishing = 1e-11;

// Also of vectors whose squares are beyond the range of double.
double length(const Vec3& vector)
{
    return std::hypot(vector.x, vector.y, vector.z);
}

std::optional<Vec3> unit(const Vec3& direction, double atLeast)
{
    const double size = length(direction);
    if (!std::isfinite(size) || !(size > atLeast))
        return std::nullopt;
    return direction / size;
}

// a x b normalised; nothing where the sine of their angle is at most `parallel`.
std::optional<Vec3> crossed(const Vec3& a, const Vec3& b, double parallel = kVanishing)
{
    const auto unitA = unit(a, 0);
    const auto unitB = unit(b, 0);
    if (!unitA || !unitB)
        return std::nullopt;
    return unit(glm::cross(*unitA, *unitB), parallel);
}

double middle(const KnotVector& knots)
{
    return knots.domainStart() + (knots.domainEnd() - knots.domainStart()) * 0.5;
}

double domainLength(const KnotVector& knots)
{
    return knots.domainEnd() - knots.domainStart();
}

// How short tangents are no more than the rounding of their sums, or than the noise of coordinates that a
// file gave for one and the same point.
struct Noise {
    double du;
    double dv;
};

Noise noiseAt(const NurbsSurface& surface, double u, double v)
{
    constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
    const LocalNet net(surface, u, v);
    const Vec4 first = net.sum(0, 0, Vec3(0));
    const Vec3 point = Vec3(first) / first.w;
    const auto rounding = [&](int orderU, int orderV) {
        return kRounding * length(Vec3(net.sumOfSizes(orderU, orderV, point)) / first.w) / net.shrinking();
    };
    Box box;
    double lightest = net.weight(0, 0);
    double heaviest = lightest;
    for (int i = 0; i <= surface.degreeU(); ++i)
        for (int j = 0; j <= surface.degreeV(); ++j) {
            box.add(net.position(i, j));
            lightest = std::min(lightest, net.weight(i, j));
            heaviest = std::max(heaviest, net.weight(i, j));
        }
    // Beside a much heavier point tangents are rightly short.
    const double sameness = kVanishing * length(box.size()) / net.shrinking() * (lightest / heaviest);
    return {std::max(rounding(1, 0), sameness / domainLength(surface.knotsU())),
            std::max(rounding(0, 1), sameness / domainLength(surface.knotsV()))};
}

// Where one tangent vanishes along a whole boundary (a collapsed row) the mixed derivative, taken inwards,
// tells how it grows again.
std::optional<Vec3> normalByMixedDerivative(const NurbsSurface& surface, double u, double v,
                                            const SurfacePoint& at, bool uVanishes, const Noise& noise)
{
    const bool inwardsIsUp = uVanishes ? v < middle(surface.knotsV()) : u < middle(surface.knotsU());
    const Vec3 growing = inwardsIsUp ? at.duv : -at.duv;
    const double vanishing =
        uVanishes ? noise.du / domainLength(surface.knotsV()) : noise.dv / domainLength(surface.knotsU());
    if (!unit(growing, vanishing))
        return std::nullopt;
    return uVanishes ? crossed(growing, at.dv) : crossed(at.du, growing);
}

// The limit of the normals on the way from the patch's middle to (u, v).
SurfaceNormal normalFromInside(const NurbsSurface& surface, double u, double v)
{
    const double towardsU = middle(surface.knotsU()) - u;
    const double towardsV = middle(surface.knotsV()) - v;
    SurfaceNormal result{{0, 0, 1}, true, false};
    std::optional<Vec3> before;
    for (int halvings = 1; halvings <= 26; ++halvings) {
        const double step = std::ldexp(1.0, -halvings);
        const SurfacePoint at = evaluate(surface, u + towardsU * step, v + towardsV * step);
        const auto normal = crossed(at.du, at.dv);
        if (!normal)
            continue;
        // Halving the step halves the distance from the limit, so twice the newer less the older is closer.
        const double change = before ? glm::length(*normal - *before) : 1.0;
        if (before && change < 0.5)
            result = {glm::normalize(2.0 * *normal - *before), true, change < 1e-2};
        else
            result = {*normal, true, false};
        // Closer still, rounding would outweigh what is left.
        if (change < 1e-6)
            break;
        before = normal;
    }
    return result;
}

}  // namespace

SurfaceNormal evaluateNormal(const NurbsSurface& surface, double u, double v)
{
    u = surface.knotsU().inDomain(u);
    v = surface.knotsV().inDomain(v);
    const SurfacePoint at = evaluate(surface, u, v);
    const Noise noise = noiseAt(surface, u, v);
    const bool hasU = unit(at.du, noise.du).has_value();
    const bool hasV = unit(at.dv, noise.dv).has_value();
    if (hasU && hasV) {
        const double angleNoise = noise.du / length(at.du) + noise.dv / length(at.dv);
        if (const auto normal = crossed(at.du, at.dv, angleNoise))
            return {*normal, false, true};
    }
    if (hasU != hasV)
        if (const auto normal = normalByMixedDerivative(surface, u, v, at, !hasU, noise))
            return {*normal, true, true};
    return normalFromInside(surface, u, v);
}

}  // namespace knotspan
