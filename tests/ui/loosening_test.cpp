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

}  // namespace
}  // namespace knotspan
