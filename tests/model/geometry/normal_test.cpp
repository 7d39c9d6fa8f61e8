#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/geometry/primitives.h"

namespace knotspan {
namespace {

TEST(Normal, OfASphereIsItsPointEvenAtThePoles)
{
    const Vec3 centre(1e3, -2e3, 5);
    const NurbsSurface ball = sphere(centre, 3);
    for (int i = 0; i <= 64; ++i)
        for (int j = 0; j <= 32; ++j) {
            const double u = i / 8.0;
            const double v = j / 8.0;
            const Vec3 out = (evaluate(ball, u, v).position - centre) / 3.0;
            EXPECT_NEAR(glm::length(out), 1, 1e-12);
            const SurfaceNormal normal = evaluateNormal(ball, u, v);
            EXPECT_LE(glm::length(normal.direction - out), 1e-11) << u << ", " << v;
            EXPECT_TRUE(normal.exists);
            EXPECT_EQ(normal.isLimit, j == 0 || j == 32);
        }
}

TEST(Normal, OfATorusPointsAwayFromItsRing)
{
    const NurbsSurface ring = torus({0, 0, 0}, 5, 2);
    for (int i = 0; i <= 40; ++i)
        for (int j = 0; j <= 40; ++j) {
            const Vec3 point = evaluate(ring, i / 5.0, j / 5.0).position;
            const Vec3 onRing = glm::normalize(Vec3(point.x, point.y, 0)) * 5.0;
            EXPECT_NEAR(glm::length(point - onRing), 2, 1e-13);
            EXPECT_LE(glm::length(evaluateNormal(ring, i / 5.0, j / 5.0).direction - (point - onRing) / 2.0),
                      1e-13);
        }
}

NurbsSurface bilinear(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return *NurbsSurface::create(KnotVector::clampedUniform(1, 1), KnotVector::clampedUniform(1, 1),
                                 {{a, 1}, {b, 1}, {c, 1}, {d, 1}});
}

TEST(Normal, IsTheLimitWhereAnEdgeIsCollapsedToAPoint)
{
    // A triangle in the plane z = 0, its edge u = 0 collapsed, then its edges u = 1, v = 0 and v = 1.
    const Vec3 p(0, 0, 0);
    const Vec3 q(1, -1, 0);
    const Vec3 r(1, 1, 0);
    for (const NurbsSurface& triangle :
         {bilinear(p, p, q, r), bilinear(r, q, p, p), bilinear(p, q, p, r), bilinear(r, p, q, p)})
        for (const double u : {0.0, 0.25, 1.0})
            for (const double v : {0.0, 0.5, 1.0}) {
                const SurfaceNormal normal = evaluateNormal(triangle, u, v);
                EXPECT_TRUE(normal.exists);
                EXPECT_NEAR(std::abs(normal.direction.z), 1, 1e-12);
                EXPECT_GT(normal.direction.z * evaluateNormal(triangle, 0.5, 0.5).direction.z, 0);
            }
}

TEST(Normal, OfASurfaceThatIsAPointOrALineIsSomeUnitVectorThatDoesNotExist)
{
    const Vec3 p(3, 4, 5);
    for (const NurbsSurface& nothing :
         {bilinear(p, p, p, p), bilinear({0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3})}) {
        const SurfaceNormal normal = evaluateNormal(nothing, 0, 0.5);
        EXPECT_FALSE(normal.exists);
        EXPECT_NEAR(glm::length(normal.direction), 1, 1e-12);
    }
}

TEST(Normal, DoesNotDependOnTheSizeOfTheParameters)
{
    for (const double scale : {1e-12, 1e12}) {
        const auto knots = *KnotVector::create(1, {0, 0, scale, scale});
        const auto sheet =
            *NurbsSurface::create(knots, KnotVector::clampedUniform(1, 1),
                                  {{{0, 0, 0}, 1}, {{0, 1, 0}, 1}, {{1, 0, 0}, 1}, {{1, 1, 0}, 1}});
        EXPECT_EQ(evaluateNormal(sheet, 0.5 * scale, 0.5).direction, Vec3(0, 0, 1));
    }
}

}  // namespace
}  // namespace knotspan
