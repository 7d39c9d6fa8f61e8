// What the frames of a drag send and leave behind.
#include "model/samples/sample_list.h"
#include "model/scene/control_point_editing.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

class Dragging : public ::testing::Test {
protected:
    void SetUp() override
    {
        renderer = sharedRenderer();
        if (renderer == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        frame = frameOf(scene, renderer->bestPath(), 64, 48);
        (void)draw();
    }

    FrameStats draw() { return drawn(*renderer, scene, frame).stats; }
    // One event of the hand, on a surface in the middle of the model.
    void move(ControlPointIndex index, const Vec3& by)
    {
        const ObjectId id{314};
        const SharedObject before = scene.find(id);
        scene.exchange(id,
                       withControlPointAt(*before, index, controlPointInModel(*before, index) + by).value());
    }

    Renderer* renderer = nullptr;
    Scene scene = findSample("knot")->make();
    Frame frame;
};

TEST_F(Dragging, OneControlPointAmongFifteenThousandKsQuadsSendsLessThanAKilobyteAFrame)
{
    ASSERT_EQ(scene.ksQuadCount(), 15000U);
    for (const ControlPointIndex index : {ControlPointIndex{3, 4}, {0, 4}, {0, 0}}) {
        for (int event = 0; event < 6; ++event) {
            move(index, Vec3(0.004));
            EXPECT_LE(draw().uploadBytesPerFrame, 1024U) << index.i << ", " << event;
        }
        for (int event = 0; event < 6; ++event)
            move(index, Vec3(-0.004));
        EXPECT_LE(draw().uploadBytesPerFrame, 1024U) << index.i << ", and back";
        EXPECT_LE(draw().uploadBytesPerFrame, 1024U) << index.i << ", at rest";
        EXPECT_EQ(draw().uploadBytesPerFrame, 0U) << index.i;
    }
}

// While a surface moves nothing is known of which way its KSQuads face; with the first frame at rest it is.
TEST_F(Dragging, LeavesBehindWhatALoadedModelHas)
{
    for (int event = 0; event < 5; ++event) {
        move({3, 4}, Vec3(0, 0, 0.01));
        (void)draw();
    }
    (void)draw();
    const Drawn dragged = drawn(*renderer, scene, frame);
    ASSERT_TRUE(renderer->sync(Scene()));
    (void)draw();
    const Drawn loaded = drawn(*renderer, scene, frame);
    EXPECT_EQ(dragged.stats.ksquadsDrawn, loaded.stats.ksquadsDrawn);
    EXPECT_EQ(dragged.stats.ksquadsCulled, loaded.stats.ksquadsCulled);
    EXPECT_LT(compare(dragged.picture, loaded.picture).meanShaded, 0.02);
}

TEST_F(Dragging, ShowsWhatNoCullingShows)
{
    for (int event = 0; event < 8; ++event) {
        move({3, 4}, Vec3(0.01, 0.02, -0.01));
        Frame all = frame;
        all.culling = parseCullSet("none").value();
        const Picture culled = drawn(*renderer, scene, frame).picture;
        EXPECT_EQ(culled.rgba, drawn(*renderer, scene, all).picture.rgba) << event;
    }
}

}  // namespace
}  // namespace knotspan::testing
