#include "model/geometry/primitives.h"

#include "model/core/check.h"
#include "model/geometry/arcs.h"

namespace knotspan {

namespace {

// The profile (distance from the axis, height) turned round the z axis. The NURBS Book, A8.1.
NurbsSurface turned(const Vec3& centre, const std::vector<ArcPoint>& profile, KnotVector profileKnots)
{
    std::vector<ControlPoint> points;
    for (const ArcPoint& around : arcPoints(360))
        for (const ArcPoint& along : profile)
            points.push_back({centre + Vec3(along.x * around.x, along.x * around.y, along.y),
                              around.weight * along.weight});
    auto result = NurbsSurface::create(arcKnots(8), std::move(profileKnots), std::move(points));
    check(result.has_value(), "a turned profile is a surface");
    return *std::move(result);
}

}  // namespace

NurbsSurface sphere(const Vec3& centre, double radius)
{
    check(radius > 0, "a sphere has a radius");
    const std::vector<ArcPoint> circle = arcPoints(360);
    std::vector<ArcPoint> profile;
    for (size_t k = 0; k <= 8; ++k) {
        // The half from -90 to 90 degrees: 12 steps of 22.5 degrees after the circle's first point.
        const ArcPoint& point = circle[(12 + k) % 16];
        profile.push_back({radius * point.x, radius * point.y, point.weight});
    }
    return turned(centre, profile, arcKnots(4));
}

NurbsSurface torus(const Vec3& centre, double major, double minor)
{
    check(minor > 0 && major > minor, "a torus has a hole");
    std::vector<ArcPoint> profile;
    for (const ArcPoint& point : arcPoints(360))
        profile.push_back({major + minor * point.x, minor * point.y, point.weight});
    return turned(centre, profile, arcKnots(8));
}

NurbsSurface cylinder(const Vec3& base, double radius, double height)
{
    check(radius > 0 && height > 0, "a cylinder has a radius and a height");
    return turned(base, {{radius, 0, 1}, {radius, height, 1}}, KnotVector::clampedUniform(1, 1));
}

NurbsSurface cone(const Vec3& base, double radiusBelow, double radiusAbove, double height)
{
    check(radiusBelow >= 0 && radiusAbove >= 0 && height >= 0, "a cone's sizes are not negative");
    check(radiusBelow + radiusAbove > 0 && (height > 0 || radiusBelow != radiusAbove), "a cone has an area");
    return turned(base, {{radiusBelow, 0, 1}, {radiusAbove, height, 1}}, KnotVector::clampedUniform(1, 1));
}

NurbsSurface plane(const Vec3& corner, const Vec3& a, const Vec3& b)
{
    auto result = NurbsSurface::create(KnotVector::clampedUniform(1, 1), KnotVector::clampedUniform(1, 1),
                                       {{corner, 1}, {corner + b, 1}, {corner + a, 1}, {corner + a + b, 1}});
    check(result.has_value(), "a parallelogram is a surface");
    return *std::move(result);
}

}  // namespace knotspan
