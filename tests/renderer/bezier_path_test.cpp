// The baseline `bezier`, and what it costs against paths that draw from the surfaces' own control points.
#include "model/samples/sample_list.h"
#include "model/scene/control_point_editing.h"
#include "model/scene/deformation.h"
#include "shaders/shared/layouts.h"
#include "tests/renderer/render_support.h"

#include <algorithm>

namespace knotspan::testing {
namespace {

constexpr const char* kSurfaceKinds[] = {"control points", "span tables", "KSQuad records",
                                         "surface records"};

class BezierPath : public ::testing::Test {
protected:
    void SetUp() override
    {
        renderer = sharedRenderer();
        if (renderer == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        KNOTSPAN_NEED_PATH(*renderer, PathId::bezier);
    }

    // At rest, then deformed a few times: the last frame's figures.
    [[nodiscard]] FrameStats deforming(PathId path, Deformation deformation)
    {
        const Scene rest = findSample("knot")->make();
        Frame frame = frameOf(rest, path, 160, 120);
        (void)drawn(*renderer, rest, frame);
        std::vector<FrameStats> frames;
        for (int k = 1; k <= 4; ++k) {
            const DeformedScene moved = deformedFor(pathInfo(path).drawsFromDevice, rest, deformation, k);
            frame.wave = moved.wave;
            EXPECT_TRUE(renderer->sync(moved.scene, moved.joins));
            const auto stats = renderer->draw(frame);
            EXPECT_TRUE(stats);
            frames.push_back(stats.value_or(FrameStats()));
        }
        frames.erase(frames.begin());  // made the wave's pipeline
        FrameStats all = combined(frames);
        RecordProperty(pathInfo(path).name + "_bytes", static_cast<int>(all.uploadBytesPerFrame));
        RecordProperty(pathInfo(path).name + "_cpu_ms", std::to_string(all.cpuMs.median));
        return all;
    }

    [[nodiscard]] std::uint64_t heldBytes(bool surfacesOnly) const
    {
        std::uint64_t bytes = 0;
        for (const HeldMemory& held : renderer->memory()) {
            const bool isOfSurfaces =
                std::count(std::begin(kSurfaceKinds), std::end(kSurfaceKinds), held.kind) > 0;
            // The depth pyramid is of the picture, as its depths are, whatever the model.
            if (isOfSurfaces || (!surfacesOnly && held.kind != "depth pyramid"))
                bytes += held.bytes;
        }
        return bytes;
    }

    Renderer* renderer = nullptr;
};

TEST_F(BezierPath, DrawsWhatTessellationDraws)
{
    for (const char* name : {"nine-16", "torus", "extremes"}) {
        const Scene scene = findSample(name)->make();
        Frame frame = frameOf(scene, PathId::tessellation);
        const Drawn wanted = drawn(*renderer, scene, frame);
        frame.path = PathId::bezier;
        const Drawn got = drawn(*renderer, scene, frame);
        EXPECT_GT(shownPixels(got.picture), 1000U) << name;
        EXPECT_EQ(got.stats.ksquads, wanted.stats.ksquads) << name;
        const Difference difference = compare(wanted.picture, got.picture);
        EXPECT_EQ(difference.silhouetteOff, 0U) << name;
        EXPECT_LT(difference.meanShaded, 0.1) << name;
    }
}

TEST_F(BezierPath, KeepsTheTolerance)
{
    for (const char* name : {"single-100", "sphere"}) {
        const Scene scene = findSample(name)->make();
        Frame frame = frameOf(scene, PathId::bezier);
        frame.shading = Shading::error;
        const FrameStats stats = drawn(*renderer, scene, frame).stats;
        EXPECT_GT(stats.errorPxMax.value(), 0.0) << name;
        EXPECT_LE(*stats.errorPxMax, frame.tolerancePx + KNOTSPAN_ERROR_NOISE_PX) << name;
    }
}

TEST_F(BezierPath, CullsTheKsQuadsThatTessellationCulls)
{
    const Scene scene = findSample("torus")->make();
    Frame frame = frameOf(scene, PathId::tessellation);
    frame.culling = parseCullSet("surface,lqc").value();
    const FrameStats wanted = drawn(*renderer, scene, frame).stats;
    frame.path = PathId::bezier;
    const FrameStats got = drawn(*renderer, scene, frame).stats;
    EXPECT_LT(wanted.ksquadsDrawn, wanted.ksquads);
    EXPECT_EQ(got.ksquadsDrawn, wanted.ksquadsDrawn);
}

TEST_F(BezierPath, DrawsControlNetsWhereTessellationDrawsThem)
{
    const Scene scene = findSample("single-100")->make();
    Frame frame = frameOf(scene, PathId::tessellation);
    frame.overlays.controlNets = true;
    frame.overlays.marks = {{scene.objects().begin()->first, {2, 3}}};
    const Picture wanted = drawn(*renderer, scene, frame).picture;
    frame.overlays = {};
    const Picture without = drawn(*renderer, scene, frame).picture;
    frame.path = PathId::bezier;
    (void)drawn(*renderer, scene, frame);
    frame.overlays.controlNets = true;
    frame.overlays.marks = {{scene.objects().begin()->first, {2, 3}}};
    const Picture got = drawn(*renderer, scene, frame).picture;
    EXPECT_GT(compare(wanted, without).meanShaded, 1.0);
    EXPECT_LT(compare(wanted, got).meanShaded, 0.1);

    const Scene moved = deformed(scene, Deformation::all, 9);
    const Picture movedGot = drawn(*renderer, moved, frame).picture;
    frame.path = PathId::tessellation;
    EXPECT_LT(compare(drawn(*renderer, moved, frame).picture, movedGot).meanShaded, 0.1);
    EXPECT_GT(compare(got, movedGot).meanShaded, 0.1);
}

TEST_F(BezierPath, SendsTheNetsOfAnEditedSurfaceAndOfNoOther)
{
    Scene scene = findSample("nine-16")->make();
    const Frame frame = frameOf(scene, PathId::bezier);
    (void)drawn(*renderer, scene, frame);
    const ObjectId id = std::next(scene.objects().begin(), 4)->first;
    const SharedObject before = scene.find(id);
    scene.exchange(
        id,
        withControlPointAt(*before, {1, 1}, controlPointInModel(*before, {1, 1}) + Vec3(0, 0, 0.3)).value());
    const Drawn edited = drawn(*renderer, scene, frame);
    EXPECT_EQ(edited.stats.uploadBytesPerFrame, 16U * 16U);  // one bicubic patch
    EXPECT_EQ(drawn(*renderer, scene, frame).stats.uploadBytesPerFrame, 0U);
    ASSERT_TRUE(renderer->sync(Scene()));
    EXPECT_LT(compare(edited.picture, drawn(*renderer, scene, frame).picture).meanShaded, 0.02);
}

TEST_F(BezierPath, LeavesTheSceneRightForThePathsAfterIt)
{
    const Scene scene = findSample("nine-16")->make();
    Frame frame = frameOf(scene, PathId::tessellation);
    const Picture before = drawn(*renderer, scene, frame).picture;
    frame.path = PathId::bezier;
    (void)drawn(*renderer, scene, frame);
    const auto point = renderer->evaluate({{scene.objects().rbegin()->first, 3, 3, 0.25, 0.5}});
    frame.path = PathId::tessellation;
    EXPECT_EQ(before.rgba, drawn(*renderer, scene, frame).picture.rgba);
    const auto same = renderer->evaluate({{scene.objects().rbegin()->first, 3, 3, 0.25, 0.5}});
    ASSERT_TRUE(point && same);
    EXPECT_EQ(point->points.at(0).position, same->points.at(0).position);
}

TEST_F(BezierPath, ForOneMovedControlPointOthersSendLessThanAKilobyte)
{
    for (const PathId path : {PathId::mesh, PathId::tessellation, PathId::compute})
        if (renderer->whyUnavailable(path).empty()) {
            EXPECT_EQ(deforming(path, Deformation::point).uploadBytesPerFrame, 16U) << pathInfo(path).name;
        }
    // 25 bicubic patches.
    EXPECT_EQ(deforming(PathId::bezier, Deformation::point).uploadBytesPerFrame, 25U * 16U * 16U);
}

// A corner of a surface, where four meet, torn away and put back: who lies along which border changes too.
TEST_F(BezierPath, ForOneMovedCornerTessellationSendsLessThanAKilobyte)
{
    Scene scene = findSample("knot")->make();
    const Scene whole = scene;
    const Frame frame = frameOf(scene, PathId::tessellation, 160, 120);
    (void)drawn(*renderer, scene, frame);
    const ObjectId id = std::next(scene.objects().begin(), 300)->first;
    const SharedObject before = scene.find(id);
    for (const ControlPointIndex index : {ControlPointIndex{0, 0}, ControlPointIndex{0, 4}}) {
        scene.exchange(
            id, withControlPointAt(*before, index, controlPointInModel(*before, index) + Vec3(0, 0, 0.05))
                    .value());
        for (const Scene& wanted : {scene, whole}) {
            const std::uint64_t bytes = drawn(*renderer, wanted, frame).stats.uploadBytesPerFrame;
            EXPECT_GT(bytes, 16U);
            EXPECT_LE(bytes, 1024U);
        }
    }
}

TEST_F(BezierPath, ForAWholeModelThatMovesOthersSendLessThanAFifth)
{
    const FrameStats bezier = deforming(PathId::bezier, Deformation::all);
    EXPECT_GE(bezier.uploadBytesPerFrame, bezier.ksquads * 16U * 16U);
    for (const PathId path : {PathId::mesh, PathId::tessellation})
        if (renderer->whyUnavailable(path).empty()) {
            EXPECT_LE(deforming(path, Deformation::all).uploadBytesPerFrame, bezier.uploadBytesPerFrame / 5)
                << pathInfo(path).name;
        }
}

TEST_F(BezierPath, HoldsFourTimesTheMemoryOfTheSurfacesThemselves)
{
    const Scene scene = findSample("knot")->make();
    Frame frame = frameOf(scene, PathId::bezier, 1280, 800);
    (void)drawn(*renderer, scene, frame);
    const std::uint64_t bezier = heldBytes(true);
    frame.path = PathId::tessellation;
    frame.culling = defaultCulling();
    (void)drawn(*renderer, scene, frame);
    for (const HeldMemory& held : renderer->memory())
        RecordProperty(held.kind, static_cast<int>(held.bytes));
    RecordProperty("bezier", static_cast<int>(bezier));
    EXPECT_LE(heldBytes(true), bezier / 4);
    EXPECT_LE(heldBytes(false), bezier / 2);
}

}  // namespace
}  // namespace knotspan::testing
