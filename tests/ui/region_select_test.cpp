// Boxes and lassos drawn by the hand take what the pure functions say, and never change the model.
#include <cmath>
#include <numbers>

#include "model/sculpting/screen_selection.h"
#include "tests/ui/one_surface_test.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class RegionSelectTest : public OneSurfaceTest {
protected:
    // Where the control points are on the picture, by the camera alone.
    [[nodiscard]] PointSelection pointsWhere(const std::function<bool(const Vec2&)>& isInside)
    {
        const PictureSize size = window->viewport().pictureSize();
        const NurbsSurface& surface = scene().find(id)->surface;
        PointSelection found;
        for (int i = 0; i < surface.countU(); ++i)
            for (int j = 0; j < surface.countV(); ++j) {
                const auto at = window->viewport().frame().camera.toPixel(surface.controlPoint(i, j).position,
                                                                          size.width, size.height);
                if (at && isInside(*at))
                    found.add(pointOf(scene(), {id, {i, j}}));
            }
        return found;
    }
    [[nodiscard]] PointSelection pointsInBox(const Vec2& low, const Vec2& high)
    {
        return pointsWhere([&](const Vec2& at) {
            return at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y;
        });
    }
    [[nodiscard]] Vec2 middle()
    {
        const PictureSize size = window->viewport().pictureSize();
        return {size.width * 0.5, size.height * 0.5};
    }
};

TEST_F(RegionSelectTest, ABoxTakesThePointsInItShiftAddsAndControlTakesThemOut)
{
    act("tools.box");
    EXPECT_TRUE(window->action("tools.box")->isChecked());
    Hand hand(*window);
    const Vec2 a = middle() - Vec2(120, 80);
    const Vec2 b = middle() + Vec2(10, 15);
    hand.drag(b, a);
    const PointSelection first = pointsInBox(a, b);
    ASSERT_FALSE(first.isEmpty());
    EXPECT_TRUE(selection().points() == first);
    const Vec2 c = middle() + Vec2(90, 70);
    hand.drag(middle(), c, Qt::LeftButton, Qt::ShiftModifier);
    PointSelection both = first;
    both.add(pointsInBox(middle(), c));
    EXPECT_GT(both.size(), first.size());
    EXPECT_TRUE(selection().points() == both);
    hand.drag(a, b, Qt::LeftButton, Qt::ControlModifier);
    both.remove(first);
    EXPECT_TRUE(selection().points() == both);
    hand.drag({2, 2}, {6, 8});
    EXPECT_TRUE(selection().points().isEmpty());
    EXPECT_TRUE(selection().contains(id));
    EXPECT_FALSE(window->document().isModified());
}

TEST_F(RegionSelectTest, ALassoTakesThePointsInsideIt)
{
    act("tools.lasso");
    Hand hand(*window);
    const double radius = 90;
    const auto corner = [&](int k) {
        const double angle = 2 * std::numbers::pi * k / 64;
        return middle() + radius * Vec2(std::cos(angle), std::sin(angle));
    };
    hand.press(corner(0));
    for (int k = 1; k < 64; ++k)
        hand.move(corner(k));
    const QImage before = picture(*window);
    settle(*window);
    EXPECT_GT(differingPixels(before, picture(*window)), 100) << "the line shows";
    hand.release();
    // Between the polygon's inner circle and its corners nothing is claimed.
    const auto away = [&](const Vec2& at) { return glm::length(at - middle()); };
    const PointSelection sure = pointsWhere([&](const Vec2& at) { return away(at) < 0.99 * radius; });
    const PointSelection most = pointsWhere([&](const Vec2& at) { return away(at) <= radius; });
    ASSERT_FALSE(sure.isEmpty());
    PointSelection beyond = selection().points();
    beyond.remove(most);
    EXPECT_TRUE(beyond.isEmpty());
    PointSelection missed = sure;
    missed.remove(selection().points());
    EXPECT_TRUE(missed.isEmpty());
    settle(*window);
    EXPECT_FALSE(window->document().isModified());
}

TEST_F(RegionSelectTest, EscapeWhileDrawingLeavesTheSelectionAlone)
{
    act("tools.box");
    selection().setPoints(pointOf(scene(), {id, {1, 1}}));
    Hand hand(*window);
    hand.press(middle() - Vec2(100, 60));
    hand.move(middle() + Vec2(100, 60));
    hand.key(Qt::Key_Escape);
    hand.release();
    EXPECT_TRUE(selection().points() == pointOf(scene(), {id, {1, 1}}));
}

TEST_F(RegionSelectTest, WherePointsAreNotTakenObjectsAre)
{
    act("tools.box");
    act("tools.takePoints");
    selection().clear();
    settle(*window);
    const PictureSize size = window->viewport().pictureSize();
    Hand hand(*window);
    hand.drag({1, 1}, middle());
    EXPECT_TRUE(selection().objects().empty()) << "only a part of it is in the box";
    hand.drag({1, 1}, {size.width - 2.0, size.height - 2.0});
    EXPECT_EQ(selection().objects(), std::set<ObjectId>{id});
    EXPECT_TRUE(selection().points().isEmpty());
    act("tools.takeObjects");
    selection().clear();
    hand.drag({1, 1}, {size.width - 2.0, size.height - 2.0});
    hand.click(middle());
    EXPECT_TRUE(selection().objects().empty());
}

TEST_F(RegionSelectTest, WhatIsHiddenOrLockedIsNotTaken)
{
    const PictureSize size = window->viewport().pictureSize();
    const Vec2 corner{size.width - 2.0, size.height - 2.0};
    Hand hand(*window);
    act("object.lock");
    EXPECT_TRUE(scene().find(id)->locked);
    EXPECT_TRUE(selection().objects().empty());
    settle(*window);
    hand.click(middle());
    EXPECT_TRUE(selection().objects().empty());
    act("edit.selectAll");
    EXPECT_TRUE(selection().objects().empty());
    act("view.nets");
    act("tools.box");
    settle(*window);
    hand.drag({1, 1}, corner);
    EXPECT_TRUE(selection().points().isEmpty());
    act("object.unlockAll");
    settle(*window);
    hand.drag({1, 1}, corner);
    EXPECT_EQ(selection().points().size(), scene().find(id)->surface.controlPoints().size());
    act("object.hide");
    EXPECT_FALSE(scene().find(id)->visible);
    settle(*window);
    hand.drag({1, 1}, corner);
    EXPECT_TRUE(selection().points().isEmpty());
    EXPECT_EQ(steps(), 3);
    while (window->document().canUndo())
        window->document().undo();
    EXPECT_TRUE(scene() == start);
}

}  // namespace
}  // namespace knotspan
