// Live symmetry: what was symmetric stays so, and the mirror image of a drag is the drag of the mirror image.
#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "model/sculpting/point_drag.h"
#include "tests/model/sculpting/sculpting_scene.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

constexpr FalloffDistance kDistances[] = {FalloffDistance::space, FalloffDistance::netSteps,
                                          FalloffDistance::netLengths};
constexpr DragAxis kAxes[] = {DragAxis::free, DragAxis::x, DragAxis::y,     DragAxis::z,
                              DragAxis::u,    DragAxis::v, DragAxis::normal};

Vec3 anyVector(std::mt19937& random)
{
    return {randomBetween(random, -2, 2), randomBetween(random, -2, 2), randomBetween(random, -2, 2)};
}

Scene movedBy(const Scene& scene, const PointSelection& selection, const DragSettings& settings,
              const Vec3& by)
{
    auto drag = PointDrag::begin(scene, selection, settings);
    EXPECT_TRUE(drag);
    return applied(scene, *drag->moved(by));
}

PointSelection somePoints(std::mt19937& random, const Scene& scene)
{
    PointSelection selection;
    for (int k = 0; k < 3; ++k)
        selection.add(
            pointOf(scene, {kFirst, {static_cast<int>(random() % 9), static_cast<int>(random() % 7)}}));
    return selection;
}

Scene mirroredScene(const Scene& scene, const SymmetryPlane& plane)
{
    Scene result = scene;
    for (const auto& [id, object] : scene.objects()) {
        SceneObject image = *object;
        std::vector<ControlPoint> points = image.surface.controlPoints();
        for (ControlPoint& point : points)
            point.position = mirrored(point.position, plane);
        image.surface =
            *NurbsSurface::create(image.surface.knotsU(), image.surface.knotsV(), std::move(points));
        result.exchange(id, std::make_shared<SceneObject>(image));
    }
    return result;
}

DragSettings anySettings(std::mt19937& random, int round)
{
    DragSettings settings;
    settings.axis = kAxes[round % 7];
    settings.eachItsOwn = round % 2 == 0;
    settings.falloff = {round % 5 == 0 ? 0 : randomBetween(random, 0.5, 5), FalloffShape::smooth,
                        kDistances[round % 3]};
    return settings;
}

}  // namespace

TEST(Symmetry, KeepsASymmetricSheetSymmetricToTheBit)
{
    std::mt19937 random(41);
    for (int round = 0; round < 200; ++round) {
        const Scene start = sceneOf({symmetricSheet()});
        DragSettings settings = anySettings(random, round);
        settings.symmetry.kind = SymmetryKind::plane;
        const bool exact = settings.axis <= DragAxis::z;
        const Scene scene = movedBy(start, somePoints(random, start), settings, anyVector(random));
        for (int i = 0; i < 9; ++i)
            for (int j = 0; j < 7; ++j) {
                const Vec3 image = placeIn(scene, kFirst, 8 - i, j) * Vec3(-1, 1, 1);
                EXPECT_LE(glm::distance(placeIn(scene, kFirst, i, j), image), exact ? 0 : 1e-13) << round;
            }
        for (int j = 0; j < 7; ++j)
            EXPECT_LE(std::abs(placeIn(scene, kFirst, 4, j).x), exact ? 0 : 1e-13) << round;
    }
}

TEST(Symmetry, LetsTheHandLeadItsOwnSide)
{
    const Scene start = sceneOf({symmetricSheet()});
    DragSettings settings;
    settings.falloff.radius = 20;
    settings.symmetry.kind = SymmetryKind::plane;
    const Vec3 by(0.5, 0.25, -1);
    const Scene scene = movedBy(start, pointOf(start, {kFirst, {6, 3}}), settings, by);
    EXPECT_EQ(placeIn(scene, kFirst, 6, 3), placeIn(start, kFirst, 6, 3) + by);
    EXPECT_EQ(placeIn(scene, kFirst, 2, 3), placeIn(start, kFirst, 2, 3) + by * Vec3(-1, 1, 1));
}

TEST(Symmetry, MirrorImageOfADragIsTheDragOfTheMirrorImage)
{
    std::mt19937 random(42);
    for (int round = 0; round < 120; ++round) {
        const Scene start = sceneOf({randomSurface(random, {.spans = 5, .rational = true})});
        const bool atX = round % 2 == 0;
        const SymmetryPlane plane =
            atX ? SymmetryPlane{} : SymmetryPlane{anyVector(random), anyVector(random)};
        DragSettings settings = anySettings(random, round);
        // The mirror image of x + y is not along x, nor is a normal turned over by swapping sides.
        settings.axis = round % 3 == 0 ? DragAxis::free : round % 3 == 1 ? DragAxis::u : DragAxis::v;
        PointSelection selection = pointOf(start, {kFirst, {1, 1}});
        selection.add(pointOf(start, {kFirst, {3, 2}}));
        const Vec3 by = anyVector(random);
        const Scene moved = movedBy(start, selection, settings, by);
        const Scene image =
            movedBy(mirroredScene(start, plane), selection, settings, reflectionIn(plane) * by);
        EXPECT_GT(largestDifference(moved, start), 1e-3);
        EXPECT_LE(largestDifference(image, mirroredScene(moved, plane)), atX ? 0 : 1e-13 * 50) << round;
    }
}

TEST(Symmetry, FindsPartnersInOtherObjects)
{
    // Port and starboard halves, joined along x = 0.
    const auto half = [](double side) {
        return netOfPlaces(
            5, 6, [side](int i, int j) { return Vec3(side * i, j, 0.1 * i * i + std::sin(0.5 * j)); });
    };
    Scene start = sceneOf({half(1), half(-1)});
    SceneObject shifted = *start.find(kSecond);
    shifted.transform[3] = Vec4(0, 4, 0, 1);
    shifted.surface =
        netOfPlaces(5, 6, [](int i, int j) { return Vec3(-i, j - 4, 0.1 * i * i + std::sin(0.5 * j)); });
    start.exchange(kSecond, std::make_shared<SceneObject>(shifted));
    DragSettings settings;
    settings.falloff.radius = 2.5;
    settings.symmetry.kind = SymmetryKind::plane;
    const auto alone = PointDrag::begin(start, pointOf(start, {kFirst, {2, 2}}), settings);
    EXPECT_GT(alone->withoutPartner(), 0U);
    EXPECT_FALSE(alone->moving().objects().count(kSecond));
    settings.others = {kSecond};
    const auto drag = PointDrag::begin(start, pointOf(start, {kFirst, {2, 2}}), settings);
    EXPECT_EQ(drag->withoutPartner(), 0U);
    const Scene scene = applied(start, *drag->moved({0.3, 0.2, 0.6}));
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 6; ++j)
            EXPECT_LE(
                glm::distance(placeIn(scene, kFirst, i, j) * Vec3(-1, 1, 1), placeIn(scene, kSecond, i, j)),
                1e-14);
    EXPECT_EQ(placeIn(scene, kFirst, 2, 2), placeIn(start, kFirst, 2, 2) + Vec3(0.3, 0.2, 0.6));
}

TEST(Symmetry, AcrossTheNetEqualsThePlanesWhereTheSheetIsSymmetric)
{
    std::mt19937 random(43);
    for (int round = 0; round < 100; ++round) {
        const bool byU = round % 2 == 0;
        NurbsSurface sheet = symmetricSheet();
        if (!byU)
            sheet = netOfPlaces(
                7, 9, [&](int i, int j) { return sheet.controlPoint(j, i).position; },
                [&](int i, int j) { return sheet.controlPoint(j, i).weight; });
        const Scene start = sceneOf({sheet});
        DragSettings settings = anySettings(random, round / 2);
        PointSelection selection =
            byU ? pointOf(start, {kFirst, {1 + round % 3, 2}}) : pointOf(start, {kFirst, {2, 1 + round % 3}});
        const Vec3 by = anyVector(random);
        settings.symmetry.kind = SymmetryKind::plane;
        const Scene byPlane = movedBy(start, selection, settings, by);
        settings.symmetry.kind = byU ? SymmetryKind::u : SymmetryKind::v;
        EXPECT_LE(largestDifference(movedBy(start, selection, settings, by), byPlane), 1e-12) << round;
    }
}

TEST(Symmetry, AcrossTheNetWorksOnWhatIsNotSymmetric)
{
    std::mt19937 random(44);
    const Scene start = sceneOf({randomSurface(random, {.spans = 6})});
    const int last = start.find(kFirst)->surface.countU() - 1;
    DragSettings settings;
    settings.axis = DragAxis::normal;
    settings.eachItsOwn = true;
    settings.symmetry.kind = SymmetryKind::u;
    const auto drag = PointDrag::begin(start, pointOf(start, {kFirst, {1, 3}}), settings);
    DragSettings other = settings;
    other.symmetry.kind = SymmetryKind::none;
    const auto image = PointDrag::begin(start, pointOf(start, {kFirst, {last - 1, 3}}), other);
    const Scene scene = applied(start, *drag->movedAlong(0.7));
    EXPECT_LE(glm::distance(placeIn(scene, kFirst, last - 1, 3),
                            placeIn(applied(start, *image->movedAlong(0.7)), kFirst, last - 1, 3)),
              1e-13)
        << "along a normal the image goes along its own";
}

}  // namespace knotspan::testing
