// Drawn curves on surfaces: what falls onto them along the view, held to rays that are traced independently.
#include <algorithm>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/geometry/primitives.h"
#include "model/trimming/curve_projection.h"
#include "tests/model/trimming/loop_samples.h"

namespace knotspan::testing {
namespace {

// The plane z = 0 seen from (0, 0, 10): x/w = 10 x / (10 - z).
Mat4 fromAbove()
{
    Mat4 matrix(0.0);
    matrix[0][0] = 10;
    matrix[1][1] = 10;
    matrix[2][3] = -1;
    matrix[3][3] = 10;
    return matrix;
}

Vec2 seen(const Mat4& toPlane, const Vec3& point)
{
    const Vec4 place = toPlane * Vec4(point, 1);
    return Vec2(place.x, place.y) / place.w;
}

// The largest distance of the projected curve's points from the plane curve, both taken at many places.
double farthest(const NurbsSurface& surface, const Mat4& toPlane, const ProjectedCurve& found,
                const PlaneCurve& curve)
{
    std::vector<Vec2> dense;
    for (const PlanePiece& piece : curve)
        for (int k = 0; k < 5000; ++k)
            dense.push_back(piece.at(k / 5000.0));
    double most = 0;
    for (const TrimCurve& one : found.curves)
        for (int k = 0; k <= 300; ++k) {
            const Vec2 uv = one.evaluate(k / 300.0);
            const Vec2 at = seen(toPlane, evaluate(surface, uv.x, uv.y).position);
            double least = 1e300;
            for (size_t i = 0; i < dense.size(); ++i) {
                const Vec2 way = dense[(i + 1) % dense.size()] - dense[i];
                const double s = std::clamp(glm::dot(at - dense[i], way) / glm::dot(way, way), 0.0, 1.0);
                least = std::min(least, glm::length(at - dense[i] - s * way));
            }
            most = std::max(most, least);
        }
    return most;
}

const std::vector<Vec2> kBlob{{1, 0.2}, {0.4, 1}, {-0.9, 0.7}, {-0.5, -0.6}, {0.6, -0.8}};

TEST(CurveProjectionTest, ASplineOnABallIsWithinItsTolerance)
{
    const NurbsSurface ball = sphere(Vec3(0), 2);
    // Somewhere on the upper half.
    Vec2 start(0);
    for (double u = 0; u < ball.knotsU().domainEnd(); u += 0.01)
        for (double v = 0; v < ball.knotsV().domainEnd(); v += 0.01) {
            const Vec3 at = evaluate(ball, u, v).position;
            const Vec3 best = evaluate(ball, start.x, start.y).position;
            const auto off = [](const Vec3& p) {
                return p.z > 0 ? glm::length(seen(fromAbove(), p) - Vec2(1, 0.4)) : 1e9;
            };
            if (off(at) < off(best))
                start = {u, v};
        }
    std::vector<Vec2> blob;
    for (const Vec2& point : kBlob)
        blob.push_back(Vec2(1, 0.4) + 0.3 * point);
    for (const double tolerance : {1e-3, 1e-6}) {
        const auto found = projectedOnto(ball, {fromAbove(), Mat4(1)}, closedSpline(blob), start, tolerance);
        ASSERT_TRUE(found) << found.error().sentence();
        EXPECT_LE(found->error, tolerance);
        EXPECT_LT(farthest(ball, fromAbove(), *found, closedSpline(blob)), 2 * tolerance + 1e-6);
        ASSERT_EQ(found->curves.size(), 1U);
        EXPECT_EQ(found->curves[0].evaluate(0), found->curves[0].evaluate(1));
        for (int k = 0; k <= 50; ++k)
            EXPECT_GT(
                evaluate(ball, found->curves[0].evaluate(k / 50.0).x, found->curves[0].evaluate(k / 50.0).y)
                    .position.z,
                0);
    }
}

TEST(CurveProjectionTest, APolygonHasACurveForEachSide)
{
    const NurbsSurface plane = flatSurface();
    const PlaneCurve square = closedPolygon({{0, 10.5}, {1, 10.5}, {1, 11.5}, {0, 11.5}});
    const auto found = projectedOnto(plane, {fromAbove(), Mat4(1)}, square, {0, 10.5}, 1e-9);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->curves.size(), 4U);
    for (size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(found->curves[k].evaluate(1), found->curves[(k + 1) % 4].evaluate(0));
        EXPECT_LE(found->curves[k].points().size(), 6U);
    }
    EXPECT_LT(farthest(plane, fromAbove(), *found, square), 1e-4);
}

TEST(CurveProjectionTest, GoesOnBeyondTheBorder)
{
    const auto found = projectedOnto(flatSurface(), {fromAbove(), Mat4(1)},
                                     closedPolygon({{0, 11}, {5, 11}, {5, 14}, {0, 14}}), {0, 11}, 1e-9);
    ASSERT_TRUE(found);
    EXPECT_NEAR(glm::length(found->curves[1].evaluate(1) - Vec2(5, 14)), 0, 1e-9);
    EXPECT_NEAR(glm::length(found->curves[0].evaluate(0.5) - Vec2(2.5, 11)), 0, 1e-9);
}

TEST(CurveProjectionTest, GoesAcrossASeamAndKeepsToItsSheet)
{
    const NurbsSurface pipe = cylinder(Vec3(0), 1, 4);
    // Along x from far away, so that the seam at y = 0 faces the eye.
    Mat4 along(0.0);
    along[1][0] = 1;
    along[2][1] = 1;
    along[3][3] = 1;
    const std::vector<Vec2> corners{{-0.5, 1}, {0.5, 1}, {0.5, 3}, {-0.5, 3}};
    const double end = pipe.knotsU().domainEnd();
    const Vec3 front = evaluate(pipe, 0, 0).position;
    ASSERT_NEAR(std::abs(front.x), 1, 1e-9) << "the seam faces along x";
    const auto found = projectedOnto(pipe, {along, Mat4(1)}, closedPolygon(corners), {0.05 * end, 1}, 1e-6);
    ASSERT_TRUE(found) << found.error().sentence();
    double least = 1e9;
    double most = -1e9;
    for (const TrimCurve& curve : found->curves)
        for (int k = 0; k <= 20; ++k) {
            least = std::min(least, curve.evaluate(k / 20.0).x);
            most = std::max(most, curve.evaluate(k / 20.0).x);
        }
    EXPECT_LT(most - least, 0.25 * end);
    EXPECT_LT(least, 0);
    EXPECT_GT(most, 0);
}

TEST(CurveProjectionTest, RefusesWhereTheSurfaceTurnsAway)
{
    const NurbsSurface ball = sphere(Vec3(0), 2);
    const auto start =
        projectedPlace(ball, {fromAbove(), Mat4(1)}, {1, 0.4}, {0.3, 0.8 * ball.knotsV().domainEnd()});
    ASSERT_TRUE(start);
    const auto found = projectedOnto(ball, {fromAbove(), Mat4(1)},
                                     closedPolygon({{1, 0.4}, {4, 0.4}, {4, 2}}), *start, 1e-4);
    ASSERT_FALSE(found);
    EXPECT_NE(found.error().sentence().find("edge-on"), std::string::npos);
}

}  // namespace
}  // namespace knotspan::testing
