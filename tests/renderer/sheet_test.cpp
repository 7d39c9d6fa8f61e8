// Several frames in one picture.
#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

constexpr Pane kLeft{0, 0, 200, 90};
constexpr Pane kRight{102, 0, 200, 90};

Picture cut(const Picture& from, const Pane& pane, int width, int height)
{
    Picture part{width, height, {}};
    for (int y = 0; y < height; ++y) {
        const auto row =
            from.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(pane.y + y) * from.width + pane.x);
        part.rgba.insert(part.rgba.end(), row, row + 4 * width);
    }
    return part;
}

class SheetTest : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (sharedRenderer() == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        front = frameOf(scene, sharedRenderer()->bestPath(), 98, 90, "front");
        top = frameOf(scene, sharedRenderer()->bestPath(), 98, 90, "top");
        alone[0] = drawn(*sharedRenderer(), scene, front).picture;
        alone[1] = drawn(*sharedRenderer(), scene, top).picture;
        front.pane = kLeft;
        top.pane = kRight;
    }

    Scene scene = findSample("single-100")->make();
    Frame front;
    Frame top;
    Picture alone[2];
};

TEST_F(SheetTest, HasEachFrameInItsPlaceToTheBitAndBlackBetween)
{
    Renderer& renderer = *sharedRenderer();
    const Picture first = drawn(renderer, scene, front).picture;
    ASSERT_EQ(first.width, 200);
    ASSERT_EQ(first.height, 90);
    EXPECT_EQ(colourAt(first, 150, 40), 0U) << "nobody has drawn there yet";
    const Picture both = drawn(renderer, scene, top).picture;
    EXPECT_EQ(changedPixels(cut(both, kLeft, 98, 90), alone[0]), 0U);
    EXPECT_EQ(changedPixels(cut(both, kRight, 98, 90), alone[1]), 0U);
    for (int y = 0; y < 90; ++y)
        EXPECT_EQ(colourAt(both, 100, y), 0U);
}

TEST_F(SheetTest, IsForgottenWhenAFrameFillsThePictureAgain)
{
    Renderer& renderer = *sharedRenderer();
    (void)drawn(renderer, scene, front);
    front.pane.reset();
    EXPECT_EQ(changedPixels(drawn(renderer, scene, front).picture, alone[0]), 0U);
    const Picture fresh = drawn(renderer, scene, top).picture;
    EXPECT_EQ(colourAt(fresh, 40, 40), 0U) << "of the earlier picture nothing is left";
}

TEST_F(SheetTest, BeginsWithNothingWhereTheViewsAreArrangedAnew)
{
    Renderer& renderer = *sharedRenderer();
    (void)drawn(renderer, scene, front);
    (void)drawn(renderer, scene, top);
    front.pane->x = 60;  // over parts of both
    const Picture anew = drawn(renderer, scene, front).picture;
    EXPECT_EQ(changedPixels(cut(anew, *front.pane, 98, 90), alone[0]), 0U);
    for (const int x : {0, 30, 59, 158, 199})
        EXPECT_EQ(colourAt(anew, x, 45), 0U) << x;
}

TEST_F(SheetTest, PicksInTheFrameThatWasDrawnLast)
{
    Renderer& renderer = *sharedRenderer();
    (void)drawn(renderer, scene, front);
    (void)drawn(renderer, scene, top);
    const Result<Pick> pick = renderer.pick(49, 45);
    ASSERT_TRUE(pick.has_value());
    ASSERT_TRUE(pick->place.has_value());
    const auto pixel = top.camera.toPixel(pick->place->position, top.width, top.height);
    ASSERT_TRUE(pixel.has_value());
    EXPECT_NEAR(pixel->x, 49.5, 1);
    EXPECT_NEAR(pixel->y, 45.5, 1);
}

TEST_F(SheetTest, LeavesOutWhatWouldStandOut)
{
    Renderer& renderer = *sharedRenderer();
    front.pane = Pane{150, 60, 200, 90};
    const Picture picture = drawn(renderer, scene, front).picture;
    EXPECT_EQ(picture.width, 200);
    EXPECT_EQ(changedPixels(cut(picture, *front.pane, 50, 30), cut(alone[0], {}, 50, 30)), 0U);
}

TEST_F(SheetTest, RefusesASizeThatNoPictureHas)
{
    front.pane = Pane{0, 0, 0, 90};
    EXPECT_FALSE(sharedRenderer()->draw(front).has_value());
}

}  // namespace
}  // namespace knotspan::testing
