// Brushes against what each is by definition, and against their own mirror images.
#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/geometry/primitives.h"
#include "model/sculpting/best_plane.h"
#include "model/sculpting/brushes.h"
#include "model/sculpting/net_directions.h"
#include "tests/model/sculpting/sculpting_scene.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

constexpr BrushKind kBrushes[] = {BrushKind::grab, BrushKind::smooth, BrushKind::inflate, BrushKind::flatten};

Vec3 anyVector(std::mt19937& random)
{
    return {randomBetween(random, -2, 2), randomBetween(random, -2, 2), randomBetween(random, -2, 2)};
}

SharedObject objectOf(const NurbsSurface& surface, const Mat4& transform = Mat4(1.0))
{
    SceneObject object = *sceneOf({surface}).find(kFirst);
    object.transform = transform;
    return std::make_shared<SceneObject>(object);
}

Vec3 placeIn(const SharedObject& object, int i, int j)
{
    return controlPointInModel(*object, {i, j});
}

// How far from a dab's centre a control point counts: itself, or the surface where it weighs most.
double distanceFrom(const Vec3& centre, const SharedObject& object, int i, int j)
{
    const auto mean = [](const KnotVector& knots, int k) {
        double sum = 0;
        for (int r = 1; r <= knots.degree(); ++r)
            sum += knots[k + r];
        return knots.inDomain(sum / knots.degree());
    };
    const NurbsSurface& surface = object->surface;
    const Vec3 place = transformed(
        evaluate(surface, mean(surface.knotsU(), i), mean(surface.knotsV(), j)).position, object->transform);
    return std::min(glm::distance(placeIn(object, i, j), centre), glm::distance(place, centre));
}

SharedObject done(const SharedObject& object, BrushKind brush, const Dab& dab)
{
    auto result = dabbed(object, brush, dab);
    EXPECT_TRUE(result) << result.error().sentence();
    return *std::move(result);
}

// Calls look(i, j) for all.
template <class Look>
void forPoints(const SharedObject& object, const Look& look)
{
    for (int i = 0; i < object->surface.countU(); ++i)
        for (int j = 0; j < object->surface.countV(); ++j)
            look(i, j);
}

SharedObject mirrorImage(const SharedObject& object, const SymmetryPlane& plane)
{
    std::vector<ControlPoint> points = object->surface.controlPoints();
    for (ControlPoint& point : points)
        point.position = mirrored(point.position, plane);
    return objectOf(
        *NurbsSurface::create(object->surface.knotsU(), object->surface.knotsV(), std::move(points)));
}

double largestDistance(const SharedObject& a, const SharedObject& b)
{
    double largest = 0;
    forPoints(a, [&](int i, int j) {
        largest = std::max(largest, glm::distance(placeIn(a, i, j), placeIn(b, i, j)));
    });
    return largest;
}

}  // namespace

TEST(Brushes, GrabTakesPointsByTheirDistance)
{
    std::mt19937 random(51);
    for (int round = 0; round < 30; ++round) {
        const SharedObject object =
            objectOf(randomSurface(random, {}), round % 2 == 0 ? Mat4(1.0) : anyTransform());
        const Dab dab{placeIn(object, 2, 2), 2.5, 0.75, FalloffShape::sphere, anyVector(random), {}};
        const SharedObject after = done(object, BrushKind::grab, dab);
        forPoints(object, [&](int i, int j) {
            const double x = distanceFrom(dab.centre, object, i, j) / 2.5;
            const double share = x < 1 ? 0.75 * std::sqrt(1 - x * x) : 0;
            EXPECT_LE(glm::distance(placeIn(after, i, j), placeIn(object, i, j) + share * dab.by), 1e-7);
            EXPECT_EQ(after->surface.controlPoint(i, j).weight, object->surface.controlPoint(i, j).weight);
        });
    }
}

TEST(Brushes, ReachAPointThatStandsFarOffTheSurface)
{
    std::mt19937 random(58);
    SharedObject object = objectOf(randomSurface(random, {.spans = 5}));
    std::vector<ControlPoint> points = object->surface.controlPoints();
    const int countV = object->surface.countV();
    points[static_cast<size_t>(3 * countV + 3)].position += Vec3(0, 0, 100);
    object = objectOf(*NurbsSurface::create(object->surface.knotsU(), object->surface.knotsV(), points));
    const double u = grevilleParameter(object->surface.knotsU(), 3);
    const double v = grevilleParameter(object->surface.knotsV(), 3);
    const Vec3 top = evaluate(object->surface, u, v).position;
    const SharedObject after = done(object, BrushKind::smooth, {top, 1, 0.5, FalloffShape::smooth, {}, {}});
    EXPECT_LT(placeIn(after, 3, 3).z, placeIn(object, 3, 3).z - 20);
}

TEST(Brushes, SmoothGoesTowardsTheNeighboursMean)
{
    std::mt19937 random(52);
    const SharedObject object = objectOf(randomSurface(random, {.spans = 5}), anyTransform());
    const int lastU = object->surface.countU() - 1;
    const int lastV = object->surface.countV() - 1;
    const SharedObject after =
        done(object, BrushKind::smooth, {{0, 0, 0}, 1e6, 0.5, FalloffShape::constant, {}, {}});
    forPoints(object, [&](int i, int j) {
        const bool borderU = i == 0 || i == lastU;
        const bool borderV = j == 0 || j == lastV;
        const Vec3 here = placeIn(object, i, j);
        Vec3 expected = here;
        if (!borderU && !borderV)
            expected = 0.5 * here + 0.125 * (placeIn(object, i - 1, j) + placeIn(object, i + 1, j) +
                                             placeIn(object, i, j - 1) + placeIn(object, i, j + 1));
        else if (!borderU)
            expected = 0.5 * here + 0.25 * (placeIn(object, i - 1, j) + placeIn(object, i + 1, j));
        else if (!borderV)
            expected = 0.5 * here + 0.25 * (placeIn(object, i, j - 1) + placeIn(object, i, j + 1));
        EXPECT_LE(glm::distance(placeIn(after, i, j), expected), 1e-12);
    });
}

TEST(Brushes, SmoothLeavesAPlanesPointsInThePlane)
{
    std::mt19937 random(53);
    const Vec3 u = glm::normalize(Vec3(1, 2, 0.5));
    const Vec3 v = glm::normalize(Vec3(-1, 1, 3));
    const Vec3 normal = glm::normalize(glm::cross(u, v));
    SharedObject object = objectOf(netOfPlaces(8, 7, [&](int i, int j) {
        const bool border = i == 0 || j == 0 || i == 7 || j == 6;
        return (i + (border ? 0 : randomBetween(random, -0.4, 0.4))) * u +
               (j + (border ? 0 : randomBetween(random, -0.4, 0.4))) * v;
    }));
    const SharedObject start = object;
    for (int k = 0; k < 20; ++k)
        object = done(object, BrushKind::smooth,
                      {placeIn(object, k % 8, k % 7), 3, 0.9, FalloffShape::smooth, {}, {}});
    EXPECT_GT(largestDistance(object, start), 0.05);
    forPoints(object, [&](int i, int j) {
        EXPECT_LE(std::abs(glm::dot(normal, placeIn(object, i, j))), 1e-14);
        EXPECT_TRUE(i > 0 || glm::length(glm::cross(placeIn(object, i, j), v)) <= 1e-13) << "borders stay";
    });
}

TEST(Brushes, InflateGoesOutwardsByStrengthTimesRadius)
{
    Mat4 mirroring(1.0);
    mirroring[0][0] = -1;
    for (const Mat4& transform : {Mat4(1.0), mirroring, anyTransform()}) {
        const SharedObject object = objectOf(sphere({0, 0, 0}, 2), transform);
        const Vec3 centre = transformed(Vec3(0), transform);
        const Dab dab{centre, 50, 0.01, FalloffShape::constant, {}, {}};
        const SharedObject larger = done(object, BrushKind::inflate, dab);
        forPoints(object, [&](int i, int j) {
            const Vec3 way = placeIn(larger, i, j) - placeIn(object, i, j);
            EXPECT_NEAR(glm::length(way), 0.5, 1e-12);
            EXPECT_GT(glm::dot(way, placeIn(object, i, j) - centre), 0);
        });
        Dab inwards = dab;
        inwards.strength = -0.01;
        EXPECT_LT(done(object, BrushKind::inflate, inwards)->bounds().diagonal(),
                  object->bounds().diagonal());
    }
}

TEST(Brushes, FlattenTwiceIsFlatten)
{
    std::mt19937 random(54);
    for (int round = 0; round < 30; ++round) {
        const SharedObject object =
            objectOf(randomSurface(random, {.spans = 5}), round % 2 == 0 ? Mat4(1.0) : anyTransform());
        const Dab dab{placeIn(object, 3, 3), 3, 1, FalloffShape::constant, {}, {}};
        const SharedObject once = done(object, BrushKind::flatten, dab);
        std::vector<Vec3> flat;
        forPoints(object, [&](int i, int j) {
            if (distanceFrom(dab.centre, object, i, j) < dab.radius)
                flat.push_back(placeIn(once, i, j));
            else
                EXPECT_EQ(placeIn(once, i, j), placeIn(object, i, j));
        });
        ASSERT_GT(flat.size(), 5U);
        EXPECT_GT(largestDistance(once, object), 1e-3);
        for (size_t k = 3; k < flat.size(); ++k)
            EXPECT_LE(std::abs(glm::dot(glm::cross(flat[1] - flat[0], flat[2] - flat[0]), flat[k] - flat[0])),
                      1e-11);
        // Of all points; with fewer, flattening brings others within the radius.
        const Dab whole{Vec3(0), 1e6, 1, FalloffShape::constant, {}, {}};
        const SharedObject plane = done(object, BrushKind::flatten, whole);
        EXPECT_LE(largestDistance(done(plane, BrushKind::flatten, whole), plane), 1e-9) << round;
    }
}

TEST(BestPlane, LeavesLessThanAnyOther)
{
    std::mt19937 random(55);
    const auto rest = [](const std::vector<Vec3>& points, const std::vector<double>& weights,
                         const Vec3& point, const Vec3& normal) {
        double sum = 0;
        for (size_t k = 0; k < points.size(); ++k)
            sum += weights[k] * std::pow(glm::dot(normal, points[k] - point), 2);
        return sum;
    };
    for (int round = 0; round < 100; ++round) {
        std::vector<Vec3> points;
        std::vector<double> weights;
        for (int k = 0; k < 3 + round % 20; ++k) {
            points.push_back(anyVector(random) * Vec3(1, round % 5, 1) + Vec3(1000, 0, -2000));
            weights.push_back(randomBetween(random, 0.1, 3));
        }
        const BestPlane plane = bestPlaneOf(points, weights);
        EXPECT_NEAR(glm::length(plane.normal), 1, 1e-15);
        const double best = rest(points, weights, plane.point, plane.normal);
        for (int k = 0; k < 200; ++k) {
            const double step = std::pow(10.0, -(k % 6));
            EXPECT_LE(best, rest(points, weights, plane.point + step * anyVector(random),
                                 glm::normalize(plane.normal + step * anyVector(random))) +
                                1e-18);
        }
    }
    const BestPlane one = bestPlaneOf({Vec3(1, 2, 3), Vec3(1, 2, 3)}, {1, 2});
    EXPECT_EQ(one.point, Vec3(1, 2, 3));
    EXPECT_EQ(glm::length(one.normal), 1);
}

TEST(Brushes, KeepASymmetricSheetSymmetric)
{
    std::mt19937 random(56);
    for (const BrushKind brush : kBrushes) {
        SharedObject object = objectOf(symmetricSheet());
        const SharedObject start = object;
        for (int k = 0; k < 12; ++k) {
            Dab dab{placeIn(object, k % 9, k % 7),
                    randomBetween(random, 0.5, 5),
                    0.4,
                    FalloffShape::smooth,
                    anyVector(random),
                    SymmetryPlane{}};
            object = done(object, brush, dab);
        }
        EXPECT_GT(largestDistance(object, start), 0.05);
        forPoints(object, [&](int i, int j) {
            EXPECT_LE(glm::distance(placeIn(object, i, j), placeIn(object, 8 - i, j) * Vec3(-1, 1, 1)), 1e-12)
                << static_cast<int>(brush);
        });
    }
}

TEST(Brushes, OfTheMirrorImageIsTheMirrorImageOfTheBrush)
{
    std::mt19937 random(57);
    for (int round = 0; round < 80; ++round) {
        const BrushKind brush = kBrushes[round % 4];
        const SharedObject object = objectOf(randomSurface(random, {.spans = 5, .rational = true}));
        const SymmetryPlane plane{anyVector(random), anyVector(random)};
        Dab dab{placeIn(object, 2, 3), 2.5, 0.6, FalloffShape::smooth, anyVector(random), {}};
        if (round % 8 >= 4)
            dab.mirror = SymmetryPlane{anyVector(random), anyVector(random)};
        Dab image = dab;
        image.centre = mirrored(dab.centre, plane);
        image.by = reflectionIn(plane) * dab.by;
        if (dab.mirror)
            image.mirror =
                SymmetryPlane{mirrored(dab.mirror->point, plane), reflectionIn(plane) * dab.mirror->normal};
        // A mirrored net's S_u x S_v points to the other side.
        if (brush == BrushKind::inflate)
            image.strength = -dab.strength;
        EXPECT_LE(largestDistance(done(mirrorImage(object, plane), brush, image),
                                  mirrorImage(done(object, brush, dab), plane)),
                  1e-12)
            << round;
    }
}

TEST(Brushes, KeepSeamsTogether)
{
    for (const NurbsSurface& surface : {torus({0, 0, 0}, 3, 1), sphere({0, 0, 0}, 3)})
        for (const BrushKind brush : kBrushes) {
            SharedObject object = objectOf(surface);
            for (int k = 0; k < 5; ++k)
                object = done(object, brush,
                              {placeIn(object, 0, 2 + k), 2, 0.5, FalloffShape::smooth, {0.2, 0.3, 0.1}, {}});
            EXPECT_GT(largestDistance(object, objectOf(surface)), 0.05);
            const int last = surface.countU() - 1;
            double apart = 0;
            for (int j = 0; j < surface.countV(); ++j)
                apart = std::max(apart, glm::distance(placeIn(object, 0, j), placeIn(object, last, j)));
            EXPECT_LE(apart, 1e-12) << static_cast<int>(brush);
        }
}

TEST(Brushes, OutOfReachChangeNothingAndTheSceneHearsOfNothing)
{
    const Scene scene = sceneOf({symmetricSheet(), symmetricSheet()});
    for (const BrushKind brush : kBrushes) {
        const Dab dab{{100, 0, 0}, 2, 0.5, FalloffShape::smooth, {1, 0, 0}, {}};
        EXPECT_EQ(done(scene.find(kFirst), brush, dab), scene.find(kFirst));
        EXPECT_TRUE(dabbed(scene, {kFirst, kSecond, ObjectId{7}}, brush, dab)->isEmpty());
        Dab near = dab;
        near.centre = {1, 2, 0};
        const Scene after = applied(scene, *dabbed(scene, {kSecond}, brush, near));
        EXPECT_EQ(after.find(kFirst), scene.find(kFirst));
        EXPECT_NE(after.find(kSecond), scene.find(kSecond));
    }
}

TEST(Brushes, RefuseWhatTheyCannotDoWithASentence)
{
    const SharedObject object = objectOf(symmetricSheet());
    for (const double radius : {0.0, -1.0, std::nan("")})
        EXPECT_NE(dabbed(object, BrushKind::smooth, {{}, radius, 0.5, FalloffShape::smooth, {}, {}})
                      .error()
                      .sentence()
                      .find("above zero"),
                  std::string::npos);
    EXPECT_FALSE(dabbed(object, BrushKind::flatten, {{}, 1, 1.5, FalloffShape::smooth, {}, {}}));
    EXPECT_FALSE(dabbed(object, BrushKind::grab, {{}, 1, -0.5, FalloffShape::smooth, {}, {}}));
    EXPECT_TRUE(dabbed(object, BrushKind::inflate, {{}, 1, -0.5, FalloffShape::smooth, {}, {}}));
}

}  // namespace knotspan::testing
