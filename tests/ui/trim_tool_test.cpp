// Surfaces trimmed by curves drawn over them, and whole again; what is left is found by picks, pixel by
// pixel.
#include <glm/geometric.hpp>

#include <QStatusBar>

#include "model/trimming/trim_region.h"
#include "tests/ui/one_surface_test.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class TrimToolTest : public OneSurfaceTest {
protected:
    // From above nothing of the surface turns away.
    void SetUp() override
    {
        OneSurfaceTest::SetUp();
        if (IsSkipped())
            return;
        act("view.top");
        settle(*window);
    }
    [[nodiscard]] Vec2 middle()
    {
        const PictureSize size = window->viewport().pictureSize();
        return {std::round(0.5 * size.width), std::round(0.5 * size.height)};
    }
    [[nodiscard]] const std::vector<TrimLoop>& loops() { return scene().find(id)->trimLoops; }
    [[nodiscard]] bool isHit(const Vec2& pixel)
    {
        const Result<Pick> pick = window->viewport().renderer()->pick(pixel.x, pixel.y);
        return pick && pick->place && pick->place->object == id;
    }
    // A square of that half side around the middle.
    [[nodiscard]] std::vector<Vec2> square(double half)
    {
        const Vec2 at = middle();
        return {at + Vec2(-half, -half), at + Vec2(half, -half), at + Vec2(half, half),
                at + Vec2(-half, half)};
    }
    void draw(Hand& hand, const std::vector<Vec2>& points, bool isStraight)
    {
        act("tools.trim");
        for (size_t k = 0; k < points.size(); ++k) {
            hand.click(points[k]);
            if (k == 0 && isStraight) {
                EXPECT_TRUE(hand.key(Qt::Key_S, "s"));
            }
        }
    }
    // Of a grid of pixels around the middle those whose pick is not what is expected, up to `near` pixels
    // from the square's sides.
    int wrongPixels(double half, double near, bool keepsInside)
    {
        int wrong = 0;
        for (double y = -1.5 * half; y <= 1.5 * half; y += half / 6)
            for (double x = -1.5 * half; x <= 1.5 * half; x += half / 6) {
                const double off = std::max(std::abs(x), std::abs(y)) - half;
                if (std::abs(off) > near)
                    wrong += isHit(middle() + Vec2(x, y)) != ((off < 0) == keepsInside);
            }
        return wrong;
    }
};

TEST_F(TrimToolTest, AHoleIsWhereItWasDrawnAndUndoGivesBackEveryBit)
{
    Hand hand(*window);
    const double half = 40;
    ASSERT_TRUE(isHit(middle()) && isHit(middle() + Vec2(60, 60)) && isHit(middle() - Vec2(60, 60)));
    draw(hand, square(half), true);
    EXPECT_TRUE(scene() == start) << "nothing is done yet";
    EXPECT_TRUE(hand.key(Qt::Key_Return));
    EXPECT_FALSE(loops().empty()) << "what would be left is shown";
    EXPECT_EQ(window->document().history().count(), 0);
    hand.click(middle() + Vec2(70, 0));
    settle(*window);
    EXPECT_EQ(steps(), 1);
    ASSERT_EQ(loops().size(), 1U);
    EXPECT_EQ(loops()[0].curves.size(), 4U);
    EXPECT_TRUE(TrimRegion(loops(), scene().find(id)->surface).report().empty());
    EXPECT_EQ(wrongPixels(half, 1, false), 0);
    const Scene trimmed = scene();
    act("edit.undo");
    EXPECT_TRUE(scene() == start);
    act("edit.redo");
    EXPECT_TRUE(scene() == trimmed);
    EXPECT_TRUE(window->action("edit.untrim")->isEnabled());
    act("edit.untrim");
    EXPECT_TRUE(scene() == start);
    EXPECT_EQ(steps(), 2);
}

TEST_F(TrimToolTest, TheSideThatIsClickedStays)
{
    Hand hand(*window);
    const double half = 40;
    draw(hand, square(half), true);
    hand.click(square(half)[0] + Vec2(2, 1));  // the first point closes
    hand.hover(middle());
    hand.click(middle());
    settle(*window);
    EXPECT_EQ(steps(), 1);
    EXPECT_EQ(wrongPixels(half, 1, true), 0);
    // A hole in what is left, by a smooth curve that is closed by a double click.
    draw(hand, square(15), false);
    hand.click(square(15)[3]);
    EXPECT_TRUE(hand.key(Qt::Key_Return));
    settle(*window);
    EXPECT_EQ(steps(), 2);
    ASSERT_EQ(loops().size(), 2U);
    EXPECT_FALSE(isHit(middle()));
    EXPECT_TRUE(isHit(middle() + Vec2(30, 0)));
    act("edit.fillHoles");
    settle(*window);
    EXPECT_EQ(loops().size(), 1U);
    EXPECT_TRUE(isHit(middle()));
    act("edit.undo");
    act("edit.undo");
    act("edit.undo");
    EXPECT_TRUE(scene() == start);
}

TEST_F(TrimToolTest, CurvesMayCrossLoopsThatAreThere)
{
    Hand hand(*window);
    draw(hand, square(40), true);
    hand.key(Qt::Key_Return);
    hand.key(Qt::Key_Return);
    settle(*window);
    ASSERT_EQ(loops().size(), 1U);
    std::vector<Vec2> across = square(20);
    for (Vec2& point : across)
        point += Vec2(40, 0);
    draw(hand, across, true);
    hand.key(Qt::Key_Return);
    hand.key(Qt::Key_Return);
    settle(*window);
    EXPECT_EQ(steps(), 2);
    ASSERT_EQ(loops().size(), 2U);  // the border, and one hole
    EXPECT_FALSE(isHit(middle()));
    EXPECT_FALSE(isHit(middle() + Vec2(50, 0)));
    EXPECT_TRUE(isHit(middle() + Vec2(50, 30)));
    EXPECT_TRUE(isHit(middle() + Vec2(70, 0)));
}

TEST_F(TrimToolTest, ACornerIsCutOffByACurveThatLeavesTheSurface)
{
    Hand hand(*window);
    // From the middle up beyond the surface and back.
    const PictureSize size = window->viewport().pictureSize();
    const std::vector<Vec2> points{
        middle() + Vec2(-20, 10), middle() + Vec2(20, 10), {middle().x + 20, 2}, {middle().x - 20, 2}};
    ASSERT_FALSE(isHit(points[2]));
    ASSERT_GT(size.height, 100);
    draw(hand, points, true);
    hand.key(Qt::Key_Return);
    hand.key(Qt::Key_Return);
    settle(*window);
    ASSERT_EQ(steps(), 1);
    EXPECT_FALSE(isHit(middle()));
    EXPECT_TRUE(isHit(middle() + Vec2(0, 14)));
    EXPECT_TRUE(isHit(middle() + Vec2(26, 0)));
    EXPECT_TRUE(isHit(middle() - Vec2(26, 0)));
    EXPECT_TRUE(TrimRegion(loops(), scene().find(id)->surface).report().empty());
}

TEST_F(TrimToolTest, EscapeBackspaceAndOtherToolsTakeItBack)
{
    Hand hand(*window);
    draw(hand, square(40), true);
    EXPECT_TRUE(hand.key(Qt::Key_Escape));
    EXPECT_TRUE(scene() == start);
    EXPECT_FALSE(window->viewport().isDragging());
    draw(hand, square(40), true);
    hand.key(Qt::Key_Return);
    EXPECT_FALSE(scene() == start);
    EXPECT_TRUE(hand.key(Qt::Key_Escape));
    EXPECT_TRUE(scene() == start);
    EXPECT_EQ(steps(), 0);
    draw(hand, square(40), true);
    for (int k = 0; k < 4; ++k)
        EXPECT_TRUE(hand.key(Qt::Key_Backspace));
    EXPECT_FALSE(window->viewport().isDragging());
    // Two points are no curve.
    draw(hand, {square(40)[0], square(40)[1]}, true);
    hand.key(Qt::Key_Return);
    EXPECT_TRUE(scene() == start);
    act("edit.deselect");
    EXPECT_FALSE(window->viewport().isDragging());
    EXPECT_EQ(steps(), 0);
    draw(hand, square(40), true);
    window->viewport().setTool("select");
    EXPECT_FALSE(window->viewport().isDragging());
    EXPECT_TRUE(scene() == start);
}

TEST_F(TrimToolTest, UntrimAndFillHolesSayWhatTheyNeed)
{
    const Scene before = window->document().scene();
    window->selection().clear();
    for (const auto& [name, words] :
         {std::pair("edit.untrim", "trimmed"), std::pair("edit.fillHoles", "holes")}) {
        act(name);
        EXPECT_TRUE(window->statusBar()->currentMessage().contains(words)) << name;
        EXPECT_TRUE(window->document().scene() == before);
    }
}

TEST_F(TrimToolTest, FewerThanThreePointsAreNotClosed)
{
    const Scene before = window->document().scene();
    Hand hand(*window);
    act("tools.trim");
    for (int k = 0; k < 2; ++k)
        hand.click(square(40)[static_cast<size_t>(k)]);
    hand.key(Qt::Key_Return);
    EXPECT_TRUE(window->statusBar()->currentMessage().contains("three points"));
    EXPECT_TRUE(window->document().scene() == before);
    hand.click(square(40)[2]);
    hand.key(Qt::Key_Return);
    hand.key(Qt::Key_Return);
    EXPECT_FALSE(window->document().scene() == before);
}

TEST_F(TrimToolTest, WhatIsDrawnShows)
{
    Hand hand(*window);
    act("tools.trim");
    settle(*window);
    const QImage before = picture(*window);
    for (const Vec2& point : square(40))
        hand.click(point);
    hand.hover(square(40)[3] + Vec2(-5, 0));
    settle(*window);
    EXPECT_GT(differingPixels(before, picture(*window)), 300);
    hand.key(Qt::Key_Escape);
    settle(*window);
    hand.hover({1, 1});
    settle(*window);
    EXPECT_LT(differingPixels(before, picture(*window)), 50);
}

}  // namespace
}  // namespace knotspan
