// A trim loop of 10,000 pieces, as scanners and traced pictures give them, through files and back.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "model/formats/format_list.h"
#include "model/formats/scene_difference.h"
#include "tests/support.h"

namespace knotspan {
namespace {

TrimCurve line(const Vec2& from, const Vec2& to)
{
    return TrimCurve::create(KnotVector::clampedUniform(1, 1), {{from}, {to}}).value();
}

TrimLoop closedThrough(const std::vector<Vec2>& corners, bool outer)
{
    TrimLoop loop{outer, {}};
    for (size_t k = 0; k < corners.size(); ++k)
        loop.curves.push_back(line(corners[k], corners[(k + 1) % corners.size()]));
    return loop;
}

// Of lines, with half as many points; a hole runs clockwise.
TrimLoop star(int pieces, bool outer)
{
    std::vector<Vec2> corners;
    for (int k = 0; k < pieces; ++k) {
        const double angle = (outer ? 2 : -2) * std::numbers::pi * k / pieces;
        const double radius = k % 2 == 0 ? 0.3 : 0.45;
        corners.push_back(Vec2(0.5) + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return closedThrough(corners, outer);
}

// Bent, so that lines in (u, v) are curves in space.
NurbsSurface sheet()
{
    const KnotVector knots = KnotVector::clampedUniform(3, 1);
    std::vector<ControlPoint> points;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            points.push_back({{100.0 * i / 3, 100.0 * j / 3, i * i * j}});
    return NurbsSurface::create(knots, knots, points).value();
}

// Closed along u.
NurbsSurface tube()
{
    const Vec2 corners[] = {{0, 0}, {9, 0}, {9, 9}, {-9, 9}, {-9, 0}, {0, 0}};
    std::vector<ControlPoint> points;
    for (const Vec2& corner : corners)
        for (const double z : {0.0, 20.0})
            points.push_back({Vec3(corner, z)});
    return NurbsSurface::create(KnotVector::clampedUniform(3, 3), KnotVector::clampedUniform(1, 1), points)
        .value();
}

// Up to a wave of many lines, with the seam on both sides.
TrimLoop belowAWave(int pieces)
{
    std::vector<Vec2> corners{{0, 0}, {1, 0}, {1, 0.5}};
    for (int k = 1; k < pieces; ++k)
        corners.emplace_back(1 - static_cast<double>(k) / pieces,
                             0.5 + 0.2 * std::sin(20.0 * std::numbers::pi * k / pieces));
    corners.emplace_back(0, 0.5);
    return closedThrough(corners, true);
}

formats::SceneDifference differenceAfter(const Scene& scene, const std::string& extension)
{
    const testing::TemporaryFolder folder;
    const auto written = formats::write(scene, folder / ("a" + extension));
    EXPECT_TRUE(written) << (written ? "" : written.error().sentence());
    auto back = formats::find("a" + extension)->read(folder / ("a" + extension));
    EXPECT_TRUE(back) << (back ? "" : back.error().sentence());
    const Result<formats::SceneDifference> difference =
        back ? formats::differenceBetween(scene, back->scene) : failure("Nothing is read", "");
    EXPECT_TRUE(difference) << (difference ? "" : difference.error().sentence());
    return difference.value_or(formats::SceneDifference{1, 1, 1, 1, 0, 0});
}

class LongLoops : public ::testing::TestWithParam<std::string> {};

// Loops that are more or fewer, and such of other curves, are errors.
TEST_P(LongLoops, OfTenThousandPiecesComeBackPieceByPiece)
{
    Scene scene;
    scene.add({.name = "star", .surface = sheet(), .trimLoops = {star(10000, true)}});
    EXPECT_LE(differenceAfter(scene, GetParam()).largest(), 3e-16);
}

TEST_P(LongLoops, ComeBackAsHolesOnSeamsAndAmongOthersInInches)
{
    const Vec2 square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const TrimLoop border = closedThrough({square, square + 4}, true);
    Scene scene;
    scene.setUnits("in");
    scene.add({.name = "first", .surface = sheet(), .trimLoops = {star(10, true)}});
    scene.add({.name = "hole", .surface = sheet(), .trimLoops = {border, star(450, false)}});
    scene.add({.name = "whole", .surface = tube()});
    scene.add({.name = "wave", .surface = tube(), .trimLoops = {belowAWave(500)}});
    scene.add({.name = "last", .surface = sheet(), .trimLoops = {border, star(12, false)}});
    const formats::SceneDifference difference = differenceAfter(scene, GetParam());
    EXPECT_LE(difference.largest(), 1e-15);
    EXPECT_EQ(difference.names, 0);
    EXPECT_EQ(difference.colours, 0);
}

INSTANTIATE_TEST_SUITE_P(Every, LongLoops, ::testing::Values(".step", ".igs"),
                         [](const auto& format) { return format.param.substr(1); });

}  // namespace
}  // namespace knotspan
