#include "model/scene/control_point_editing.h"

#include <cmath>
#include <limits>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/model/scene/simple_object.h"

namespace knotspan {
namespace {

TEST(ControlPointEditing, MovesOnePointAndLeavesTheOriginalAlone)
{
    const SceneObject object = testing::simpleObject("sheet");
    const auto moved = withControlPointAt(object, {1, 0}, {2, 0.1, 5.3});
    ASSERT_TRUE(moved);
    EXPECT_EQ((*moved)->surface.controlPoint(1, 0).position, Vec3(2, 0.1, 5.3)) << "to the bit";
    EXPECT_EQ(object.surface.controlPoint(1, 0).position, Vec3(2, 0, 0));
    EXPECT_EQ((*moved)->surface.controlPoint(0, 1), object.surface.controlPoint(0, 1));
    EXPECT_EQ((*moved)->name, "sheet");
}

TEST(ControlPointEditing, KeepsWeightAndTrimLoops)
{
    SceneObject object = testing::simpleObject("ball");
    object.surface = sphere({0, 0, 0}, 1);
    const auto line = TrimCurve::create(KnotVector::clampedUniform(1, 1), {{{0, 0}, 1}, {{1, 1}, 1}});
    ASSERT_TRUE(line);
    object.trimLoops = {{true, {*line}}};
    const auto moved = withControlPointAt(object, {3, 3}, {9, 9, 9});
    ASSERT_TRUE(moved);
    EXPECT_EQ((*moved)->surface.controlPoint(3, 3).weight, object.surface.controlPoint(3, 3).weight);
    EXPECT_EQ((*moved)->trimLoops, object.trimLoops);
}

TEST(ControlPointEditing, UnderstandsPositionsInModelSpace)
{
    SceneObject object = testing::simpleObject("turned");
    object.transform =
        glm::rotate(glm::translate(Mat4(1.0), Vec3(10, 20, 30)), std::acos(-1.0) / 2, Vec3(0, 0, 1));
    EXPECT_LE(glm::length(controlPointInModel(object, {1, 0}) - Vec3(10, 22, 30)), 1e-13);
    const auto moved = withControlPointAt(object, {1, 0}, {10, 25, 31});
    ASSERT_TRUE(moved);
    EXPECT_LE(glm::length((*moved)->surface.controlPoint(1, 0).position - Vec3(5, 0, 1)), 1e-13);
    EXPECT_LE(glm::length(controlPointInModel(**moved, {1, 0}) - Vec3(10, 25, 31)), 1e-13);
}

TEST(ControlPointEditing, RefusesAPositionThatIsNotFiniteWithASentence)
{
    const auto refused = withControlPointAt(testing::simpleObject("sheet"), {0, 0},
                                            {0, std::numeric_limits<double>::infinity(), 0});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().sentence(),
              "The control point would go infinitely far away. Drag it less far.");
}

}  // namespace
}  // namespace knotspan
