// Measures at places against closed forms: sphere, ellipsoid, cylinder, torus, plane, saddle.
#include "model/analysis/place_measures.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "model/geometry/primitives.h"

namespace knotspan {
namespace {

Mat4 scaled(const Vec3& by, const Vec3& moved = Vec3(0))
{
    Mat4 matrix(1.0);
    for (int axis = 0; axis < 3; ++axis)
        matrix[axis][axis] = by[axis];
    matrix[3] = Vec4(moved, 1);
    return matrix;
}

// z = x y over [-2, 2]^2.
NurbsSurface saddle()
{
    const KnotVector knots = KnotVector::clampedUniform(1, 1);
    return NurbsSurface::create(knots, knots, {{{-2, -2, 4}}, {{-2, 2, -4}}, {{2, -2, -4}}, {{2, 2, 4}}})
        .value();
}

void expectAlong(const Vec3& direction, const Vec3& line)
{
    EXPECT_NEAR(std::abs(glm::dot(direction, glm::normalize(line))), 1, 1e-12);
}

TEST(PlaceMeasures, OfAScaledSphereAreThoseOfTheLargerOne)
{
    const NurbsSurface ball = sphere({1, 2, 3}, 4);
    const Vec3 centre(13, 6, 8);
    for (const double v : {0.0, 0.4, 2.0, 3.3, 4.0}) {
        const PlaceMeasures at = measuresAt(ball, scaled(Vec3(3), {10, 0, -1}), 1.7, v);
        EXPECT_NEAR(glm::distance(at.position, centre), 12, 1e-12);
        ASSERT_TRUE(at.normal);
        EXPECT_LT(glm::distance(*at.normal, (at.position - centre) / 12.0), 1e-12);
        EXPECT_FALSE(at.directions) << "every place is an umbilic";
        if (v == 0 || v == 4) {
            EXPECT_FALSE(at.curvature) << "its tangents vanish at a pole";
            continue;
        }
        ASSERT_TRUE(at.curvature);
        EXPECT_NEAR(at.curvature->gauss, 1 / 144.0, 1e-13);
        EXPECT_NEAR(at.curvature->mean, -1 / 12.0, 1e-13);
    }
}

TEST(PlaceMeasures, OfASphereScaledUnevenlyAreAnEllipsoids)
{
    const Vec3 half(2, 3, 5);
    for (const double mirror : {1.0, -1.0})
        for (const double u : {0.3, 2.9, 6.1}) {
            const PlaceMeasures at =
                measuresAt(sphere(Vec3(0), 1), scaled({half.x * mirror, half.y, half.z}), u, 1.3);
            const Vec3 gradient = at.position / (half * half);
            const double squares = glm::dot(gradient, gradient);
            ASSERT_TRUE(at.curvature && at.normal && at.directions);
            EXPECT_LT(glm::distance(*at.normal, glm::normalize(gradient)), 1e-12) << "out of the body";
            // Gauss 1 / ((abc)^2 (x^2/a^4 + ...)^2), and twice the mean as the divergence of the normal.
            EXPECT_NEAR(at.curvature->gauss, 1 / (900 * squares * squares), 1e-12);
            const double r2 = glm::dot(at.position, at.position);
            EXPECT_NEAR(at.curvature->mean, -(38 - r2) / (2 * 900 * std::pow(squares, 1.5)), 1e-12);
            EXPECT_NEAR(glm::dot(at.directions->largest, *at.normal), 0, 1e-12);
            EXPECT_NEAR(glm::dot(at.directions->largest, at.directions->smallest), 0, 1e-12);
        }
}

TEST(PlaceMeasures, OfACylinderBendAroundAndNotAlong)
{
    const NurbsSurface tube = cylinder({0, 0, 1}, 4, 7);
    for (const double u : {0.0, 0.6, 3.5, 8.0}) {
        const PlaceMeasures at = measuresAt(tube, Mat4(1), u, 0.3);
        ASSERT_TRUE(at.curvature && at.directions);
        EXPECT_NEAR(at.curvature->largest, 0, 1e-14);
        EXPECT_NEAR(at.curvature->smallest, -0.25, 1e-14);
        expectAlong(at.directions->largest, {0, 0, 1});
        expectAlong(at.directions->smallest, {-at.position.y, at.position.x, 0});
    }
    // Looked at in a mirror it is the same cylinder with its front outside.
    const PlaceMeasures mirrored = measuresAt(tube, scaled({-1, 1, 1}), 0.6, 0.3);
    EXPECT_NEAR(mirrored.curvature->smallest, -0.25, 1e-14);
    expectAlong(mirrored.directions->largest, {0, 0, 1});
    EXPECT_GT(glm::dot(*mirrored.normal, {mirrored.position.x, mirrored.position.y, 0}), 3.9);
}

TEST(PlaceMeasures, OfATorusBendAlongItsTwoCircles)
{
    for (const double v : {0.0, 0.7, 2.5, 4.0, 6.6}) {
        const PlaceMeasures at = measuresAt(torus(Vec3(0), 5, 2), Mat4(1), 1.2, v);
        const double away = std::hypot(at.position.x, at.position.y);
        ASSERT_TRUE(at.curvature && at.directions);
        EXPECT_NEAR(at.curvature->smallest, -0.5, 1e-13);
        EXPECT_NEAR(at.curvature->largest, -(away - 5) / (2 * away), 1e-13);
        expectAlong(at.directions->largest, {-at.position.y, at.position.x, 0});
    }
}

TEST(PlaceMeasures, OfAPlaneAreFlatWithoutPrincipalDirections)
{
    const PlaceMeasures at = measuresAt(plane({1, 1, 1}, {2, 0, 0}, {1, 3, 0}), Mat4(1), 0.25, 0.5);
    EXPECT_EQ(at.position, Vec3(2, 2.5, 1));
    EXPECT_EQ(at.normal.value(), Vec3(0, 0, 1));
    ASSERT_TRUE(at.curvature);
    EXPECT_EQ(at.curvature->gauss, 0);
    EXPECT_EQ(at.curvature->largest, 0);
    EXPECT_FALSE(at.directions);
}

TEST(PlaceMeasures, OfASaddleBendBothWays)
{
    for (const double u : {0.1, 0.5, 0.8})
        for (const double v : {0.2, 0.5, 0.9}) {
            const PlaceMeasures at = measuresAt(saddle(), Mat4(1), u, v);
            const double x = at.position.x;
            const double y = at.position.y;
            EXPECT_NEAR(at.position.z, x * y, 1e-14);
            const double w = 1 + x * x + y * y;
            ASSERT_TRUE(at.curvature);
            EXPECT_NEAR(at.curvature->gauss, -1 / (w * w), 1e-13);
            EXPECT_NEAR(at.curvature->mean, -x * y / std::pow(w, 1.5), 1e-13);
        }
    const PlaceMeasures middle = measuresAt(saddle(), Mat4(1), 0.5, 0.5);
    EXPECT_NEAR(middle.curvature->largest, 1, 1e-14);
    EXPECT_NEAR(middle.curvature->smallest, -1, 1e-14);
    expectAlong(middle.directions->largest, {1, 1, 0});
    expectAlong(middle.directions->smallest, {1, -1, 0});
}

TEST(Separation, IsTheStraightLineAndTheAngleBetweenNormals)
{
    const NurbsSurface tube = cylinder(Vec3(0), 3, 4);
    const PlaceMeasures a = measuresAt(tube, Mat4(1), 0, 0);
    const PlaceMeasures b = measuresAt(tube, Mat4(1), 2, 1);  // a quarter round
    const Separation between = separation(a, b);
    EXPECT_LT(glm::distance(between.difference, {-3, 3, 4}), 1e-13);
    EXPECT_NEAR(between.distance, std::sqrt(34.0), 1e-13);
    EXPECT_NEAR(between.normalsDeg.value(), 90, 1e-12);
    EXPECT_NEAR(separation(a, measuresAt(tube, Mat4(1), 4, 0)).normalsDeg.value(), 180, 1e-6);
    EXPECT_EQ(separation(a, a).distance, 0);
    EXPECT_NEAR(separation(a, a).normalsDeg.value(), 0, 1e-12);
}

TEST(Angles, AreRightAlsoWhereTheyAreSmallOrNearlyStraight)
{
    EXPECT_NEAR(angleAtDeg({1, 1, 0}, {3, 1, 0}, {1, 9, 0}).value(), 90, 1e-13);
    EXPECT_NEAR(angleAtDeg(Vec3(0), {1, 0, 0}, {1, 1, 0}).value(), 45, 1e-13);
    EXPECT_NEAR(angleDeg({1, 0, 0}, {1, 1e-9, 0}).value() / (1e-9 * 180 / std::numbers::pi), 1, 1e-7);
    EXPECT_NEAR(180 - angleDeg({1, 0, 0}, {-1, 1e-6, 0}).value(), 1e-6 * 180 / std::numbers::pi, 1e-12);
    EXPECT_NEAR(angleDeg({1e200, 0, 0}, {0, 1e-200, 0}).value(), 90, 1e-13);
    EXPECT_FALSE(angleAtDeg({1, 1, 0}, {1, 1, 0}, {1, 9, 0}));
}

}  // namespace
}  // namespace knotspan
