// What comes in between: previews, keys with Ctrl, the wheel, hands that come back, hidden objects. Found by
// people who tried.
#include <gtest/gtest.h>

#include <QAction>

#include <glm/geometric.hpp>

#include "model/scene/control_point_editing.h"
#include "tests/ui/one_surface_test.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class InterruptedGestures : public OneSurfaceTest {
protected:
    // An object that is only shown, not in the model, and is selected.
    ObjectId previewedSelected()
    {
        auto object = std::make_shared<SceneObject>(*scene().find(id));
        Scene numbered = scene();
        const ObjectId shown = numbered.add(*object);
        Edit edit;
        edit.set(shown, object);
        EXPECT_NE(window->document().preview(edit, "Shown"), 0);
        selection().setObjects({shown});
        selection().setPoints(pointOf(scene(), {shown, {1, 1}}));
        return shown;
    }
    [[nodiscard]] int count() { return window->document().history().count(); }
};

TEST_F(InterruptedGestures, WhatIsOnlyPreviewedIsNotActedOn)
{
    for (const char* action : {"edit.delete", "object.isolate", "object.hide", "object.lock", "points.up"}) {
        previewedSelected();
        act(action);
        EXPECT_TRUE(scene() == start) << action;
        EXPECT_EQ(count(), 0) << action;
    }
    previewedSelected();
    selection().clear();
    settle(*window);
    act("tools.grab");
    Hand hand(*window);
    const PictureSize size = window->viewport().pictureSize();
    const Vec2 middle(size.width * 0.5, size.height * 0.5);
    hand.drag(middle, middle + Vec2(30, 10));
    EXPECT_EQ(scene().objects().size(), start.objects().size());
    EXPECT_LE(count(), 1);
}

TEST_F(InterruptedGestures, ActionsWaitUntilTheHandLetsGo)
{
    const VisiblePoint at = point();
    Hand hand(*window);
    hand.press(at.pixel);
    hand.move(at.pixel + Vec2(20, 5));
    EXPECT_TRUE(window->viewport().isDragging());
    for (const char* action : {"object.lock", "object.duplicate", "points.up", "file.save", "view.top"})
        act(action);
    EXPECT_EQ(count(), 0);
    EXPECT_FALSE(scene().find(id)->locked);
    const Camera before = window->viewport().frame().camera;
    hand.wheel(at.pixel, 3);
    EXPECT_TRUE(window->viewport().frame().camera == before);
    hand.key(Qt::Key_Escape);
    hand.release();
    EXPECT_TRUE(scene() == start);
    EXPECT_FALSE(window->document().isModified());
    EXPECT_FALSE(window->viewport().isDragging());
}

TEST_F(InterruptedGestures, AButtonThatWentUpElsewhereEndsTheDrag)
{
    const VisiblePoint at = point();
    Hand hand(*window);
    hand.press(at.pixel);
    hand.move(at.pixel + Vec2(20, 5));
    const Scene moved = scene();
    hand.hover(at.pixel + Vec2(20, 5));  // no button down
    hand.hover(at.pixel + Vec2(90, 50));
    EXPECT_FALSE(window->viewport().isDragging());
    EXPECT_TRUE(scene() == moved);
    EXPECT_EQ(count(), 1);
}

TEST_F(InterruptedGestures, ADragThatComesBackIsNoStepAndLeavesRedo)
{
    const VisiblePoint at = point();
    Hand hand(*window);
    hand.drag(at.pixel, at.pixel + Vec2(20, 5));
    act("edit.undo");
    EXPECT_TRUE(window->document().canRedo());
    settle(*window);
    for (const char* tool : {"tools.select", "tools.grab", "tools.weight"}) {
        act(tool);
        settle(*window);
        hand.press(at.pixel);
        hand.move(at.pixel + Vec2(20, -15));
        hand.move(at.pixel);
        hand.release();
        EXPECT_TRUE(scene() == start) << tool;
        EXPECT_FALSE(window->document().isModified()) << tool;
        EXPECT_TRUE(window->document().canRedo()) << tool;
    }
}

TEST_F(InterruptedGestures, AHandThatOnlyTremblesChangesNothing)
{
    const VisiblePoint at = point();
    Hand hand(*window);
    for (const char* tool : {"tools.select", "tools.grab", "tools.weight"}) {
        act(tool);
        settle(*window);
        hand.press(at.pixel);
        hand.move(at.pixel + Vec2(1, 1));
        EXPECT_TRUE(scene() == start) << tool;
        hand.release();
    }
    EXPECT_EQ(count(), 0);
}

TEST_F(InterruptedGestures, PointsOfHiddenObjectsAreLetGo)
{
    const VisiblePoint at = point();
    selection().setPoints(pointOf(scene(), {id, at.index}));
    act("object.hide");
    EXPECT_TRUE(selection().points().isEmpty());
    act("points.up");
    EXPECT_EQ(count(), 1);
}

TEST_F(InterruptedGestures, AShiftClickThatMissesKeepsWhatIsSelected)
{
    selection().setPoints(rowOf(scene(), id, 2));
    settle(*window);
    const PointSelection before = selection().points();
    Hand hand(*window);
    hand.click({3, 3}, Qt::ShiftModifier);
    hand.click({3, 3}, Qt::ControlModifier);
    EXPECT_TRUE(selection().points() == before);
    hand.click({3, 3});
    EXPECT_TRUE(selection().points().isEmpty());
}

TEST_F(InterruptedGestures, AnEndedBoxIsNoLongerInThePicture)
{
    act("tools.box");
    settle(*window);
    const QImage before = picture(*window);
    Hand hand(*window);
    hand.press({30, 30});
    hand.move({200, 150});
    settle(*window);
    EXPECT_GT(differingPixels(before, picture(*window)), 100);
    hand.key(Qt::Key_Escape);
    settle(*window);
    EXPECT_EQ(differingPixels(before, picture(*window)), 0);
    hand.release();
}

}  // namespace
}  // namespace knotspan
