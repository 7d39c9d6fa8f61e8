#include "tests/model/friends/meeting_samples.h"

#include <cmath>
#include <numbers>

#include "model/geometry/knot_insertion.h"
#include "model/samples/net.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

double radians(double degrees)
{
    return degrees * std::numbers::pi / 180;
}

KnotVector knotsWith(int degree, const std::vector<std::pair<double, int>>& inner)
{
    std::vector<double> values(static_cast<size_t>(degree + 1), 0.0);
    for (const auto& [knot, times] : inner)
        values.insert(values.end(), static_cast<size_t>(times), knot);
    values.insert(values.end(), static_cast<size_t>(degree + 1), 4.0);
    return KnotVector::create(degree, std::move(values)).value();
}

}  // namespace

MeetingPair splitSurface(std::mt19937& random, const SplitShape& shape)
{
    const KnotVector u = knotsWith(shape.degree, {{0.9, 1}, {2.1, shape.multiplicity}, {3.3, 1}});
    const KnotVector v = knotsWith(shape.degree, {{1.3, 1}, {2.2, 2}});
    const auto jitter = [&](double size) { return randomBetween(random, -size, size); };
    const NurbsSurface whole = surfaceOf(u, v, [&](int i, int j) -> ControlPoint {
        return {{i + jitter(0.25), j + jitter(0.25), jitter(0.7)},
                shape.rational ? randomBetween(random, 0.5, 2) : 1.0};
    });
    return {clampedPart(whole, Direction::U, 0, 2.1), clampedPart(whole, Direction::U, 2.1, 4)};
}

MeetingPair hinge(std::mt19937& random, const HingeShape& shape)
{
    const KnotVector along = knotsWith(3, {{1.7, 1}});
    const KnotVector across = KnotVector::clampedUniform(3, 1);
    const auto jitter = [&](double size) { return randomBetween(random, -size, size); };
    std::vector<Vec4> rows[2][4];
    for (int j = 0; j < along.controlPointCount(); ++j) {
        const double y = grevilleAbscissa(along, j);
        Vec4 first[4];
        Vec4 second[4];
        for (int i = 0; i < 4; ++i) {
            const bool inner = i < 3;
            const Vec3 place{i - 3 + (inner ? jitter(0.2) : 0), y + (inner ? jitter(0.2) : 0),
                             inner ? jitter(0.3) : 0};
            const double weight = shape.rational ? 1 + jitter(0.1) : 1;
            first[i] = Vec4(weight * place, weight);
            second[i] = Vec4(i + jitter(0.2), y + jitter(0.2), jitter(0.5), 1);
        }
        second[0] = first[3];
        if (shape.order >= 1)
            second[1] = 2.0 * first[3] - first[2];
        if (shape.order >= 2)
            second[2] = 4.0 * first[3] - 4.0 * first[2] + first[1];
        for (size_t i = 0; i < 4; ++i) {
            rows[0][i].push_back(first[i]);
            rows[1][i].push_back(second[i]);
        }
    }
    const double cosine = std::cos(radians(shape.turnDeg));
    const double sine = std::sin(radians(shape.turnDeg));
    const auto told = [&](int which) {
        return surfaceOf(across, along, [&](int i, int j) -> ControlPoint {
            const Vec4 point = rows[which][i][static_cast<size_t>(j)];
            const Vec3 at = Vec3(point) / point.w;
            if (which == 0)
                return {at, point.w};
            const Vec3 turned{cosine * at.x + sine * at.z, at.y, cosine * at.z - sine * at.x};
            return {turned + shape.away * Vec3(0.6, 0, 0.8), point.w};
        });
    };
    return {told(0), told(1)};
}

MeetingPair cones(double turnDeg, double away)
{
    const KnotVector quarter = KnotVector::clampedUniform(2, 1);
    const KnotVector line = KnotVector::clampedUniform(1, 1);
    const auto cone = [&](double radius, double slopeDeg, double length) {
        return surfaceOf(line, quarter, [&](int i, int j) -> ControlPoint {
            const double r = radius + i * length * std::cos(radians(slopeDeg));
            const double z = i * length * std::sin(radians(slopeDeg));
            return {{j < 2 ? r : 0, j > 0 ? r : 0, z}, j == 1 ? std::numbers::sqrt2 / 2 : 1};
        });
    };
    return {cone(2, 50, -1), cone(2 + away, 50 + turnDeg, 1)};
}

MeetingPair cylinders(double curvatureA, double curvatureB)
{
    const KnotVector arc = KnotVector::clampedUniform(2, 1);
    const KnotVector line = KnotVector::clampedUniform(1, 1);
    const auto cylinder = [&](double curvature, double side) {
        const double radius = 1 / curvature;
        const double half = std::atan(curvature / 2);  // the arc's control polygon is 1 long
        return surfaceOf(arc, line, [&](int i, int j) -> ControlPoint {
            const double x[] = {0, radius * std::tan(half), radius * std::sin(2 * half)};
            const double z = i == 2 ? radius * (1 - std::cos(2 * half)) : 0;
            return {{side * x[i], 3 * j, z}, i == 1 ? std::cos(half) : 1};
        });
    };
    return {cylinder(curvatureA, -1), cylinder(curvatureB, 1)};
}

}  // namespace knotspan::testing
