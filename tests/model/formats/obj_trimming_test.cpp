// Trimming curves, loops and holes of OBJ files.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/formats/obj_format.h"
#include "obj_text.h"

namespace knotspan {
namespace {

using testing::polygon;
using testing::sceneOf;
using testing::sixPointSurface;
using testing::sixVertices;

std::vector<TrimLoop> loopsOf(const std::string& curves, const std::string& statements)
{
    const Scene scene = sceneOf(sixVertices() + curves + sixPointSurface(statements));
    return scene.objects().empty() ? std::vector<TrimLoop>{} : scene.objects().begin()->second->trimLoops;
}

std::vector<Vec2> cornersOf(const TrimCurve& curve)
{
    std::vector<Vec2> corners;
    for (const TrimPoint& point : curve.points())
        corners.push_back(point.position);
    return corners;
}

const std::string kSquare = polygon("0.25 0.25  0.75 0.25  0.75 0.75  0.25 0.75  0.25 0.25");
const std::vector<Vec2> kCorners{{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}, {0.25, 0.25}};
const std::vector<Vec2> kCornersBackwards(kCorners.rbegin(), kCorners.rend());

TEST(ObjTrimming, KeepsLoopsAndHolesInTheirOrder)
{
    const auto loops = loopsOf(polygon("0 0  1 0  1 1  0 0") + polygon("0.5 0.2  0.6 0.3  0.6 0.2  0.5 0.2"),
                               "trim 0 3 1\nhole 0 3 2\n");
    ASSERT_EQ(loops.size(), 2u);
    EXPECT_TRUE(loops[0].outer);
    EXPECT_FALSE(loops[1].outer);
    EXPECT_EQ(cornersOf(loops[0].curves.at(0)), (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 0}}));
    EXPECT_EQ(cornersOf(loops[1].curves.at(0)),
              (std::vector<Vec2>{{0.5, 0.2}, {0.6, 0.3}, {0.6, 0.2}, {0.5, 0.2}}));
    EXPECT_EQ(loops[0].curves[0].knots().values(), (std::vector<double>{0, 0, 1, 2, 3, 3}));
}

TEST(ObjTrimming, TurnsLoopsSoThatTheFaceLiesToTheirLeft)
{
    EXPECT_EQ(cornersOf(loopsOf(kSquare, "trim 0 4 1\n").at(0).curves.at(0)), kCorners);
    EXPECT_EQ(cornersOf(loopsOf(kSquare, "trim 0 4 1\nhole 0 4 -1\n").at(1).curves.at(0)), kCornersBackwards);
    const auto turned = loopsOf(kSquare, "trim 4 2 1 2 0 1\n").at(0);
    ASSERT_EQ(turned.curves.size(), 2u);
    EXPECT_EQ(cornersOf(turned.curves[0]), (std::vector<Vec2>{{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}}));
    EXPECT_EQ(cornersOf(turned.curves[1]), (std::vector<Vec2>{{0.75, 0.75}, {0.25, 0.75}, {0.25, 0.25}}));
}

TEST(ObjTrimming, GivesASurfaceWithHolesOnlyItsOwnBorder)
{
    const auto loops = loopsOf(kSquare, "hole 0 4 1\n");
    ASSERT_EQ(loops.size(), 2u);
    EXPECT_TRUE(loops[0].outer);
    ASSERT_EQ(loops[0].curves.size(), 4u);
    const Vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    for (size_t side = 0; side < 4; ++side)
        EXPECT_EQ(cornersOf(loops[0].curves[side]), (std::vector<Vec2>{corners[side], corners[side + 1]}));
}

// A circle of four rational quadratic pieces around (0.5, 0.5).
std::string circle()
{
    std::string text;
    const double directions[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                     {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    for (int k = 0; k < 9; ++k)
        text += "vp " + std::to_string(0.5 + 0.25 * directions[k][0]) + " " +
                std::to_string(0.5 + 0.25 * directions[k][1]) + (k % 2 == 1 ? " 0.70710678118654752" : "") +
                "\n";
    return text + "cstype rat bezier\ndeg 2\ncurv2 1 2 3 4 5 6 7 8 -1\nparm u 0 1 2 3 4\nend\n";
}

TEST(ObjTrimming, CutsTheStatedPartsOutOfRationalCurvesExactly)
{
    const auto loops = loopsOf(circle() + polygon("0 0 1 1"), "trim 0.5 2.25 1 2.25 4 1 0 0.5 1\n");
    ASSERT_EQ(loops.size(), 1u);
    ASSERT_EQ(loops[0].curves.size(), 3u);
    for (size_t k = 0; k < 3; ++k) {
        const TrimCurve& curve = loops[0].curves[k];
        const double start = curve.knots().domainStart();
        const double end = curve.knots().domainEnd();
        EXPECT_EQ(start, (std::vector<double>{0.5, 2.25, 0})[k]);
        EXPECT_EQ(end, (std::vector<double>{2.25, 4, 0.5})[k]);
        for (const double share : {0.0, 0.3, 0.7, 1.0})
            EXPECT_NEAR(glm::distance(curve.evaluate(std::lerp(start, end, share)), Vec2(0.5)), 0.25, 1e-15);
        const TrimCurve& next = loops[0].curves[(k + 1) % 3];
        EXPECT_LT(glm::distance(curve.evaluate(end), next.evaluate(next.knots().domainStart())), 1e-15);
    }
}

TEST(ObjTrimming, LeavesASurfaceUntrimmedWhereALoopIsNoneAndSaysWhy)
{
    const auto note = [](const std::string& curves, const std::string& statements) {
        const auto import = formats::sceneFromObj(sixVertices() + curves + sixPointSurface(statements));
        EXPECT_TRUE(import && import->notes.size() == 1 &&
                    import->scene.objects().begin()->second->trimLoops.empty());
        return import && !import->notes.empty() ? import->notes[0] : "";
    };
    EXPECT_EQ(
        note(kSquare, "trim 0 5 1\n"),
        "1 of 1 surfaces was read without trim curves; the first reason is: line 19: Trimming curve 1: The "
        "range 0 to 5 leaves the knots' domain 0 to 4.");
    EXPECT_EQ(
        note("vp 0 0\nvp 1 1\ncstype bspline\ndeg 1\ncurv2 1 2\nparm u 1 1 0 0\nend\n", "trim 0 1 1\n"),
        "1 of 1 surfaces was read without trim curves; the first reason is: line 16: Trimming curve 1 is "
        "none: Knot 2 is smaller than the one before it.");
}

}  // namespace
}  // namespace knotspan
