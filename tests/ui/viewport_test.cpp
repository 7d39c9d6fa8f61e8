#include "ui/viewport/viewport.h"

#include <ctime>

#include <gtest/gtest.h>

#include <QAction>
#include <QListView>
#include <QSlider>
#include <QTest>

#include <glm/geometric.hpp>

#include "tests/ui/window_harness.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

Vec2 centre(MainWindow& window)
{
    const PictureSize size = window.viewport().pictureSize();
    return {size.width / 2.0, size.height / 2.0};
}

// Selects the first object and finds one of its control points.
std::optional<VisiblePoint> shownPoint(MainWindow& window)
{
    const ObjectId object = window.document().scene().objects().begin()->first;
    window.selection().setObjects({object});
    settle(window);
    return visiblePoint(window, object);
}

TEST(Viewport, AClickSelectsTheSurfaceUnderItAndNothingDeselects)
{
    Answers answers;
    const auto window = shownWindow(answers, "single-100");
    KNOTSPAN_NEED_RENDERER(*window);
    Hand hand(*window);
    hand.click(centre(*window));
    ASSERT_EQ(window->selection().objects().size(), 1U);
    settle(*window);
    const auto* list = window->findChild<QListView*>("objects");
    EXPECT_EQ(list->selectionModel()->selectedIndexes().size(), 1);
    hand.click({3, 3});
    EXPECT_TRUE(window->selection().objects().empty());
    EXPECT_TRUE(list->selectionModel()->selectedIndexes().empty());
}

TEST(Viewport, DrawsNothingAndComputesNothingWhileNobodyTouchesIt)
{
    Answers answers;
    const auto window = shownWindow(answers, "hull");
    KNOTSPAN_NEED_RENDERER(*window);
    QTest::qWait(1500);  // friends, boxes, the picture for the list of recent files
    ASSERT_TRUE(settle(*window));
    int frames = 0;
    QObject::connect(&window->viewport(), &Viewport::frameDrawn, window.get(), [&frames] { ++frames; });
    const std::clock_t before = std::clock();
    QTest::qWait(2000);
    EXPECT_EQ(frames, 0);
    const double busy = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    EXPECT_LT(busy, 0.2) << "seconds of the processor, of two that passed: measured are 0.0001";
}

// A pixel where a click takes the object's surface and none of the shown control points.
std::optional<Vec2> pixelOf(MainWindow& window, ObjectId object)
{
    settle(window);
    const PictureSize size = window.viewport().pictureSize();
    for (int y = 4; y < size.height; y += 6)
        for (int x = 4; x < size.width; x += 6) {
            const Result<Pick> pick = window.viewport().renderer()->pick(x, y);
            if (pick && pick->object() == object && !pick->controlPoint)
                return Vec2(x, y);
        }
    return std::nullopt;
}

TEST(Viewport, ShiftAddsAndControlTakesInAndOut)
{
    Answers answers;
    const auto window = shownWindow(answers, "nine-16");
    KNOTSPAN_NEED_RENDERER(*window);
    const ObjectId a = window->document().scene().objects().begin()->first;
    const ObjectId b = window->document().scene().objects().rbegin()->first;
    using Objects = std::set<ObjectId>;
    Hand hand(*window);
    const auto click = [&](ObjectId object, Qt::KeyboardModifiers keys) {
        const auto pixel = pixelOf(*window, object);
        EXPECT_TRUE(pixel.has_value());
        hand.click(pixel.value_or(Vec2(0)), keys);
        return window->selection().objects();
    };
    EXPECT_EQ(click(a, {}), Objects{a});
    EXPECT_EQ(click(b, Qt::ShiftModifier), (Objects{a, b}));
    EXPECT_EQ(click(a, Qt::ControlModifier), Objects{b});
    EXPECT_EQ(click(a, Qt::ControlModifier), (Objects{a, b}));
    EXPECT_EQ(click(a, {}), Objects{a});
}

TEST(Viewport, EscapeTakesADragBackWithoutATrace)
{
    Answers answers;
    const auto window = shownWindow(answers, "single-100");
    KNOTSPAN_NEED_RENDERER(*window);
    const auto point = shownPoint(*window);
    ASSERT_TRUE(point.has_value());
    const Scene before = window->document().scene();
    Hand hand(*window);
    hand.press(point->pixel);
    hand.move(point->pixel + Vec2(30, 20));
    EXPECT_FALSE(window->document().scene() == before);
    window->action("edit.deselect")->trigger();
    EXPECT_TRUE(window->document().scene() == before);
    hand.move(point->pixel + Vec2(60, 20));  // the hand is still down, and no longer drags
    hand.release();
    EXPECT_TRUE(window->document().scene() == before);
    EXPECT_FALSE(window->document().isModified());
    EXPECT_FALSE(window->document().canUndo());
    EXPECT_FALSE(window->document().canRedo());
}

TEST(Viewport, AClickOnAControlPointSelectsItAndMovesNothing)
{
    Answers answers;
    const auto window = shownWindow(answers, "single-100");
    KNOTSPAN_NEED_RENDERER(*window);
    const auto point = shownPoint(*window);
    ASSERT_TRUE(point.has_value());
    Hand hand(*window);
    hand.press(point->pixel);
    hand.move(point->pixel + Vec2(1, 1));
    hand.release();
    EXPECT_EQ(window->selection().points().size(), 1U);
    EXPECT_TRUE(window->selection().points().contains({point->object, point->index}));
    EXPECT_FALSE(window->document().isModified());
}

TEST(Viewport, MarksTheControlPointThatAClickWouldTake)
{
    Answers answers;
    const auto window = shownWindow(answers, "single-100");
    KNOTSPAN_NEED_RENDERER(*window);
    const auto point = shownPoint(*window);
    ASSERT_TRUE(point.has_value());
    const QImage plain = picture(*window);
    Hand hand(*window);
    hand.move(point->pixel);
    settle(*window);
    ASSERT_TRUE(window->selection().hovered().has_value());
    EXPECT_TRUE(window->selection().hovered()->index == point->index);
    EXPECT_GT(differingPixels(picture(*window), plain), 0);
    hand.move({3, 3});
    settle(*window);
    EXPECT_FALSE(window->selection().hovered().has_value());
    EXPECT_EQ(differingPixels(picture(*window), plain), 0);
}

TEST(Viewport, DrawsOnlyWhenSomethingChangedAndOnceATurn)
{
    Answers answers;
    const auto window = shownWindow(answers, "single-100");
    KNOTSPAN_NEED_RENDERER(*window);
    int frames = 0;
    QObject::connect(&window->viewport(), &Viewport::frameDrawn, window.get(), [&] { ++frames; });
    settle(*window);
    EXPECT_EQ(frames, 0);
    Hand hand(*window);
    hand.drag(centre(*window), centre(*window) + Vec2(50, 20), Qt::MiddleButton);
    settle(*window);
    EXPECT_EQ(frames, 1);
    window->findChild<QSlider*>("tolerance-slider")->setValue(3);
    settle(*window);
    EXPECT_EQ(frames, 2);
}

TEST(Viewport, TheMouseOrbitsPansAndZooms)
{
    Answers answers;
    const auto window = shownWindow(answers, "single-100");
    KNOTSPAN_NEED_RENDERER(*window);
    Viewport& viewport = window->viewport();
    Hand hand(*window);
    const Camera start = viewport.frame().camera;
    const Vec2 middle = centre(*window);

    hand.drag(middle, middle + Vec2(40, 10), Qt::MiddleButton);
    const Camera orbited = viewport.frame().camera;
    EXPECT_NEAR(glm::length(orbited.target - start.target), 0, 1e-9 * start.distance());
    EXPECT_NEAR(orbited.distance(), start.distance(), 1e-9 * start.distance());
    EXPECT_GT(glm::length(orbited.eye - start.eye), 0.01 * start.distance());

    hand.drag(middle, middle + Vec2(40, 10), Qt::RightButton);
    const Camera panned = viewport.frame().camera;
    const PictureSize size = viewport.pictureSize();
    const auto moved = panned.toPixel(orbited.target, size.width, size.height);
    ASSERT_TRUE(moved.has_value());
    EXPECT_NEAR(moved->x, middle.x + 40, 0.01);  // what the hand took stays under it
    EXPECT_NEAR(moved->y, middle.y + 10, 0.01);

    hand.wheel(middle, 2);
    EXPECT_LT(viewport.frame().camera.distance(), panned.distance());
    hand.drag({5, 5}, {45, 5});  // a left drag beside the model turns the view
    EXPECT_NE(viewport.frame().camera.eye, panned.eye);
    EXPECT_TRUE(window->selection().objects().empty());
    EXPECT_FALSE(window->document().isModified());
}

TEST(Viewport, TheStandardViewsAndFitShowTheWholeModel)
{
    Answers answers;
    const auto window = shownWindow(answers, "nine-16");
    KNOTSPAN_NEED_RENDERER(*window);
    Viewport& viewport = window->viewport();
    const PictureSize size = viewport.pictureSize();
    for (const char* id : {"view.front", "view.back", "view.left", "view.right", "view.top", "view.bottom",
                           "view.iso", "view.fit", "view.orthographic", "view.fit"}) {
        window->action(id)->trigger();
        for (const auto& [unused, object] : window->document().scene().objects())
            for (const ControlPoint& point : object->surface.controlPoints()) {
                const auto pixel = viewport.frame().camera.toPixel(
                    transformed(point.position, object->transform), size.width, size.height);
                ASSERT_TRUE(pixel.has_value()) << id;
                EXPECT_TRUE(pixel->x >= 0 && pixel->x <= size.width && pixel->y >= 0 &&
                            pixel->y <= size.height)
                    << id;
            }
    }
    EXPECT_TRUE(viewport.frame().camera.orthographic);
    EXPECT_TRUE(settle(*window));
}

}  // namespace
}  // namespace knotspan
