// Objects moved by numbers, mirrored, duplicated.
#include "model/making/object_making.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "model/analysis/shells.h"
#include "model/geometry/evaluation.h"
#include "model/making/shapes.h"
#include "tests/model/making/making_samples.h"
#include "tests/model/scene/simple_object.h"

namespace knotspan::testing {

namespace {

SceneObject anyObject(std::mt19937& random)
{
    SceneObject object = simpleObject("Bow");
    object.surface = randomSurface(random, {});
    object.sides = Sides::front;
    object.transform = placementMatrix(randomPlacement(random, 3)).value();
    return object;
}

Vec3 inModel(const SceneObject& object, double u, double v)
{
    return transformed(evaluate(object.surface, u, v).position, object.transform);
}

// As the renderer has it: the cofactors' normal, turned over where the transform mirrors.
Vec3 frontAt(const SceneObject& object, double u, double v)
{
    const glm::dmat3 m(object.transform);
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const double facing = glm::determinant(m) < 0 ? -1 : 1;
    return facing * glm::normalize(cofactors * evaluateNormal(object.surface, u, v).direction);
}

Vec3 reflected(const Vec3& vector, const Vec3& normal)
{
    return vector - 2 * glm::dot(vector, normal) / glm::dot(normal, normal) * normal;
}

}  // namespace

TEST(Mirroring, MovesEveryPointToItsImageAndTheFrontWithIt)
{
    std::mt19937 random(41);
    for (int round = 0; round < 20; ++round) {
        const SceneObject object = anyObject(random);
        const MirrorPlane plane{randomVector(random, 3), randomVector(random, 1)};
        const auto image = mirrored(object, plane);
        ASSERT_TRUE(image) << image.error().sentence();
        EXPECT_EQ(image->surface, object.surface);
        EXPECT_EQ(image->sides, object.sides);
        EXPECT_LT(glm::determinant(image->transform), 0);
        for (int k = 0; k < 20; ++k) {
            const double u = randomIn(random, object.surface.knotsU());
            const double v = randomIn(random, object.surface.knotsV());
            const Vec3 expected = plane.point + reflected(inModel(object, u, v) - plane.point, plane.normal);
            EXPECT_LE(glm::distance(inModel(*image, u, v), expected), 1e-13);
            EXPECT_LE(glm::distance(frontAt(*image, u, v), reflected(frontAt(object, u, v), plane.normal)),
                      1e-12);
        }
    }
}

TEST(Mirroring, TwiceInACoordinatePlaneGivesTheObjectToTheBit)
{
    std::mt19937 random(42);
    for (const Vec3 normal : {Vec3(1, 0, 0), Vec3(0, -7, 0), Vec3(0, 0, 1e-9)}) {
        const SceneObject object = anyObject(random);
        const auto image = mirrored(object, {Vec3(0), normal});
        EXPECT_NE(*image, object);
        EXPECT_EQ(mirrored(*image, {Vec3(0), normal}).value(), object);
    }
}

TEST(Mirroring, LeavesTheOutsideOfABodyOnTheSameSide)
{
    std::mt19937 random(45);
    const auto side = [](const SceneObject& object) {
        const std::vector<PlacedSurface> surfaces{{&object.surface, object.transform}};
        return Shells(surfaces, CoincidentEdges(surfaces)).side(0);
    };
    for (const auto& surface :
         {sphereShape(randomPlacement(random, 3), 2), torusShape(randomPlacement(random, 3), 2, 0.5)}) {
        SceneObject object = simpleObject("Body");
        object.surface = *surface;
        EXPECT_EQ(side(object), 1);
        EXPECT_EQ(side(*mirrored(object, {{1, 2, 3}, {1, -1, 2}})), 1);
    }
}

TEST(Mirroring, RefusesWhatIsNoPlane)
{
    const SceneObject object = simpleObject("Bow");
    EXPECT_FALSE(mirrored(object, {Vec3(0), Vec3(0)}));
    EXPECT_FALSE(mirrored(object, {Vec3(0), {0, std::nan(""), 0}}));
    EXPECT_FALSE(mirrored(object, {{std::numeric_limits<double>::infinity(), 0, 0}, {1, 0, 0}}));
}

TEST(TransformNumbers, ScaleTurnAndMoveInThisOrder)
{
    std::mt19937 random(43);
    for (int round = 0; round < 50; ++round) {
        const TransformNumbers numbers{randomVector(random, 5), randomVector(random, 400),
                                       randomVector(random, 3), randomVector(random, 5)};
        Mat4 expected = glm::translate(Mat4(1.0), numbers.pivot + numbers.translation);
        expected = glm::rotate(expected, glm::radians(numbers.degrees.z), Vec3(0, 0, 1));
        expected = glm::rotate(expected, glm::radians(numbers.degrees.y), Vec3(0, 1, 0));
        expected = glm::rotate(expected, glm::radians(numbers.degrees.x), Vec3(1, 0, 0));
        expected = glm::translate(glm::scale(expected, numbers.scale), -numbers.pivot);
        const auto matrix = transformMatrix(numbers);
        ASSERT_TRUE(matrix) << matrix.error().sentence();
        for (int column = 0; column < 4; ++column)
            EXPECT_LE(glm::distance((*matrix)[column], expected[column]), 1e-13);
    }
}

TEST(TransformNumbers, AreExactWhereNumbersAre)
{
    EXPECT_EQ(transformMatrix({}).value(), Mat4(1.0));
    TransformNumbers numbers;
    numbers.translation = {0.1, 0.2, 0.3};
    numbers.pivot = {1e17, -3, 7.7};
    EXPECT_EQ(transformMatrix(numbers).value()[3], Vec4(0.1, 0.2, 0.3, 1));
    numbers = {};
    numbers.degrees = {0, 0, 90};
    EXPECT_EQ(transformMatrix(numbers).value()[0], Vec4(0, 1, 0, 0));
    numbers.degrees = {-270, 180, 0};
    numbers.scale = {2, 3, 4};
    const Mat4 matrix = transformMatrix(numbers).value();
    EXPECT_EQ(matrix[0], Vec4(-2, 0, 0, 0));
    EXPECT_EQ(matrix[1], Vec4(0, 0, -3, 0));
    EXPECT_EQ(matrix[2], Vec4(0, -4, 0, 0));
}

TEST(TransformNumbers, RefuseWhatCouldNotBeUndone)
{
    const double nan = std::nan("");
    EXPECT_FALSE(transformMatrix({{nan, 0, 0}}));
    EXPECT_FALSE(transformMatrix({Vec3(0), {0, nan, 0}}));
    EXPECT_FALSE(transformMatrix({Vec3(0), Vec3(0), {1, 1, nan}}));
    EXPECT_FALSE(transformMatrix({Vec3(0), Vec3(0), {1, 0, 1}}));
    EXPECT_FALSE(transformMatrix({Vec3(0), Vec3(0), Vec3(1), {nan, 0, 0}}));
    EXPECT_TRUE(transformMatrix({Vec3(0), Vec3(0), {-1, 1, 1}}));
    const SceneObject object = simpleObject("Bow");
    EXPECT_FALSE(moved(object, Mat4(0.0)));
    EXPECT_FALSE(moved(object, Mat4(nan)));
    Mat4 far(1.0);
    far[3].x = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(moved(object, far));
}

TEST(Duplicating, GivesAFreeNameAndNothingElseNew)
{
    Scene scene;
    for (const char* const name : {"Bow", "Bow 2", "Bow 4", "2", "Part 007", ""})
        scene.add(simpleObject(name));
    const auto nameAfter = [&](const char* name) { return duplicated(simpleObject(name), scene).name; };
    EXPECT_EQ(nameAfter("Bow"), "Bow 3");
    EXPECT_EQ(nameAfter("Bow 4"), "Bow 5");
    EXPECT_EQ(nameAfter("Bow 2"), "Bow 3");
    EXPECT_EQ(nameAfter("2"), "2 2");
    EXPECT_EQ(nameAfter("Part 007"), "Part 007 2");
    EXPECT_EQ(nameAfter("Deck "), "Deck  2");
    EXPECT_EQ(nameAfter(""), "");
    SceneObject copy = duplicated(simpleObject("Bow"), scene);
    copy.name = "Bow";
    EXPECT_EQ(copy, simpleObject("Bow"));
}

TEST(Duplicating, AnIsoCurveOfAnObjectLiesOnItInTheModel)
{
    std::mt19937 random(44);
    const SceneObject object = anyObject(random);
    const double u = randomIn(random, object.surface.knotsU());
    const NurbsCurve curve = isoCurveInModel(object, Direction::U, u).value();
    for (int k = 0; k < 30; ++k) {
        const double v = randomIn(random, object.surface.knotsV());
        EXPECT_LE(glm::distance(evaluate(curve, v), inModel(object, u, v)), 1e-13);
    }
    EXPECT_FALSE(isoCurveInModel(object, Direction::U, std::nan("")));
}

}  // namespace knotspan::testing
