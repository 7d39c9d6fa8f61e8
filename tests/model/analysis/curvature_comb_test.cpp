// Combs against circles, straight lines and the osculating circle of a parabola.
#include "model/analysis/curvature_comb.h"

#include <cmath>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "model/geometry/primitives.h"
#include "model/trimming/trim_region.h"
#include "tests/model/trimming/loop_samples.h"

namespace knotspan {
namespace {

void expectTowards(const CombTooth& tooth, const Vec3& centre)
{
    const Vec3 way = centre - tooth.foot;
    const double radius = glm::length(way);
    EXPECT_LT(glm::distance(tooth.curvature * radius, way / radius), 1e-12);
}

TEST(IsoCombs, OfACylinderAreOneOverItsRadiusAroundAndNoneAlong)
{
    const auto combs = isoCombs(cylinder({1, 2, 3}, 4, 7), Mat4(1), 3, 5);
    ASSERT_EQ(combs.size(), 6U);
    for (const IsoComb& comb : combs) {
        ASSERT_EQ(comb.teeth.size(), comb.across == Direction::U ? 6U : 8U * 6);
        for (const CombTooth& tooth : comb.teeth) {
            if (comb.across == Direction::U) {
                EXPECT_LT(glm::length(tooth.curvature), 1e-13);
            } else {
                expectTowards(tooth, {1, 2, tooth.foot.z});
            }
        }
    }
    EXPECT_NEAR(curvatureOfMost(combs, 1), 0.25, 1e-13);
}

TEST(IsoCombs, OfATorusPointToTheMiddlesOfItsCircles)
{
    const Mat4 doubled(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 100, 1);
    for (const IsoComb& comb : isoCombs(torus(Vec3(0), 5, 2), doubled, 4, 4))
        for (const CombTooth& tooth : comb.teeth) {
            const Vec3 spine(tooth.foot.x, tooth.foot.y, 0);
            if (comb.across == Direction::U)
                expectTowards(tooth, glm::normalize(spine) * 10.0 + Vec3(0, 0, 100));
            else
                expectTowards(tooth, {0, 0, tooth.foot.z});  // the parallel's own centre: on the axis
        }
}

// A circle on a plane bends within the plane: the comb is the curve's, not the surface's.
TEST(IsoCombs, OfAFlatRingAreThoseOfItsCircles)
{
    const auto combs = isoCombs(cone(Vec3(0), 3, 1, 0), Mat4(1), 2, 4);
    ASSERT_EQ(combs.size(), 4U);
    for (const IsoComb& comb : combs)
        for (const CombTooth& tooth : comb.teeth) {
            if (comb.across == Direction::V) {
                expectTowards(tooth, Vec3(0));
            } else {
                EXPECT_LT(glm::length(tooth.curvature), 1e-13);
            }
        }
    EXPECT_NEAR(curvatureOfMost(combs, 1), 1, 1e-12);
}

TEST(IsoCombs, FollowATransformThatStretches)
{
    Mat4 stretched(1);
    stretched[1][1] = 2;  // circles become ellipses of 3 and 6
    for (const IsoComb& comb : isoCombs(cylinder(Vec3(0), 3, 1), stretched, 2, 4)) {
        if (comb.across == Direction::U)
            continue;
        for (const CombTooth& tooth : comb.teeth) {
            const double c = tooth.foot.x / 3;
            const double s = tooth.foot.y / 6;
            EXPECT_NEAR(glm::length(tooth.curvature), 18 / std::pow(9 * s * s + 36 * c * c, 1.5), 1e-12);
        }
    }
}

TEST(IsoCombs, ShowAJumpAtAKnotFromBothSides)
{
    // Two quadratic spans along u that meet smoothly: a straight one, then a parabola.
    const KnotVector along = KnotVector::create(2, {0, 0, 0, 1, 2, 2, 2}).value();
    const NurbsSurface sheet = NurbsSurface::create(along, KnotVector::clampedUniform(1, 1),
                                                    {{{0, 0, 0}},
                                                     {{0, 1, 0}},
                                                     {{1, 0, 0}},
                                                     {{1, 1, 0}},
                                                     {{3, 0, 0}},
                                                     {{3, 1, 0}},
                                                     {{4, 0, 5}},
                                                     {{4, 1, 5}}})
                                   .value();
    for (const IsoComb& comb : isoCombs(sheet, Mat4(1), 1, 3)) {
        if (comb.across == Direction::U)
            continue;
        EXPECT_EQ(comb.parameter, 0.5);
        ASSERT_EQ(comb.teeth.size(), 8U);
        EXPECT_EQ(comb.teeth[3].foot, comb.teeth[4].foot);
        EXPECT_LT(glm::length(comb.teeth[3].curvature), 1e-13);
        EXPECT_GT(glm::length(comb.teeth[4].curvature), 1);
    }
}

TEST(IsoCombs, TellWhatMostTeethDoNotExceed)
{
    std::vector<IsoComb> combs(1);
    EXPECT_EQ(curvatureOfMost(combs, 1), 0);
    combs[0].teeth = {{{}, {3, 0, 0}}, {{}, {0, 1, 0}},   {{}, {0, 0, 2}},
                      {{}, {0, 0, 0}}, {{}, {0, 900, 0}}, {{}, {0, 4, 0}}};
    EXPECT_EQ(curvatureOfMost(combs, 1), 900);
    EXPECT_EQ(curvatureOfMost(combs, 0.8), 4);
    EXPECT_EQ(curvatureOfMost(combs, 0), 1);
}

TEST(IsoCombs, HaveNoTeethAtAPole)
{
    for (const IsoComb& comb : isoCombs(sphere(Vec3(0), 2), Mat4(1), 3, 4))
        for (const CombTooth& tooth : comb.teeth) {
            const double away = std::hypot(tooth.foot.x, tooth.foot.y);
            if (comb.across == Direction::U) {
                expectTowards(tooth, Vec3(0));
            } else if (away < 1e-12) {
                EXPECT_EQ(tooth.curvature, Vec3(0));
            }
        }
    EXPECT_TRUE(isoCombs(sphere(Vec3(0), 2), Mat4(1), 0, 4).empty());
}

// Those of the whole surface that stand on what is left, and no comb runs across a hole.
TEST(IsoCombs, OfATrimmedSurfaceStandOnWhatIsLeft)
{
    const NurbsSurface pipe = testing::roundSurface();
    const double middle = (pipe.knotsV().domainStart() + pipe.knotsV().domainEnd()) / 2;
    const std::vector<TrimLoop> hole{{true,
                                      {testing::polyline({{0, pipe.knotsV().domainStart()},
                                                          {1, pipe.knotsV().domainStart()},
                                                          {1, pipe.knotsV().domainEnd()},
                                                          {0, pipe.knotsV().domainEnd()},
                                                          {0, pipe.knotsV().domainStart()}})}},
                                     {false, {testing::circle({0.5, middle}, 0.2, false)}}};
    const TrimRegion region(hole, pipe);
    const auto whole = isoCombs(pipe, Mat4(1), 3, 40);
    const auto parts = isoCombs(pipe, Mat4(1), 3, 40, hole);
    EXPECT_EQ(parts.size(), whole.size() + 2);  // both in the middle are cut in two
    size_t teeth = 0;
    for (const IsoComb& part : parts) {
        teeth += part.teeth.size();
        double longest = 0;
        for (size_t k = 1; k < part.teeth.size(); ++k)
            longest = std::max(longest, glm::distance(part.teeth[k].foot, part.teeth[k - 1].foot));
        double cell = 0;
        for (const IsoComb& comb : whole)
            if (comb.across == part.across && comb.parameter == part.parameter)
                for (size_t k = 1; k < comb.teeth.size(); ++k)
                    cell = std::max(cell, glm::distance(comb.teeth[k].foot, comb.teeth[k - 1].foot));
        EXPECT_LE(longest, cell);
    }
    size_t all = 0;
    for (const IsoComb& comb : whole)
        all += comb.teeth.size();
    EXPECT_LT(teeth, all - 20);
    EXPECT_GT(teeth, all / 2);
}

}  // namespace
}  // namespace knotspan
