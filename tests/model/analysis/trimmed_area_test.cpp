// What trim loops leave of surfaces, against closed forms.
#include "model/analysis/trimmed_area.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/geometry/primitives.h"
#include "tests/model/trimming/loop_samples.h"

namespace knotspan::testing {
namespace {

constexpr double kPi = std::numbers::pi;

void expectArea(const Area& found, double exact, const std::string& what)
{
    EXPECT_NEAR(found.value, exact, 1e-9 * exact) << what;
    EXPECT_LE(std::abs(found.value - exact), found.error + 1e-13 * exact)
        << what << ": the estimate covers it";
    EXPECT_LT(found.error, 1e-5 * exact) << what;
}

const TrimLoop kBorder{true, {polyline({{-1, 10}, {3, 10}, {3, 12}, {-1, 12}, {-1, 10}})}};

TEST(TrimmedArea, OfCirclesAcrossKnotLines)
{
    const TrimLoop disc{true, {circle({0.5, 11}, 0.9)}};
    const TrimLoop hole{false, {circle({0.5, 11}, 0.4, false)}};
    expectArea(trimmedArea(flatSurface(), {disc}, Mat4(1)), kPi * 0.81, "a disc");
    expectArea(trimmedArea(flatSurface(), {disc, hole}, Mat4(1)), kPi * (0.81 - 0.16), "a ring");
    expectArea(trimmedArea(flatSurface(), {hole}, Mat4(1)), 8 - kPi * 0.16, "a hole alone");
    expectArea(trimmedArea(flatSurface(), {kBorder, hole}, Mat4(1)), 8 - kPi * 0.16, "a plate with a hole");
    expectArea(trimmedArea(flatSurface(), {kBorder}, Mat4(1)), 8, "a plate");
    EXPECT_EQ(trimmedArea(flatSurface(), {}, Mat4(1)).value, surfaceArea(flatSurface(), Mat4(1)).value);
}

TEST(TrimmedArea, OfLoopsThatCrossTouchOrRunAlongEachOther)
{
    // A bow tie: two triangles of which each is 1/2 high and 1 wide.
    const TrimLoop tie{true, {polyline({{0, 10.5}, {2, 11.5}, {2, 10.5}, {0, 11.5}, {0, 10.5}})}};
    expectArea(trimmedArea(flatSurface(), {tie}, Mat4(1)), 1, "a bow tie");
    // Two discs that share a lens, which is twice in and so out.
    const double apart = 0.6;
    const double lens = 2 * 0.25 * std::acos(apart) - apart / 2 * std::sqrt(1 - apart * apart);
    expectArea(trimmedArea(flatSurface(),
                           {{true, {circle({0.5, 11}, 0.5)}}, {true, {circle({0.5 + apart, 11}, 0.5)}}},
                           Mat4(1)),
               2 * (kPi * 0.25 - lens), "two discs that cross");
    const TrimLoop left{false, {polyline({{0, 10.5}, {0, 11.5}, {0.7, 11.5}, {0.7, 10.5}, {0, 10.5}})}};
    const TrimLoop right{false, {polyline({{0.7, 10.5}, {0.7, 11.5}, {2, 11.5}, {2, 10.5}, {0.7, 10.5}})}};
    expectArea(trimmedArea(flatSurface(), {kBorder, left, right}, Mat4(1)), 6, "two holes side by side");
    const TrimLoop point{true, {polyline({{2, 10.5}, {2.5, 11}, {2, 11.5}, {1.5, 11}, {2, 10.5}})}};
    const TrimLoop other{true, {polyline({{1, 10.5}, {1.5, 11}, {1, 11.5}, {0.5, 11}, {1, 10.5}})}};
    expectArea(trimmedArea(flatSurface(), {point, other}, Mat4(1)), 1, "two squares that touch at a corner");
}

// By Archimedes a zone of a sphere is as large as that of the cylinder around it; here between circles of v,
// whose parameters a test of its own finds.
TEST(TrimmedArea, OfZonesAndSectorsOfASphere)
{
    const NurbsSurface ball = sphere(Vec3(0), 2);
    const double around = ball.knotsU().domainEnd();
    const double middle = (ball.knotsV().domainStart() + ball.knotsV().domainEnd()) / 2;
    const TrimLoop northern{true, {polyline({{0, middle}, {around, middle}})}};
    expectArea(trimmedArea(ball, {northern}, Mat4(1)), 2 * kPi * 4, "half a sphere");
    // A quarter of the way around from pole to pole, off the knots: the sector's angle by its corner.
    const double u = 0.3 * around;
    const double top = ball.knotsV().domainEnd();
    const TrimLoop sector{true, {polyline({{0, 0}, {u, 0}, {u, top}, {0, top}, {0, 0}})}};
    const Vec3 corner = evaluate(ball, u, middle).position;
    double angle = std::atan2(corner.y, corner.x);
    if (angle < 0)
        angle += 2 * kPi;
    expectArea(trimmedArea(ball, {sector}, Mat4(1)), 4 * kPi * 4 * angle / (2 * kPi), "a sector of a sphere");
}

TEST(TrimmedArea, StretchesWithTheTransform)
{
    Mat4 matrix(1.0);
    matrix[0][0] = 3;
    matrix[1][1] = -2;
    matrix[3] = Vec4(1e5, 7, 1, 1);
    expectArea(trimmedArea(flatSurface(), {{true, {circle({0.5, 11}, 0.9)}}}, matrix), 6 * kPi * 0.81,
               "an ellipse");
}

TEST(TrimmedArea, OfLoopsThatCannotBeFollowedIsThatOfTheWhole)
{
    const TrimLoop open{true, {polyline({{0, 10.5}, {1, 10.5}, {1, 11.5}})}};
    EXPECT_NEAR(trimmedArea(flatSurface(), {open}, Mat4(1)).value, 8, 1e-12);
    EXPECT_TRUE(std::isinf(trimmedArea(flatSurface(), {kBorder}, Mat4(1), [] { return true; }).error));
}

}  // namespace
}  // namespace knotspan::testing
