// Sections against circles, straight lines and the curves that a plane cuts from a torus.
#include "model/mesh/plane_section.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "model/geometry/primitives.h"
#include "tests/model/trimming/loop_samples.h"

namespace knotspan {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<SectionCurve> cutOf(const NurbsSurface& surface, const SectionPlane& plane,
                                double tolerance = 1e-6, const Mat4& transform = Mat4(1))
{
    const auto object =
        std::make_shared<const SceneObject>(SceneObject{.transform = transform, .surface = surface});
    const auto ready = SectionSurface::create(object, 1e-3 * object->bounds().diagonal());
    EXPECT_TRUE(ready) << ready.error().sentence();
    return ready->cut(plane, tolerance);
}

// Every point on the plane and this far from `centre`.
void expectCircle(const SectionCurve& curve, const SectionPlane& plane, const Vec3& centre, double radius)
{
    EXPECT_TRUE(curve.isClosed());
    for (const Vec3& point : curve.points) {
        EXPECT_NEAR(glm::dot(plane.normal, point), plane.offset, 1e-11);
        EXPECT_NEAR(glm::distance(point, centre), radius, 1e-11);
    }
    EXPECT_NEAR(curve.length(), 2 * kPi * radius, 1e-5 * radius);
}

TEST(PlaneSection, OfASphereIsACircleWhereverThePlaneIs)
{
    for (const Vec3 normal : {Vec3(0, 0, 1), Vec3(1, 0, 0), glm::normalize(Vec3(1, 2, 3))})
        for (const double height : {-4.5, 0.0, 1.0, 3.0, 4.9}) {
            const Vec3 centre(1, 2, 3);
            const SectionPlane plane{normal, glm::dot(normal, centre) + height};
            const auto curves = cutOf(sphere(centre, 5), plane);
            ASSERT_EQ(curves.size(), 1U) << height;
            expectCircle(curves[0], plane, centre + normal * height, std::sqrt(25 - height * height));
        }
    EXPECT_TRUE(cutOf(sphere(Vec3(0), 5), {{0, 0, 1}, 5.1}).empty());
}

TEST(PlaneSection, OfATorusAreTwoCircles)
{
    const NurbsSurface ring = torus(Vec3(0), 5, 2);
    for (const double height : {0.0, 1.2}) {
        const SectionPlane flat{{0, 0, 1}, height};
        auto curves = cutOf(ring, flat);
        ASSERT_EQ(curves.size(), 2U);
        if (curves[0].length() > curves[1].length())
            std::swap(curves[0], curves[1]);
        const double half = std::sqrt(4 - height * height);
        expectCircle(curves[0], flat, {0, 0, height}, 5 - half);
        expectCircle(curves[1], flat, {0, 0, height}, 5 + half);
    }
    // Through the axis: the tube's own circles.
    for (const SectionCurve& curve : cutOf(ring, {{1, 0, 0}, 0}))
        expectCircle(curve, {{1, 0, 0}, 0}, {0, curve.points[0].y > 0 ? 5 : -5, 0}, 2);
    // Aslant, touching it twice: Villarceau's two circles of the greater radius, which cross. Where they do,
    // cells of the mesh cut the corners.
    const double slope = std::asin(2.0 / 5);
    double length = 0;
    for (const SectionCurve& curve : cutOf(ring, {{0, -std::sin(slope), std::cos(slope)}, 0}))
        length += curve.length();
    EXPECT_NEAR(length, 2 * 2 * kPi * 5, 0.01 * 20 * kPi);
}

// (x^2 + y^2 + z^2 + 21)^2 = 100 (x^2 + y^2)
TEST(PlaneSection, OfATorusBesideItsHoleIsASpiricCurve)
{
    const auto curves = cutOf(torus(Vec3(0), 5, 2), {{0, 1, 0}, 4.0});
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_TRUE(curves[0].isClosed());
    for (const Vec3& p : curves[0].points) {
        const double squares = glm::dot(p, p) + 21;
        EXPECT_NEAR(squares * squares, 100 * (p.x * p.x + p.y * p.y), 1e-8);
        EXPECT_NEAR(p.y, 4, 1e-11);
    }
}

TEST(PlaneSection, IsAsNearAsAskedBetweenItsPoints)
{
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
        const auto curves = cutOf(sphere(Vec3(0), 5), {{0, 0, 1}, 1}, tolerance);
        ASSERT_EQ(curves.size(), 1U);
        const double radius = std::sqrt(24.0);
        for (size_t k = 1; k < curves[0].points.size(); ++k) {
            const Vec3 middle = 0.5 * (curves[0].points[k - 1] + curves[0].points[k]);
            EXPECT_LE(radius - std::hypot(middle.x, middle.y), 1.001 * tolerance);
        }
    }
}

TEST(PlaneSection, EndsAtTheBordersOfAnOpenSurface)
{
    const auto across = cutOf(plane(Vec3(0), {4, 0, 0}, {0, 4, 0}), {{1, 0, 0}, 1});
    ASSERT_EQ(across.size(), 1U);
    EXPECT_FALSE(across[0].isClosed());
    EXPECT_NEAR(across[0].length(), 4, 1e-12);
    const auto along = cutOf(cylinder(Vec3(0), 2, 7), {{1, 0, 0}, 1});
    ASSERT_EQ(along.size(), 2U);
    for (const SectionCurve& curve : along)
        EXPECT_NEAR(curve.length(), 7, 1e-11);
}

TEST(PlaneSection, FollowsTheTransform)
{
    Mat4 transform(1);
    transform[0][0] = 2;
    transform[1][1] = 2;
    transform[2][2] = -2;
    transform[3] = Vec4(100, 0, 7, 1);
    const SectionPlane plane{{0, 0, 1}, 8};
    const auto curves = cutOf(sphere(Vec3(0), 1), plane, 1e-6, transform);
    ASSERT_EQ(curves.size(), 1U);
    expectCircle(curves[0], plane, {100, 0, 8}, std::sqrt(3.0));
}

// A flat ring: the ends are on its circles, as near as its mesh is.
TEST(PlaneSection, OfATrimmedSurfaceEndsAtItsLoops)
{
    SceneObject object{.surface = testing::flatSurface({-1, 3}, {10, 12})};
    object.trimLoops = {{true, {testing::circle({1, 11}, 0.9)}},
                        {false, {testing::circle({1.2, 11}, 0.4, false)}}};
    const auto ready = SectionSurface::create(std::make_shared<const SceneObject>(object), 1e-3);
    ASSERT_TRUE(ready) << ready.error().sentence();
    for (const double height : {0.0, 0.2, -0.35}) {
        const auto curves = ready->cut({{0, 1, 0}, 11 + height}, 1e-6);
        ASSERT_EQ(curves.size(), 2U) << height;
        const double outer = std::sqrt(0.81 - height * height);
        const double inner = std::sqrt(0.16 - height * height);
        double length = 0;
        for (const SectionCurve& curve : curves) {
            length += curve.length();
            for (const Vec3& end : {curve.points.front(), curve.points.back()}) {
                const double fromOuter = std::abs(glm::distance(Vec2(end), Vec2(1, 11)) - 0.9);
                const double fromInner = std::abs(glm::distance(Vec2(end), Vec2(1.2, 11)) - 0.4);
                EXPECT_LT(std::min(fromOuter, fromInner), 1e-3);
            }
        }
        EXPECT_NEAR(length, 2 * outer - 2 * inner, 4e-3);
    }
    EXPECT_TRUE(ready->cut({{0, 1, 0}, 11.95}, 1e-6).empty());
    EXPECT_EQ(ready->cut({{0, 1, 0}, 11.6}, 1e-6).size(), 1U);
}

}  // namespace
}  // namespace knotspan
