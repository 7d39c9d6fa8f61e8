// Every handle of the gizmo by pointer events: what it does to the document, one step, no trace of Escape.
#include <cmath>

#include "tests/ui/gizmo_harness.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

constexpr DragAxis kModelAxes[] = {DragAxis::x, DragAxis::y, DragAxis::z};

Vec3 unit(DragAxis axis)
{
    Vec3 direction(0);
    direction[static_cast<int>(axis) - static_cast<int>(DragAxis::x)] = 1;
    return direction;
}

class GizmoDrag : public GizmoTest {
protected:
    // Chooses a control point and some beside it; the way that pulls its handle by `far` along `direction`.
    PointSelection chooseSome()
    {
        PointSelection some = pointOf(scene(), {id, {3, 4}});
        some.add(pointOf(scene(), {id, {4, 4}}));
        window->selection().setPoints(some);
        settle(*window);
        return some;
    }
    [[nodiscard]] Vec2 wayOf(const Vec3& by)
    {
        const Vec3 centre = placed().centre;
        return pixelOf(centre + by) - pixelOf(centre);
    }
    [[nodiscard]] double someUnits() { return 25 * camera().unitsPerPixel(placed().centre, view().height); }

    // All control points of `start`, moved by `map`, are those of the object now.
    template <class Map>
    void expectMapped(const Map& map)
    {
        const SharedObject before = start.find(id);
        const SharedObject after = scene().find(id);
        EXPECT_NE(before, after);
        const double size = before->bounds().diagonal();
        for (size_t k = 0; k < before->surface.controlPoints().size(); ++k) {
            const Vec3 was = transformed(before->surface.controlPoints()[k].position, before->transform);
            const Vec3 is = transformed(after->surface.controlPoints()[k].position, after->transform);
            ASSERT_NEAR(glm::distance(is, map(was)), 0, 1e-9 * size);
        }
        EXPECT_TRUE(after->surface.controlPoints() == before->surface.controlPoints());
    }
};

TEST_F(GizmoDrag, ArrowsMoveControlPointsAlongTheModelsAxes)
{
    // Whatever axis the panel says.
    tell([](ToolSettings& settings) { settings.drag.axis = DragAxis::normal; });
    const PointSelection some = chooseSome();
    Hand hand(*window);
    for (const DragAxis axis : kModelAxes) {
        const Vec3 by = someUnits() * unit(axis);
        const Vec2 from = grip(HandleKind::move, axis);
        hand.drag(from, from + wayOf(by));
        for (int i = 0; i < start.find(id)->surface.countU(); ++i)
            for (int j = 0; j < start.find(id)->surface.countV(); ++j) {
                const ScenePoint point{id, {i, j}};
                const Vec3 moved = placeOf(now(), point) - placeOf(start, point);
                ASSERT_NEAR(glm::distance(moved, some.contains(point) ? by : Vec3(0)), 0, 1e-9);
            }
        expectOneStep("Move 2 control points");
        window->document().undoStack().clear();
    }
}

TEST_F(GizmoDrag, ArrowsMoveControlPointsAlongTheSurfacesDirections)
{
    tell([](ToolSettings& settings) { settings.gizmo = GizmoFrame::surface; });
    const PointSelection some = chooseSome();
    Hand hand(*window);
    for (const DragAxis axis : {DragAxis::u, DragAxis::v, DragAxis::normal}) {
        DragSettings settings;
        settings.axis = axis;
        const auto drag = PointDrag::begin(start, some, settings);
        ASSERT_TRUE(drag.has_value());
        const Vec3 by = someUnits() * drag->direction();
        if (glm::length(wayOf(by)) < 8)
            continue;  // points at the eye
        const Vec2 from = grip(HandleKind::move, axis);
        hand.drag(from, from + wayOf(by));
        const Vec3 moved = placeOf(now(), {id, {3, 4}}) - placeOf(start, {id, {3, 4}});
        EXPECT_NEAR(glm::distance(moved, by), 0, 1e-9);
        expectOneStep("Move 2 control points");
        window->document().undoStack().clear();
    }
}

TEST_F(GizmoDrag, ShiftCountsATenth)
{
    chooseSome();
    const Vec3 by = someUnits() * unit(DragAxis::z);
    const Vec2 from = grip(HandleKind::move, DragAxis::z);
    const Vec2 way = wayOf(0.1 * by) * 10.0;
    Hand(*window).drag(from, from + way, Qt::LeftButton, Qt::ShiftModifier);
    const Vec3 moved = placeOf(now(), {id, {3, 4}}) - placeOf(start, {id, {3, 4}});
    EXPECT_NEAR(glm::distance(moved, 0.1 * by), 0, 1e-9);
    expectOneStep("Move 2 control points");
}

TEST_F(GizmoDrag, ArrowsMoveObjects)
{
    Hand hand(*window);
    for (const DragAxis axis : kModelAxes) {
        const Vec3 by = someUnits() * unit(axis);
        const Vec2 from = grip(HandleKind::move, axis);
        hand.drag(from, from + wayOf(by));
        expectMapped([&](const Vec3& p) { return p + by; });
        expectOneStep("Move object");
        window->document().undoStack().clear();
    }
}

TEST_F(GizmoDrag, RingsTurnObjects)
{
    Hand hand(*window);
    constexpr double kAngle = 0.7;
    for (const DragAxis axis : kModelAxes) {
        const Vec3 centre = placed().centre;
        const Vec2 from = grip(HandleKind::turn, axis);
        // The same place of a circle in space, found by its angle alone.
        const int k = static_cast<int>(axis) - static_cast<int>(DragAxis::x);
        Vec3 first(0);
        Vec3 second(0);
        first[(k + 1) % 3] = 1;
        second[(k + 2) % 3] = 1;
        const auto seen = [&](double angle) {
            const Vec3 v = std::cos(angle) * first + std::sin(angle) * second;
            return kRingPx * view().pixelRatio *
                   Vec2(glm::dot(v, camera().right()), -glm::dot(v, camera().upward()));
        };
        double angle = 0;
        for (double a = 0; a < 6.3; a += 1e-4)
            if (glm::distance(pixelOf(centre) + seen(a), from) <
                glm::distance(pixelOf(centre) + seen(angle), from))
                angle = a;
        ASSERT_LT(glm::distance(pixelOf(centre) + seen(angle), from), 0.5);
        const Vec2 grabbed = pixelOf(centre) + seen(angle);
        hand.press(grabbed);
        hand.move(pixelOf(centre) + seen(angle + 0.3));
        hand.move(pixelOf(centre) + seen(angle + kAngle));
        hand.release();
        expectMapped([&](const Vec3& p) {
            const Vec3 rest = p - centre;
            const double x = glm::dot(rest, first);
            const double y = glm::dot(rest, second);
            Vec3 turned = centre + (rest - x * first - y * second);
            turned += (std::cos(kAngle) * x - std::sin(kAngle) * y) * first;
            turned += (std::sin(kAngle) * x + std::cos(kAngle) * y) * second;
            return turned;
        });
        expectOneStep("Turn object");
        window->document().undoStack().clear();
    }
}

TEST_F(GizmoDrag, BarsScaleObjectsAlongAnAxisAndTheCentreEvenly)
{
    Hand hand(*window);
    const Vec3 centre = placed().centre;
    const double whole = kScaleBarPx * view().pixelRatio * camera().unitsPerPixel(centre, view().height);
    for (const DragAxis axis : kModelAxes) {
        const Vec2 from = grip(HandleKind::scale, axis);
        hand.drag(from, from + wayOf(0.25 * whole * unit(axis)));
        expectMapped([&](const Vec3& p) { return p + 0.25 * glm::dot(p - centre, unit(axis)) * unit(axis); });
        expectOneStep("Scale object");
        window->document().undoStack().clear();
    }
    const Vec2 from = grip(HandleKind::scaleEvenly, DragAxis::free);
    hand.drag(from, from + Vec2(20, -10));
    const double factor = std::exp(30 / (120 * view().pixelRatio));
    expectMapped([&](const Vec3& p) { return centre + factor * (p - centre); });
    expectOneStep("Scale object");
}

TEST_F(GizmoDrag, EscapeLeavesNoTraceOfAnyHandle)
{
    Hand hand(*window);
    for (const GizmoHandle& handle : placed().handles) {
        const Vec2 from = grip(handle.kind, handle.axis);
        hand.press(from);
        hand.move(from + Vec2(17, 9));
        hand.move(from + Vec2(27, -12));
        EXPECT_FALSE(scene() == start);
        key(Qt::Key_Escape);
        EXPECT_TRUE(scene() == start);
        hand.move(from + Vec2(40, 40));
        hand.release();
        expectNoTrace();
    }
}

TEST_F(GizmoDrag, SeveralObjectsGoTogetherAndLockedOnesStay)
{
    open("nine-16");
    const ObjectId other = std::next(scene().objects().begin())->first;
    const ObjectId third = std::next(scene().objects().begin(), 2)->first;
    Scene locked = scene();
    auto fixed = std::make_shared<SceneObject>(*locked.find(third));
    fixed->locked = true;
    locked.exchange(third, fixed);
    const Camera seen = camera();
    window->document().reset(locked, "locked");
    settle(*window);
    window->viewport().setCamera(seen);
    start = scene();
    window->selection().setObjects({id, other, third});
    settle(*window);
    const Vec2 from = grip(HandleKind::move, DragAxis::x);
    Hand(*window).drag(from, from + wayOf(someUnits() * unit(DragAxis::x)));
    EXPECT_NE(scene().find(id), start.find(id));
    EXPECT_NE(scene().find(other), start.find(other));
    EXPECT_EQ(scene().find(third), start.find(third));
    expectOneStep("Move 2 objects");
}

TEST_F(GizmoDrag, ALockedFriendIsARefusalInASentence)
{
    open("knot");
    window->viewport().fitSelection();
    settle(*window);
    const Camera seen = camera();
    // At a border, where another object has to follow.
    window->selection().setPoints(pointOf(scene(), {id, {0, 2}}));
    tell([](ToolSettings& settings) { settings.keepFriends = true; });
    settle(*window);
    Hand hand(*window);
    const auto drag = [&] {
        const Vec2 from = grip(HandleKind::move, DragAxis::z);
        hand.press(from);
        hand.move(from + wayOf(0.3 * someUnits() * unit(DragAxis::z)));
    };
    drag();
    const auto othersChanged = [&] {
        size_t count = 0;
        for (const auto& [each, object] : start.objects())
            count += each != id && scene().find(each) != object ? 1 : 0;
        return count;
    };
    EXPECT_GT(othersChanged(), 0U);
    key(Qt::Key_Escape);
    hand.release();
    Scene locked = scene();
    for (const auto& [each, object] : start.objects())
        if (each != id) {
            auto fixed = std::make_shared<SceneObject>(*object);
            fixed->locked = true;
            locked.exchange(each, fixed);
        }
    window->document().reset(locked, "locked");
    settle(*window);
    window->viewport().setCamera(seen);
    start = scene();
    window->selection().setPoints(pointOf(scene(), {id, {0, 2}}));
    settle(*window);
    drag();
    EXPECT_TRUE(hint().contains("is locked")) << hint().toStdString();
    EXPECT_TRUE(scene() == start);
    hand.release();
    EXPECT_TRUE(window->message().contains("is locked"));
    expectNoTrace();
    tell([](ToolSettings& settings) { settings.keepFriends = false; });
}

TEST_F(GizmoDrag, AControlPointNearerThanTheHandleIsTaken)
{
    window->selection().setPoints(pointOf(scene(), {id, {3, 4}}));
    settle(*window);
    const Vec2 pixel = pixelOf(placeOf(start, {id, {3, 4}}));
    const Vec3 by = movedInViewPlane(view(), placeOf(start, {id, {3, 4}}), Vec2(22, 15));
    Hand(*window).drag(pixel, pixel + Vec2(22, 15));
    EXPECT_NEAR(glm::distance(placeOf(now(), {id, {3, 4}}) - placeOf(start, {id, {3, 4}}), by), 0, 1e-9);
    expectOneStep("Move control point");
}

TEST_F(GizmoDrag, APressThatGoesNowhereKeepsTheSelectionOfPoints)
{
    const PointSelection some = chooseSome();
    Hand(*window).click(grip(HandleKind::move, DragAxis::z));
    EXPECT_TRUE(window->selection().points() == some);
    expectNoTrace();
}

}  // namespace
}  // namespace knotspan
