// Faces trimmed by the borders of others that lie over them: held to shapes whose areas are known.
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/geometry/primitives.h"
#include "model/trimming/border_trimming.h"
#include "model/trimming/trim_region.h"
#include "tests/model/trimming/loop_samples.h"

namespace knotspan::testing {
namespace {

const Mat4 kAsItIs(1.0);
const std::vector<TrimLoop> kWhole;
constexpr double kPi = glm::pi<double>();

// Along -z without perspective: the picture's places are those of the model.
Sight above()
{
    Sight sight;
    sight.toPlane[2][2] = 0;
    return sight;
}
// From (0, 0, 10): x/w = 10 x / (10 - z).
Sight fromTen()
{
    Mat4 matrix(0.0);
    matrix[0][0] = 10;
    matrix[1][1] = 10;
    matrix[2][3] = -1;
    matrix[3][3] = 10;
    return {matrix, {0, 0, 10, 1}};
}
NurbsSurface disc(const Vec3& centre, double radius)
{
    return cone(centre, radius, 0, 0);
}

// By Green's formula; of a hole likewise above zero.
double areaOf(const TrimLoop& loop)
{
    double area = 0;
    for (const TrimCurve& curve : loop.curves)
        for (const int span : curve.knots().spans()) {
            constexpr int kParts = 200;
            const double step = (curve.knots()[span + 1] - curve.knots()[span]) / kParts;
            for (int k = 0; k < kParts; ++k) {
                const double t = curve.knots()[span] + (k + 0.5) * step;
                const Vec2 at = curve.evaluate(t);
                const Vec2 way = curve.derivative(t);
                area += 0.5 * (at.x * way.y - at.y * way.x) * step;
            }
        }
    return std::abs(area);
}

TEST(BorderTrimmingTest, ADiscAboveAPlaneCutsACircle)
{
    const NurbsSurface ground = flatSurface();
    const NurbsSurface cutter = disc({1.1, 11, 5}, 0.7);
    for (const double tolerance : {1e-3, 1e-6}) {
        const auto hole = trimmedByBorder({ground, kAsItIs, kWhole}, {cutter, kAsItIs, kWhole}, above(),
                                          tolerance, KeptSide::outside);
        ASSERT_TRUE(hole) << hole.error().sentence();
        ASSERT_EQ(hole->loops.size(), 1U);
        EXPECT_FALSE(hole->loops[0].outer);
        EXPECT_LE(hole->error, tolerance);
        EXPECT_NEAR(areaOf(hole->loops[0]), kPi * 0.7 * 0.7, 2 * kPi * 0.7 * tolerance);
        const auto rest = trimmedByBorder({ground, kAsItIs, kWhole}, {cutter, kAsItIs, kWhole}, above(),
                                          tolerance, KeptSide::inside);
        ASSERT_TRUE(rest);
        ASSERT_EQ(rest->loops.size(), 1U);
        EXPECT_TRUE(rest->loops[0].outer);
        EXPECT_TRUE(TrimRegion(rest->loops, ground).contains(1.1, 11.6));
        EXPECT_FALSE(TrimRegion(rest->loops, ground).contains(1.1, 11.8));
    }
}

TEST(BorderTrimmingTest, PerspectiveMakesTheShadowLarger)
{
    const NurbsSurface ground = plane({-4, -4, 0}, {8, 0, 0}, {0, 8, 0});
    const NurbsSurface cutter = disc({0, 0, 0}, 0.5);
    // Moved up to half way, by its transform.
    const Mat4 placed = glm::translate(Mat4(1), Vec3(0.2, 0.1, 5));
    const auto hole = trimmedByBorder({ground, kAsItIs, kWhole}, {cutter, placed, kWhole}, fromTen(), 1e-7,
                                      KeptSide::outside);
    ASSERT_TRUE(hole) << hole.error().sentence();
    ASSERT_EQ(hole->loops.size(), 1U);
    EXPECT_NEAR(areaOf(hole->loops[0]) * 64, kPi, 1e-6);
    EXPECT_TRUE(TrimRegion(hole->loops, ground).contains(0.5 + 0.5 / 8, 0.5 + 1.21 / 8));
    EXPECT_FALSE(TrimRegion(hole->loops, ground).contains(0.5 + 0.4 / 8, 0.5 + 1.19 / 8));
}

TEST(BorderTrimmingTest, FourSidesAndOuterLoopsAreBorders)
{
    const NurbsSurface ground = flatSurface();
    const NurbsSurface square = plane({0.5, 10.5, 3}, {0.5, 0, 1}, {0, 0.75, -2});
    const auto hole = trimmedByBorder({ground, kAsItIs, kWhole}, {square, kAsItIs, kWhole}, above(), 1e-9,
                                      KeptSide::outside);
    ASSERT_TRUE(hole) << hole.error().sentence();
    ASSERT_EQ(hole->loops.size(), 1U);
    EXPECT_EQ(hole->loops[0].curves.size(), 4U);
    EXPECT_NEAR(areaOf(hole->loops[0]), 0.375, 1e-9);
    // What is trimmed away of the cutter cuts nothing, and its hole neither.
    const std::vector<TrimLoop> loops{{true, {circle({1, 11}, 0.6)}}, {false, {circle({1, 11}, 0.2, false)}}};
    const Mat4 placed = glm::translate(Mat4(1), Vec3(0.1, 0, 2));
    const auto round =
        trimmedByBorder({ground, kAsItIs, kWhole}, {ground, placed, loops}, above(), 1e-7, KeptSide::outside);
    ASSERT_TRUE(round) << round.error().sentence();
    ASSERT_EQ(round->loops.size(), 1U);
    EXPECT_NEAR(areaOf(round->loops[0]), 0.36 * kPi, 1e-6);
}

TEST(BorderTrimmingTest, ABorderMayBeginAndEndBeyondTheFace)
{
    const NurbsSurface ground = flatSurface();
    // Its seam lies beyond: at x of 3.4.
    const NurbsSurface cutter = disc({3, 11, 1}, 0.4);
    const auto rest = trimmedByBorder({ground, kAsItIs, kWhole}, {cutter, kAsItIs, kWhole}, above(), 1e-7,
                                      KeptSide::outside);
    ASSERT_TRUE(rest) << rest.error().sentence();
    ASSERT_EQ(rest->loops.size(), 1U);
    EXPECT_TRUE(rest->loops[0].outer);
    EXPECT_NEAR(areaOf(rest->loops[0]), 8 - kPi * 0.08, 1e-6);
}

TEST(BorderTrimmingTest, OfRingsTheNearestToTheEyeCountsAndOfAFlatOneTheLonger)
{
    const NurbsSurface ground = flatSurface();
    const auto areaBy = [&](const NurbsSurface& cutter) {
        const auto hole = trimmedByBorder({ground, kAsItIs, kWhole}, {cutter, kAsItIs, kWhole}, above(), 1e-7,
                                          KeptSide::outside);
        EXPECT_TRUE(hole) << hole.error().sentence();
        return hole && hole->loops.size() == 1 ? areaOf(hole->loops[0]) : 0;
    };
    EXPECT_NEAR(areaBy(cone({1, 11, 1}, 0.8, 0.3, 2)), kPi * 0.09, 1e-6);
    EXPECT_NEAR(areaBy(cone({1, 11, 1}, 0.3, 0.8, 2)), kPi * 0.64, 1e-6);
    EXPECT_NEAR(areaBy(cone({1, 11, 1}, 0.3, 0.8, 0)), kPi * 0.64, 1e-6);
}

// As STEP files have it: one loop, along the seam and back.
TEST(BorderTrimmingTest, ALoopAlongASeamIsItsRings)
{
    const NurbsSurface ground = flatSurface();
    const NurbsSurface pipe = cone({1, 11, 1}, 0.8, 0.3, 2);
    const double end = pipe.knotsU().domainEnd();
    const auto line = [](const Vec2& from, const Vec2& to) { return polyline({from, to}); };
    // Half of its height is left: the upper ring has a radius of 0.55.
    const std::vector<TrimLoop> loops{{true,
                                       {line({0, 0}, {end, 0}), line({end, 0}, {end, 0.5}),
                                        line({end, 0.5}, {0, 0.5}), line({0, 0.5}, {0, 0})}}};
    const auto hole =
        trimmedByBorder({ground, kAsItIs, kWhole}, {pipe, kAsItIs, loops}, above(), 1e-7, KeptSide::outside);
    ASSERT_TRUE(hole) << hole.error().sentence();
    ASSERT_EQ(hole->loops.size(), 1U);
    EXPECT_NEAR(areaOf(hole->loops[0]), kPi * 0.55 * 0.55, 1e-6);
}

TEST(BorderTrimmingTest, TheSheetThatIsNearestToTheEyeIsTrimmed)
{
    const NurbsSurface ball = sphere(Vec3(0), 2);
    const NurbsSurface cutter = disc({0.9, 0.5, 5}, 0.4);
    const auto hole =
        trimmedByBorder({ball, kAsItIs, kWhole}, {cutter, kAsItIs, kWhole}, above(), 1e-6, KeptSide::outside);
    ASSERT_TRUE(hole) << hole.error().sentence();
    const TrimRegion region(hole->loops, ball);
    int wrong = 0;
    int away = 0;
    for (double u = 0.005; u < 8; u += 0.02)
        for (double v = 0.005; v < 4; v += 0.02) {
            const Vec3 at = evaluate(ball, u, v).position;
            const double off = glm::distance(Vec2(at), Vec2(0.9, 0.5)) - 0.4;
            const bool isAway = at.z > 0 && off < 0;
            away += isAway;
            wrong += std::abs(off) > 1e-5 && region.contains(u, v) == isAway;
        }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(away, 100);
}

TEST(BorderTrimmingTest, SaysWhyNot)
{
    const NurbsSurface ground = flatSurface();
    const auto why = [&](const NurbsSurface& face, const NurbsSurface& cutter, const Sight& sight) {
        const auto result = trimmedByBorder({face, kAsItIs, kWhole}, {cutter, kAsItIs, kWhole}, sight, 1e-4,
                                            KeptSide::outside);
        return result ? std::string() : result.error().sentence();
    };
    const auto has = [](const std::string& sentence, const char* words) {
        return sentence.find(words) != std::string::npos;
    };
    EXPECT_TRUE(has(why(ground, disc({9, 9, 5}, 1), above()), "does not meet"));
    EXPECT_TRUE(has(why(ground, sphere({1, 11, 5}, 0.5), above()), "no border"));
    EXPECT_TRUE(has(why(ground, torus({1, 11, 5}, 0.5, 0.1), above()), "no border"));
    EXPECT_TRUE(has(why(sphere(Vec3(0), 2), disc({1.9, 0, 5}, 0.5), above()), "turns away"));
    const NurbsSurface floor = plane({-4, -4, 0}, {8, 0, 0}, {0, 8, 0});
    EXPECT_TRUE(has(why(floor, disc({0, 0, 11}, 1), fromTen()), "behind the eye"));
    // Upright, so that it is seen as a line.
    EXPECT_TRUE(has(why(ground, plane({0, 11, 3}, {1, 0, 0}, {0, 0, 1}), above()), "as a line"));
    // Twisted, so that its border crosses itself.
    const NurbsSurface bow =
        NurbsSurface::create(KnotVector::clampedUniform(1, 1), KnotVector::clampedUniform(1, 1),
                             {{{0.1, 10.5, 1}}, {{0.1, 11.2, 1}}, {{0.9, 11.2, 1}}, {{0.9, 10.5, 1}}})
            .value();
    EXPECT_TRUE(has(why(ground, bow, above()), "crosses itself")) << why(ground, bow, above());
}

// Two islands of one face: what is inside stays in both.
TEST(BorderTrimmingTest, InsideIsInsideAnyOfTheCuttersBorders)
{
    const NurbsSurface ground = flatSurface();
    const std::vector<TrimLoop> islands{{true, {circle({0, 11}, 0.5)}}, {true, {circle({2, 11.2}, 0.6)}}};
    const auto rest = trimmedByBorder({ground, kAsItIs, kWhole}, {ground, kAsItIs, islands}, above(), 1e-6,
                                      KeptSide::inside);
    ASSERT_TRUE(rest) << rest.error().sentence();
    ASSERT_EQ(rest->loops.size(), 2U);
    const TrimRegion region(rest->loops, ground);
    EXPECT_TRUE(region.contains(0, 11.4) && region.contains(2, 10.7));
    EXPECT_FALSE(region.contains(1, 11) || region.contains(2.7, 11.2));
}

TEST(BorderTrimmingTest, PartsThatOverlapAreNotJoined)
{
    const NurbsSurface ground = flatSurface();
    const auto island = [](const Vec2& centre, double radius) {
        return std::vector<TrimLoop>{{true, {circle(centre, radius)}}};
    };
    EXPECT_EQ(joinedParts({island({0, 11}, 0.5), island({1.5, 11}, 0.5)}, ground)->size(), 2U);
    EXPECT_FALSE(joinedParts({island({0, 11}, 0.5), island({0.6, 11}, 0.5)}, ground));
    EXPECT_FALSE(joinedParts({island({0, 11}, 0.5), island({0.1, 11}, 0.2)}, ground));
    EXPECT_FALSE(joinedParts({island({0.1, 11}, 0.2), island({0, 11}, 0.5)}, ground));
}

}  // namespace
}  // namespace knotspan::testing
