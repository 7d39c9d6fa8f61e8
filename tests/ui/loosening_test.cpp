// While the hand moves, pictures may be coarser than asked for; at rest they never are.
#include "tests/ui/one_surface_test.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class LooseningTest : public OneSurfaceTest {
protected:
    void SetUp() override
    {
        OneSurfaceTest::SetUp();
        if (window->viewport().renderer() == nullptr)
            return;
        QObject::connect(&window->viewport(), &Viewport::frameDrawn,
                         [this](const FrameStats& stats) { drawn.push_back(stats.tolerancePx); });
    }
    // With a picture after each move, as a patient hand has it.
    void dragPatiently()
    {
        const VisiblePoint at = point();
        Hand hand(*window);
        hand.press(at.pixel);
        for (int k = 1; k <= 24; ++k) {
            hand.move(at.pixel + Vec2(k, -k));
            window->viewport().drawNow();
        }
        hand.release();
    }
    std::vector<double> drawn;
};

TEST_F(LooseningTest, ADragMayBeCoarserAndItsRestIsAsAskedFor)
{
    const double asked = window->viewport().frame().tolerancePx;
    settle(*window);
    drawn.clear();
    dragPatiently();
    ASSERT_GT(drawn.size(), 20U);
    for (const double tolerance : drawn) {
        EXPECT_GE(tolerance, asked);
        EXPECT_LE(tolerance, std::max(Pace::kLoosestPx, asked));
    }
    ASSERT_TRUE(settle(*window));
    EXPECT_EQ(drawn.back(), asked);
    const QImage after = picture(*window);
    window->viewport().drawNow();
    EXPECT_EQ(differingPixels(after, picture(*window), 0), 0);
}

TEST_F(LooseningTest, ItRestsWhileTheButtonIsHeldToo)
{
    const double asked = window->viewport().frame().tolerancePx;
    const VisiblePoint at = point();
    Hand hand(*window);
    hand.press(at.pixel);
    for (int k = 1; k <= 12; ++k) {
        hand.move(at.pixel + Vec2(k, -k));
        window->viewport().drawNow();
    }
    ASSERT_TRUE(settle(*window));
    EXPECT_EQ(drawn.back(), asked);
    hand.release();
}

TEST_F(LooseningTest, SwitchedOffItNeverIs)
{
    act("view.loosen");
    EXPECT_FALSE(window->action("view.loosen")->isChecked());
    const double asked = window->viewport().frame().tolerancePx;
    drawn.clear();
    dragPatiently();
    settle(*window);
    for (const double tolerance : drawn)
        EXPECT_EQ(tolerance, asked);
    act("view.loosen");
}

// A hole drawn by hand, so that its border may be sharp while the view turns.
TEST_F(LooseningTest, BordersOfTrimmedSurfacesAreSmoothAtRest)
{
    act("view.top");
    settle(*window);
    Hand hand(*window);
    const PictureSize size = window->viewport().pictureSize();
    const Vec2 middle(std::round(0.5 * size.width), std::round(0.5 * size.height));
    act("tools.trim");
    for (const Vec2& way : {Vec2(-40, -30), Vec2(45, -35), Vec2(40, 42), Vec2(-35, 38)})
        hand.click(middle + way);
    EXPECT_TRUE(hand.key(Qt::Key_Return));
    EXPECT_TRUE(hand.key(Qt::Key_Return));
    ASSERT_FALSE(scene().find(id)->trimLoops.empty());
    act("tools.select");
    settle(*window);
    hand.press(middle, Qt::MiddleButton);
    for (int k = 1; k <= 8; ++k) {
        hand.move(middle + Vec2(4 * k, k));
        window->viewport().drawNow();
    }
    hand.release();
    ASSERT_TRUE(settle(*window));
    const QImage rested = picture(*window);
    window->viewport().drawNow();
    EXPECT_EQ(differingPixels(rested, picture(*window), 0), 0);
    act("view.smoothEdges");
    ASSERT_TRUE(settle(*window));
    EXPECT_GT(differingPixels(rested, picture(*window), 8), 20);
    act("view.smoothEdges");
    ASSERT_TRUE(settle(*window));
    EXPECT_EQ(differingPixels(rested, picture(*window), 0), 0);
}

}  // namespace
}  // namespace knotspan
