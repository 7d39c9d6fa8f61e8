// What tells whether a file lost anything must see each thing that can be lost.
#include <gtest/gtest.h>

#include "model/formats/scene_difference.h"
#include "tests/model/formats/odd_scenes.h"

namespace knotspan {
namespace {

using formats::differenceBetween;

Scene scene()
{
    return testing::trimmedScenes()[1].scene;
}

// The scene with its only object changed.
template <class Change>
Scene changed(Change change)
{
    Scene result = scene();
    SceneObject object = *result.find(ObjectId{0});
    change(object);
    result.exchange(ObjectId{0}, std::make_shared<SceneObject>(std::move(object)));
    return result;
}

template <class Change>
Scene withPoint(Change change)
{
    return changed([&](SceneObject& object) {
        std::vector<ControlPoint> points = object.surface.controlPoints();
        change(points[7]);
        object.surface = *NurbsSurface::create(object.surface.knotsU(), object.surface.knotsV(), points);
    });
}

TEST(SceneDifference, IsNothingForTheSameScene)
{
    const auto difference = differenceBetween(scene(), scene());
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->largest(), 0);
    EXPECT_EQ(difference->names, 0);
    EXPECT_EQ(difference->colours, 0);
}

TEST(SceneDifference, SeesControlPointsRelativeToTheLargestCoordinate)
{
    const auto difference =
        differenceBetween(scene(), withPoint([](ControlPoint& p) { p.position.x += 1e-9; }));
    ASSERT_TRUE(difference);
    EXPECT_GT(difference->controlPoints, 1e-11);
    EXPECT_LT(difference->controlPoints, 1e-9);
    EXPECT_EQ(difference->largest(), difference->controlPoints);
}

TEST(SceneDifference, SeesWeightsButNoCommonFactor)
{
    const auto one = differenceBetween(scene(), withPoint([](ControlPoint& p) { p.weight *= 1 + 1e-10; }));
    ASSERT_TRUE(one);
    EXPECT_NEAR(one->weights, 1e-10, 1e-13);
    const auto all = differenceBetween(scene(), changed([](SceneObject& object) {
                                           std::vector<ControlPoint> points = object.surface.controlPoints();
                                           for (ControlPoint& point : points)
                                               point.weight *= 4;
                                           object.surface = *NurbsSurface::create(
                                               object.surface.knotsU(), object.surface.knotsV(), points);
                                       }));
    ASSERT_TRUE(all);
    EXPECT_EQ(all->largest(), 0);
}

TEST(SceneDifference, SeesKnotsTrimCurvesNamesAndColours)
{
    const auto knots = differenceBetween(scene(), changed([](SceneObject& object) {
                                             std::vector<double> values = object.surface.knotsU().values();
                                             values[5] += 1e-9;
                                             object.surface = *NurbsSurface::create(
                                                 *KnotVector::create(3, values), object.surface.knotsV(),
                                                 object.surface.controlPoints());
                                         }));
    ASSERT_TRUE(knots);
    EXPECT_NEAR(knots->knots, 1e-9, 1e-12);
    const auto other = differenceBetween(scene(), changed([](SceneObject& object) {
                                             TrimCurve& curve = object.trimLoops[1].curves[0];
                                             std::vector<TrimPoint> points = curve.points();
                                             points[3].position.y += 1e-9;
                                             curve = *TrimCurve::create(curve.knots(), points);
                                             object.name = "other";
                                             object.colour.green += 0.01;
                                         }));
    ASSERT_TRUE(other);
    EXPECT_NEAR(other->trimCurves, 1e-9, 1e-12);
    EXPECT_EQ(other->names, 1);
    EXPECT_EQ(other->colours, 1);
}

TEST(SceneDifference, DoesNotCareWhichLoopComesFirst)
{
    const auto difference = differenceBetween(
        scene(), changed([](SceneObject& object) { std::swap(object.trimLoops[0], object.trimLoops[1]); }));
    ASSERT_TRUE(difference) << difference.error().sentence();
    EXPECT_EQ(difference->largest(), 0);
}

TEST(SceneDifference, DoesNotCareWhereALoopBegins)
{
    const auto difference =
        differenceBetween(scene(), changed([](SceneObject& object) {
                              auto& curves = object.trimLoops[0].curves;
                              std::rotate(curves.begin(), curves.begin() + 1, curves.end());
                          }));
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->largest(), 0);
}

TEST(SceneDifference, ConvertsUnitsAndAppliesTransforms)
{
    Scene metres = scene();
    metres.setUnits("m");
    Scene millimetres = changed([](SceneObject& object) {
        object.transform = Mat4(1000.0);
        object.transform[3][3] = 1;
    });
    EXPECT_LE(differenceBetween(metres, millimetres).value().largest(), 1e-15);
    EXPECT_NEAR(differenceBetween(scene(), millimetres).value().controlPoints, 999, 1e-6);
    metres.setUnits("ell");
    EXPECT_EQ(differenceBetween(metres, millimetres).error().what,
              "The lengths are in \"ell\" here and in \"mm\" there");
}

TEST(SceneDifference, SaysInASentenceWhereTheStructureDiffers)
{
    Scene two = scene();
    two.add(*two.find(ObjectId{0}));
    EXPECT_EQ(differenceBetween(scene(), two).error().what,
              "The numbers of surfaces differ: 1 here, 2 there");
    const Scene uncut = changed([](SceneObject& object) { object.trimLoops.clear(); });
    EXPECT_EQ(differenceBetween(scene(), uncut).error().what,
              "\"trimmed\" differs in its number of trim loops: 2 here, 0 there");
    const Scene finer = changed([](SceneObject& object) {
        object.surface =
            testing::wavySurface(KnotVector::clampedUniform(3, 5), KnotVector::clampedUniform(2, 5), 0);
    });
    EXPECT_EQ(differenceBetween(scene(), finer).error().what,
              "\"trimmed\" has degree 3 x 2 with 7 x 7 control points here and degree 3 x 2 with 8 x 7 "
              "control points "
              "there");
    const Scene straight = changed([](SceneObject& object) {
        auto& curves = object.trimLoops[0].curves;
        curves[1] = curves[0];
    });
    EXPECT_EQ(differenceBetween(scene(), straight).error().what, "\"trimmed\" has other trim curves there");
}

}  // namespace
}  // namespace knotspan
