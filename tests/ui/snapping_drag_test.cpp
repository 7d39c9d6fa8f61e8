// What a dragged control point jumps to.
#include <cmath>

#include "tests/ui/gizmo_harness.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class SnappingDrag : public GizmoTest {
protected:
    [[nodiscard]] ScenePoint point() const { return {id, {3, 4}}; }
    [[nodiscard]] Vec3 was() { return placeOf(start, point()); }
    [[nodiscard]] Vec3 is() { return placeOf(scene(), point()); }
    void snapTo(const SnapSettings& snap, DragAxis axis = DragAxis::free)
    {
        tell([&](ToolSettings& settings) {
            settings.snap = snap;
            settings.drag.axis = axis;
        });
    }
    void dragTo(const Vec2& pixel)
    {
        const Vec2 from = pixelOf(was());
        Hand(*window).drag(from, pixel);
    }
    // Adds a flat square through `place` that faces the eye, with 3 x 3 control points `size` apart.
    ObjectId addSquare(const Vec3& place, double size)
    {
        const Camera seen = camera();
        std::vector<ControlPoint> points;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                points.push_back({place + size * ((i - 1.0) * seen.right() + (j - 1.0) * seen.upward()), 1});
        const auto knots = KnotVector::create(1, {0, 0, 0.5, 1, 1});
        auto surface = NurbsSurface::create(knots.value(), knots.value(), points);
        SceneObject object{.name = "Square", .surface = surface.value()};
        Scene both = scene();
        const ObjectId added = both.add(object);
        window->document().reset(both, "both");
        settle(*window);
        window->viewport().setCamera(seen);
        start = scene();
        window->selection().setObjects({id});
        settle(*window);
        return added;
    }
};

TEST_F(SnappingDrag, GoesToTheGridFromEverywhere)
{
    snapTo({.grid = true, .gridStep = 0.5});
    dragTo(pixelOf(was()) + Vec2(31, -17));
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(is()[k] / 0.5, std::round(is()[k] / 0.5), 1e-9);
    EXPECT_NE(is(), was());
    expectOneStep("Move control point");
}

TEST_F(SnappingDrag, AlongAnAxisOnlyThatPartCounts)
{
    snapTo({.grid = true, .gridStep = 0.5}, DragAxis::z);
    dragTo(pixelOf(was()) + Vec2(3, -40));
    EXPECT_EQ(is().x, was().x);
    EXPECT_EQ(is().y, was().y);
    EXPECT_NEAR(is().z / 0.5, std::round(is().z / 0.5), 1e-9);
    expectOneStep("Move control point");
}

TEST_F(SnappingDrag, GoesToTheControlPointThatIsNearOnThePicture)
{
    const Vec3 other = placeOf(start, {id, {6, 6}});
    snapTo({.grid = true, .points = true});
    dragTo(pixelOf(other) + Vec2(4, 3));
    EXPECT_NEAR(glm::distance(is(), other), 0, 1e-9);
    expectOneStep("Move control point");
}

TEST_F(SnappingDrag, PointsAreNoTargetsBeyondTheReach)
{
    const ObjectId square = addSquare(was() + 90 * camera().unitsPerPixel(was(), view().height) *
                                                  (camera().right() + camera().upward()),
                                      30 * camera().unitsPerPixel(was(), view().height));
    window->selection().setObjects({id});
    snapTo({.points = true, .reachPx = 5});
    const Vec2 corner = pixelOf(placeOf(start, {square, {2, 2}}));
    dragTo(corner + Vec2(4, 0));
    EXPECT_NEAR(glm::distance(is(), placeOf(start, {square, {2, 2}})), 0, 1e-9);
    window->document().undo();
    settle(*window);
    dragTo(corner + Vec2(9, 9));
    EXPECT_GT(glm::distance(is(), placeOf(start, {square, {2, 2}})), 1e-6);
}

TEST_F(SnappingDrag, GoesToSurfacesAndRatherToTheirKnotLines)
{
    const double pixel = camera().unitsPerPixel(was(), view().height);
    // A little nearer to the eye than the control point, so that it comes to lie in another plane.
    const Vec3 middle =
        was() + 80 * pixel * (camera().right() + 0.5 * camera().upward()) - 3 * pixel * camera().forward();
    const ObjectId square = addSquare(middle, 30 * pixel);
    const Vec3 low = placeOf(start, {square, {0, 0}});
    const Vec3 across = glm::normalize(placeOf(start, {square, {2, 0}}) - low);
    const Vec3 along = glm::normalize(placeOf(start, {square, {0, 2}}) - low);
    const auto inSquare = [&](const Vec3& place) {
        return Vec3(glm::dot(place - low, across), glm::dot(place - low, along),
                    glm::dot(place - low, glm::cross(across, along))) /
               (60 * pixel);
    };
    const Vec3 wanted = middle + 8 * pixel * across + 15 * pixel * along + 3 * pixel * camera().forward();
    const auto go = [&](const SnapSettings& snap) {
        snapTo(snap);
        dragTo(pixelOf(wanted));
        const Vec3 place = inSquare(is());
        window->document().undo();
        settle(*window);
        return place;
    };
    const Vec3 onSurface = go({.grid = true, .surfaces = true});
    EXPECT_NEAR(onSurface.z, 0, 1e-9);
    EXPECT_NEAR(onSurface.x, 0.5 + 8.0 / 60, 1e-6);
    EXPECT_NEAR(onSurface.y, 0.75, 1e-6);
    const Vec3 onLine = go({.knotLines = true, .surfaces = true});
    EXPECT_NEAR(onLine.z, 0, 1e-9);
    EXPECT_NEAR(onLine.x, 0.5, 1e-9);
    EXPECT_NEAR(onLine.y, 0.75, 1e-6);
    const Vec3 beside = go({.knotLines = true, .reachPx = 4});
    EXPECT_GT(std::abs(beside.z), 1e-3);
}

TEST_F(SnappingDrag, DoesNotCountForTypedNumbersAndEscapeLeavesNoTrace)
{
    snapTo({.grid = true, .points = true, .gridStep = 0.5});
    Hand hand(*window);
    const Vec2 pixel = pixelOf(was());
    hand.press(pixel);
    hand.move(pixel + Vec2(25, 10));
    type("0.123");
    EXPECT_EQ(is(), was() + Vec3(0.123, 0, 0));
    key(Qt::Key_Escape);
    hand.release();
    expectNoTrace();
}

TEST_F(SnappingDrag, ShowsACrossWhereItWent)
{
    snapTo({.grid = true, .gridStep = 0.5});
    Hand hand(*window);
    const Vec2 pixel = pixelOf(was());
    hand.press(pixel);
    hand.move(pixel + Vec2(31, -17));
    settle(*window);
    const QImage shown = picture(*window);
    const Vec2 at = pixelOf(is());
    int yellow = 0;
    for (int y = int(at.y) - 10; y < int(at.y) + 10; ++y)
        for (int x = int(at.x) - 10; x < int(at.x) + 10; ++x)
            if (shown.rect().contains(x, y)) {
                const QColor colour(shown.pixel(x, y));
                yellow += colour.red() > 180 && colour.green() > 150 && colour.blue() < 110 ? 1 : 0;
            }
    EXPECT_GT(yellow, 8);
    hand.release();
}

}  // namespace
}  // namespace knotspan
