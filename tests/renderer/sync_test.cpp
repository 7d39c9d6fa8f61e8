#include "model/samples/sample_list.h"
#include "model/scene/control_point_editing.h"
#include "shaders/shared/layouts.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

class Sync : public ::testing::Test {
protected:
    void SetUp() override
    {
        renderer = sharedRenderer();
        if (renderer == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
    }

    Renderer* renderer = nullptr;
    Scene scene = findSample("nine-16")->make();
    Frame frame = frameOf(scene, renderer != nullptr ? renderer->bestPath() : PathId::tessellation);

    void SetUpScene() { (void)drawn(*renderer, scene, frame); }
    [[nodiscard]] std::uint64_t bytesOfNextFrame()
    {
        return drawn(*renderer, scene, frame).stats.uploadBytesPerFrame;
    }
    void moveControlPoint(ObjectId id, ControlPointIndex index, const Vec3& by)
    {
        const SharedObject before = scene.find(id);
        scene.exchange(id,
                       withControlPointAt(*before, index, controlPointInModel(*before, index) + by).value());
    }
};

TEST_F(Sync, SendsNothingForAnUnchangedSceneAndCamera)
{
    SetUpScene();
    EXPECT_EQ(bytesOfNextFrame(), 0U);
}

TEST_F(Sync, SendsOneControlPointForOneMovedControlPoint)
{
    SetUpScene();
    moveControlPoint(scene.objects().begin()->first, {1, 1}, {0, 0, 0.1});
    EXPECT_EQ(bytesOfNextFrame(), 16U);
}

TEST_F(Sync, SendsTheRecordOfASurfaceWhoseCornerMoved)
{
    SetUpScene();
    moveControlPoint(scene.objects().begin()->first, {0, 0}, {0, 0, 0.1});
    EXPECT_EQ(bytesOfNextFrame(), 16U + sizeof(gpu::SurfaceRecord));
}

// Nine bicubic patches: a record of 16 bytes for each and, because all have the same knots, one table:
// whether its span starts smoothly, a Bezier matrix and (p + 1)^2 floats.
TEST_F(Sync, SendsTablesAndTheirPlacesForAnotherEvaluatorAndDrawsTheSame)
{
    SetUpScene();
    frame.evaluator = Evaluator::triangular;
    const Picture before = drawn(*renderer, scene, frame).picture;
    frame.evaluator = Evaluator::power;
    const Drawn after = drawn(*renderer, scene, frame);
    EXPECT_EQ(after.stats.evaluator, "power");
    EXPECT_EQ(after.stats.uploadBytesPerFrame, 9U * 16 + (1 + 2 * 16) * 4);
    EXPECT_LT(compare(before, after.picture).meanShaded, 0.01);
    EXPECT_EQ(bytesOfNextFrame(), 0U);
}

TEST_F(Sync, ChoosesTheEvaluatorByTheLargestDegreeThatShows)
{
    SetUpScene();
    EXPECT_EQ(drawn(*renderer, scene, frame).stats.evaluator,
              evaluatorInfo(chosenEvaluator(Evaluator::automatic, 3, Precision::float32)).name);
    const Scene high = findSample("extremes")->make();
    int degree = 1;
    for (const auto& [id, object] : high.objects())
        degree = std::max({degree, object->surface.degreeU(), object->surface.degreeV()});
    EXPECT_GT(degree, 3);
    EXPECT_EQ(drawn(*renderer, high, frame).stats.evaluator,
              evaluatorInfo(chosenEvaluator(Evaluator::automatic, degree, Precision::float32)).name);
}

TEST_F(Sync, DrawsAnEditedSceneAsIfItHadBeenLoadedSo)
{
    SetUpScene();
    moveControlPoint(scene.objects().begin()->first, {1, 2}, {0.1, 0, 0.4});
    const Picture edited = drawn(*renderer, scene, frame).picture;
    ASSERT_TRUE(renderer->sync(Scene()));
    // Loaded, it is packed around its new middle: the same to the rounding of floats.
    const Difference difference = compare(edited, drawn(*renderer, scene, frame).picture);
    EXPECT_EQ(difference.silhouetteOff, 0U);
    EXPECT_LT(difference.meanShaded, 0.02);
}

// Far from where it was packed, floats relative to the old origin would be coarse.
TEST_F(Sync, PacksAnObjectAnewThatMovedFarAway)
{
    scene = Scene();
    scene.add(*findSample("single-100")->make().objects().begin()->second);
    const ObjectId id = scene.objects().begin()->first;
    SetUpScene();
    SceneObject far = *scene.find(id);
    std::vector<ControlPoint> points = far.surface.controlPoints();
    for (ControlPoint& point : points)
        point.position += Vec3(1e7, 0, 0);
    far.surface = NurbsSurface::create(far.surface.knotsU(), far.surface.knotsV(), points).value();
    scene.exchange(id, std::make_shared<const SceneObject>(far));
    frame.camera.eye += Vec3(1e7, 0, 0);
    frame.camera.target += Vec3(1e7, 0, 0);
    const Picture moved = drawn(*renderer, scene, frame).picture;
    EXPECT_NEAR(renderer->surfaceOrigin(id).x, 1e7, 10.0);
    ASSERT_TRUE(renderer->sync(Scene()));
    EXPECT_EQ(moved.rgba, drawn(*renderer, scene, frame).picture.rgba);
}

// One point far outside: all others must follow to the new origin, and the corners that culling looks at too.
TEST_F(Sync, PacksAnObjectAnewWhoseOnePointWasPulledFarAway)
{
    scene = findSample("single-100")->make();
    frame.camera = frameOf(scene, frame.path).camera;
    frame.culling = parseCullSet("surface").value();
    SetUpScene();
    const double size = scene.bounds().diagonal();
    moveControlPoint(scene.objects().begin()->first, {5, 5}, {0, 0, 10 * size});
    const Picture pulled = drawn(*renderer, scene, frame).picture;
    ASSERT_TRUE(renderer->sync(Scene()));
    const Difference difference = compare(pulled, drawn(*renderer, scene, frame).picture);
    EXPECT_EQ(difference.silhouetteOff, 0U);
    EXPECT_LT(difference.meanShaded, 0.02);
}

TEST_F(Sync, DrawsTheLaterOfTwoChangesThatCameBeforeAFrame)
{
    SetUpScene();
    const ObjectId id = scene.objects().begin()->first;
    moveControlPoint(id, {1, 1}, {0, 0, 0.5});
    ASSERT_TRUE(renderer->sync(scene));
    moveControlPoint(id, {1, 1}, {0.2, 0, 0.2});
    const Picture twice = drawn(*renderer, scene, frame).picture;
    ASSERT_TRUE(renderer->sync(Scene()));
    EXPECT_LT(compare(twice, drawn(*renderer, scene, frame).picture).meanShaded, 0.02);
}

// A corner torn from its neighbours: the borders follow with the sync after it.
TEST_F(Sync, LooksForBordersLaterWhereJoinsWereKept)
{
    SetUpScene();
    const ObjectId id = scene.objects().begin()->first;
    const std::uint64_t record = sizeof(gpu::SurfaceRecord);
    moveControlPoint(id, {3, 3}, {0, 0, 0.3});
    ASSERT_TRUE(renderer->sync(scene, Joins::kept));
    EXPECT_EQ(renderer->draw(frame)->uploadBytesPerFrame, 16U + record);
    EXPECT_GT(bytesOfNextFrame(), 0U);
    EXPECT_EQ(bytesOfNextFrame(), 0U);
}

TEST_F(Sync, PicksTheObjectThatThePictureShowsThoughAnotherIsGoneSince)
{
    SetUpScene();
    const ObjectId last = scene.objects().rbegin()->first;
    const Vec3 middle = scene.find(last)->bounds().centre();
    const Vec2 at = frame.camera.toPixel(middle, frame.width, frame.height).value();
    ASSERT_EQ(renderer->pick(at.x, at.y)->object(), last);
    scene.exchange(scene.objects().begin()->first, nullptr);
    ASSERT_TRUE(renderer->sync(scene));
    EXPECT_EQ(renderer->pick(at.x, at.y)->object(), last);
}

TEST_F(Sync, SendsTheSceneAgainAfterAFrameThatWasRefused)
{
    SetUpScene();
    const Picture before = drawn(*renderer, scene, frame).picture;
    Frame wrong = frame;
    wrong.tolerancePx = 0;
    EXPECT_FALSE(renderer->draw(wrong));
    EXPECT_EQ(before.rgba, drawn(*renderer, scene, frame).picture.rgba);
}

TEST_F(Sync, LeavesHiddenObjectsOut)
{
    SceneObject hidden = *scene.objects().begin()->second;
    hidden.visible = false;
    scene.exchange(scene.objects().begin()->first, std::make_shared<const SceneObject>(hidden));
    EXPECT_EQ(drawn(*renderer, scene, frame).stats.surfaces, scene.objects().size() - 1);
}

TEST_F(Sync, DrawsAnEmptySceneAsBackground)
{
    const Drawn nothing = drawn(*renderer, Scene(), frame);
    EXPECT_EQ(shownPixels(nothing.picture), 0U);
    EXPECT_EQ(nothing.stats.triangles, 0U);
}

}  // namespace
}  // namespace knotspan::testing
