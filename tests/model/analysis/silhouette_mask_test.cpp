#include "model/analysis/silhouette_mask.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/samples/sample_list.h"

namespace knotspan::testing {
namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 150;

// Looks along -z at the origin, `half` units high up to the border, without perspective.
Mat4 orthographicView(double half)
{
    Mat4 matrix(0.0);
    matrix[0][0] = static_cast<double>(kHeight) / kWidth / half;
    matrix[1][1] = -1 / half;
    matrix[2][2] = 0.001;
    matrix[3] = Vec4(0, 0, 0.5, 1);
    return matrix;
}

// From `eye` along -z, with a near plane.
Mat4 perspectiveView(const Vec3& eye, double near)
{
    Mat4 projection(0.0);
    projection[0][0] = static_cast<double>(kHeight) / kWidth;
    projection[1][1] = -1;
    projection[2][3] = -1;
    projection[3][2] = near;
    Mat4 moved(1.0);
    moved[3] = Vec4(-eye, 1);
    return projection * moved;
}

PixelMask maskOf(const Scene& scene, const Mat4& toClip, double tolerance)
{
    std::vector<SurfaceInClip> surfaces;
    for (const auto& [id, object] : scene.objects())
        surfaces.push_back({object->surface, toClip * object->transform});
    return silhouetteMask(surfaces, kWidth, kHeight, tolerance);
}

double radiusOf(const Scene& sphere)
{
    return sphere.bounds().size().z / 2;
}

TEST(SilhouetteMask, OfASphereIsItsDiscWithoutTheMargin)
{
    const Scene sphere = findSample("sphere")->make();
    const double radius = radiusOf(sphere);
    Mat4 centred(1.0);
    centred[3] = Vec4(-sphere.bounds().centre(), 1);
    for (const double tolerance : {0.25, 1.0, 4.0}) {
        const PixelMask mask = maskOf(sphere, orthographicView(1.5 * radius) * centred, tolerance);
        const double shown = kHeight / 2.0 / 1.5;
        const double margin = std::ceil(tolerance) + 1;
        size_t wrong = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const double from = std::hypot(x + 0.5 - kWidth / 2.0, y + 0.5 - kHeight / 2.0);
                if (mask.at(x, y) ? from > shown - tolerance : from < shown - margin - 0.3)
                    ++wrong;
            }
        EXPECT_EQ(wrong, 0U) << tolerance;
        EXPECT_GT(mask.count(), 5000U) << tolerance;
    }
}

TEST(SilhouetteMask, LeavesTheHoleOfATorusOut)
{
    const Scene torus = findSample("torus")->make();
    const Vec3 size = torus.bounds().size();
    const PixelMask mask = maskOf(torus, orthographicView(0.7 * std::max(size.x, size.y)), 0.5);
    EXPECT_GT(mask.count(), 2000U);
    EXPECT_FALSE(mask.at(kWidth / 2, kHeight / 2));
}

TEST(SilhouetteMask, IsTheWholePictureFromInsideASphere)
{
    const Scene sphere = findSample("sphere")->make();
    const PixelMask mask =
        maskOf(sphere, perspectiveView(sphere.bounds().centre(), 1e-3 * radiusOf(sphere)), 0.5);
    EXPECT_EQ(mask.count(), static_cast<size_t>(kWidth) * kHeight);
}

TEST(SilhouetteMask, KeepsAwayFromWhereTheNearPlaneCuts)
{
    const Scene sphere = findSample("sphere")->make();
    const double radius = radiusOf(sphere);
    const Vec3 centre = sphere.bounds().centre();
    // The plane z = centre + 0.5 radius takes a cap off. Seen through the cut is the far side.
    const PixelMask mask =
        maskOf(sphere, perspectiveView(centre + Vec3(0, 0, 2.5 * radius), 2 * radius), 0.5);
    const double pixels = kHeight / 2.0;
    const double cut = pixels * std::sqrt(0.75) / 2.0;
    EXPECT_TRUE(mask.at(kWidth / 2, kHeight / 2));
    EXPECT_FALSE(mask.at(kWidth / 2 + static_cast<int>(cut), kHeight / 2));
    EXPECT_FALSE(mask.at(kWidth / 2, kHeight / 2 - static_cast<int>(cut)));
}

TEST(SilhouetteMask, ShrinksWithTheTolerance)
{
    const Scene knot = findSample("knot")->make();
    const Vec3 size = knot.bounds().size();
    Mat4 centred(1.0);
    centred[3] = Vec4(-knot.bounds().centre(), 1);
    const Mat4 view = orthographicView(0.6 * std::max(size.x, size.y)) * centred;
    const PixelMask fine = maskOf(knot, view, 0.25);
    const PixelMask coarse = maskOf(knot, view, 2);
    EXPECT_LT(coarse.count(), fine.count());
    for (size_t k = 0; k < fine.covered.size(); ++k)
        ASSERT_LE(coarse.covered[k], fine.covered[k]);
}

}  // namespace
}  // namespace knotspan::testing
