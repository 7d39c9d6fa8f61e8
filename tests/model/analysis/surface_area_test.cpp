// Areas against closed forms.
#include "model/analysis/surface_area.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "model/geometry/primitives.h"

namespace knotspan {
namespace {

constexpr double kPi = std::numbers::pi;

Mat4 scaled(const Vec3& by)
{
    Mat4 matrix(1.0);
    for (int axis = 0; axis < 3; ++axis)
        matrix[axis][axis] = by[axis];
    matrix[3] = Vec4(1e6, -7, 3, 1);
    return matrix;
}

void expectArea(const Area& found, double exact)
{
    EXPECT_NEAR(found.value, exact, 1e-9 * exact);
    EXPECT_LE(std::abs(found.value - exact), found.error + 1e-14 * exact) << "the estimate covers the error";
    EXPECT_LT(found.error, 1e-8 * exact);
}

TEST(SurfaceArea, OfASphereIsFourPiRSquared)
{
    expectArea(surfaceArea(sphere({1, 2, 3}, 5), Mat4(1)), 4 * kPi * 25);
    expectArea(surfaceArea(sphere({1, 2, 3}, 5), scaled(Vec3(0.01))), 4 * kPi * 25 * 1e-4);
}

TEST(SurfaceArea, OfATorusIsThatOfItsTwoCirclesMultiplied)
{
    expectArea(surfaceArea(torus(Vec3(0), 7, 2), Mat4(1)), 4 * kPi * kPi * 14);
    expectArea(surfaceArea(torus(Vec3(0), 7, 6.99), scaled({-3, 3, 3})), 9 * 4 * kPi * kPi * 7 * 6.99);
}

TEST(SurfaceArea, OfACylinderAndAConeAreThoseUnrolled)
{
    expectArea(surfaceArea(cylinder({1, 0, 0}, 3, 11), Mat4(1)), 2 * kPi * 3 * 11);
    expectArea(surfaceArea(cone(Vec3(0), 3, 0, 4), Mat4(1)), kPi * 3 * 5);  // a pole at its tip
}

TEST(SurfaceArea, OfASphereStretchedToAnOblateSpheroid)
{
    const double a = 3;
    const double c = 2;
    const double e = std::sqrt(1 - c * c / (a * a));
    expectArea(surfaceArea(sphere(Vec3(0), 1), scaled({a, a, c})),
               2 * kPi * a * a * (1 + (1 - e * e) / e * std::atanh(e)));
}

TEST(SurfaceArea, OfAPlaneIsExact)
{
    const Area area = surfaceArea(plane({1, 1, 1}, {3, 0, 0}, {1, 4, 0}), scaled({2, 5, 1}));
    EXPECT_NEAR(area.value, 120, 1e-12);
    EXPECT_LT(area.error, 1e-11);
}

// z = x y over [-1, 1]^2, whose area is the integral of sqrt(1 + x^2 + y^2).
TEST(SurfaceArea, OfASaddle)
{
    const KnotVector knots = KnotVector::clampedUniform(1, 1);
    const NurbsSurface saddle =
        NurbsSurface::create(knots, knots, {{{-1, -1, 1}}, {{-1, 1, -1}}, {{1, -1, -1}}, {{1, 1, 1}}})
            .value();
    // Over y in closed form, over x by Simpson's rule with very many steps.
    const auto inner = [](double x) {
        const double k = 1 + x * x;
        return std::sqrt(k + 1) + k * std::asinh(1 / std::sqrt(k));
    };
    constexpr int kSteps = 20000;
    double sum = 0;
    for (int i = 0; i <= kSteps; ++i)
        sum += (i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2) * inner(-1 + 2.0 * i / kSteps);
    expectArea(surfaceArea(saddle, Mat4(1)), sum * 2.0 / kSteps / 3);
}

// A flat sheet whose middle row of control points lies beyond its end: it covers a part three times, and the
// normal turns over along a curve inside KSQuads.
TEST(SurfaceArea, OfAFoldedSheetCountsEveryLayer)
{
    const NurbsSurface fold =
        NurbsSurface::create(KnotVector::clampedUniform(2, 1), KnotVector::clampedUniform(1, 1),
                             {{{0, 0, 0}}, {{0, 1, 0}}, {{3, 0, 0}}, {{3, 1, 0}}, {{1, 0, 0}}, {{1, 1, 0}}})
            .value();
    // x = 6 t (1 - t) + t^2, there and back: up to its highest point 9/5, and down to 1.
    const Area area = surfaceArea(fold, Mat4(1));
    EXPECT_NEAR(area.value, 9.0 / 5 + 4.0 / 5, area.error);
    EXPECT_LT(area.error, 1e-4);
}

TEST(SurfaceArea, StopsWhereNobodyWaitsForIt)
{
    const Area area = surfaceArea(sphere(Vec3(0), 1), Mat4(1), [] { return true; });
    EXPECT_TRUE(std::isinf(area.error));
}

TEST(MeshArea, IsTheSumOfItsTriangles)
{
    const TriangleMesh mesh{{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {0, 0, 5}}, {{0, 1, 2}, {0, 1, 3}}};
    EXPECT_NEAR(meshArea(mesh, Mat4(1)), 6 + 7.5, 1e-13);
    EXPECT_NEAR(meshArea(mesh, scaled({2, 1, 1})), 12 + 15, 1e-12);
}

}  // namespace
}  // namespace knotspan
