#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

class Picking : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (sharedRenderer() == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        frame = frameOf(scene, sharedRenderer()->bestPath(), 400, 300);
    }

    [[nodiscard]] Vec2 pixelOf(ObjectId id, ControlPointIndex index) const
    {
        return frame.camera.toPixel(controlPointInModel(*scene.find(id), index), frame.width, frame.height)
            .value();
    }

    Scene scene = findSample("single-100")->make();
    Frame frame;
    ObjectId first = scene.objects().begin()->first;
};

TEST_F(Picking, FindsTheControlPointUnderTheCursor)
{
    frame.overlays.netsOf = {first};
    (void)drawn(*sharedRenderer(), scene, frame);
    const Vec2 at = pixelOf(first, {4, 5});
    const auto pick = sharedRenderer()->pick(at.x + 2, at.y - 1);
    ASSERT_TRUE(pick);
    ASSERT_TRUE(pick->controlPoint);
    EXPECT_EQ(pick->controlPoint->object, first);
    EXPECT_EQ(pick->controlPoint->index, (ControlPointIndex{4, 5}));
}

TEST_F(Picking, FindsNoControlPointOfANetThatIsNotShown)
{
    (void)drawn(*sharedRenderer(), scene, frame);
    const Vec2 at = pixelOf(first, {4, 5});
    EXPECT_FALSE(sharedRenderer()->pick(at.x, at.y)->controlPoint);
}

TEST_F(Picking, FindsTheSurfaceUnderTheCursorAndNothingBesideIt)
{
    (void)drawn(*sharedRenderer(), scene, frame);
    EXPECT_EQ(sharedRenderer()->pick(200, 150)->object(), first);
    EXPECT_FALSE(sharedRenderer()->pick(0, 0)->object());
    EXPECT_FALSE(sharedRenderer()->pick(-5, 1e9)->object());
}

TEST_F(Picking, ShowsTheNetWhereItsPointsAre)
{
    const Picture bare = drawn(*sharedRenderer(), scene, frame).picture;
    frame.overlays.controlNets = true;
    const Picture net = drawn(*sharedRenderer(), scene, frame).picture;
    for (int i = 0; i < 10; ++i) {
        const Vec2 at = pixelOf(first, {i, 3});
        const size_t pixel = 4 * (static_cast<size_t>(at.y) * 400 + static_cast<size_t>(at.x));
        EXPECT_NE(bare.rgba[pixel], net.rgba[pixel]) << "control point " << i << ", 3";
    }
}

TEST_F(Picking, MarksASelectedControlPoint)
{
    const Picture bare = drawn(*sharedRenderer(), scene, frame).picture;
    frame.overlays.marks = {{first, {2, 2}}};
    const Picture marked = drawn(*sharedRenderer(), scene, frame).picture;
    size_t changed = 0;
    for (size_t k = 0; k < bare.rgba.size(); k += 4)
        changed += bare.rgba[k] != marked.rgba[k] ? 1 : 0;
    EXPECT_GT(changed, 30U);
    EXPECT_LT(changed, 120U);
}

}  // namespace
}  // namespace knotspan::testing
