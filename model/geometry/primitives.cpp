#include "model/geometry/primitives.h"

#include <array>
#include <cmath>

#include "model/core/check.h"

namespace knotspan {

namespace {

struct ArcPoint {
    double x;
    double y;
    double weight;
};

// The control points of the unit circle from angle 0 on. The NURBS Book, 7.5: the middle point of an arc
// stands where its end tangents meet and weighs the cosine of half the arc's angle. Mirror images are equal
// to the bit.
const std::array<ArcPoint, 17>& circle()
{
    static const std::array<ArcPoint, 17> points = [] {
        const double t = std::sqrt(2.0) - 1;  // tan 22.5 degrees
        const double c = 1 / std::sqrt(1 + t * t);
        const double h = std::sqrt(0.5);
        return std::array<ArcPoint, 17>{{{1, 0, 1},
                                         {1, t, c},
                                         {h, h, 1},
                                         {t, 1, c},
                                         {0, 1, 1},
                                         {-t, 1, c},
                                         {-h, h, 1},
                                         {-1, t, c},
                                         {-1, 0, 1},
                                         {-1, -t, c},
                                         {-h, -h, 1},
                                         {-t, -1, c},
                                         {0, -1, 1},
                                         {t, -1, c},
                                         {h, -h, 1},
                                         {1, -t, c},
                                         {1, 0, 1}}};
    }();
    return points;
}

KnotVector arcKnots(int arcs)
{
    std::vector<double> knots{0, 0, 0};
    for (int i = 1; i < arcs; ++i)
        knots.insert(knots.end(), 2, i);
    knots.insert(knots.end(), 3, arcs);
    auto result = KnotVector::create(2, std::move(knots));
    check(result.has_value(), "the knots of arcs are valid");
    return *std::move(result);
}

// The profile (distance from the axis, height) turned round the z axis. The NURBS Book, A8.1.
NurbsSurface turned(const Vec3& centre, const std::vector<ArcPoint>& profile, KnotVector profileKnots)
{
    std::vector<ControlPoint> points;
    for (const ArcPoint& around : circle())
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
    std::vector<ArcPoint> profile;
    for (size_t k = 0; k <= 8; ++k) {
        // The half from -90 to 90 degrees: 12 steps of 22.5 degrees after the circle's first point.
        const ArcPoint& point = circle()[(12 + k) % 16];
        profile.push_back({radius * point.x, radius * point.y, point.weight});
    }
    return turned(centre, profile, arcKnots(4));
}

NurbsSurface torus(const Vec3& centre, double major, double minor)
{
    check(minor > 0 && major > minor, "a torus has a hole");
    std::vector<ArcPoint> profile;
    for (const ArcPoint& point : circle())
        profile.push_back({major + minor * point.x, minor * point.y, point.weight});
    return turned(centre, profile, arcKnots(8));
}

NurbsSurface plane(const Vec3& corner, const Vec3& a, const Vec3& b)
{
    auto result = NurbsSurface::create(KnotVector::clampedUniform(1, 1), KnotVector::clampedUniform(1, 1),
                                       {{corner, 1}, {corner + b, 1}, {corner + a, 1}, {corner + a + b, 1}});
    check(result.has_value(), "a parallelogram is a surface");
    return *std::move(result);
}

}  // namespace knotspan
