// The path cpu in pictures and figures.
#include "model/samples/sample_list.h"
#include "model/scene/control_point_editing.h"
#include "shaders/shared/layouts.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

Frame cpuFrame(const Scene& scene, SamplingRule rule = {})
{
    Frame frame = frameOf(scene, PathId::cpu);
    frame.sampling = rule;
    return frame;
}

constexpr SamplingRule kFixed12{SamplingRule::Kind::fixed, 12};

TEST(CpuPath, DrawsWhatTessellationDraws)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellation);
    for (const char* name : {"torus", "nine-16"}) {
        const Scene scene = findSample(name)->make();
        Frame frame = cpuFrame(scene);
        const Picture ours = drawn(*renderer, scene, frame).picture;
        frame.path = PathId::tessellation;
        const Difference difference = compare(ours, drawn(*renderer, scene, frame).picture);
        EXPECT_EQ(difference.silhouetteOff, 0U) << name;
        EXPECT_LT(difference.meanShaded, 2.0) << name;
    }
}

TEST(CpuPath, KeepsTheTolerance)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    for (const char* name : {"torus", "nine-16", "sphere"}) {
        const Scene scene = findSample(name)->make();
        for (const double tolerance : {0.5, 2.0}) {
            Frame frame = cpuFrame(scene);
            frame.tolerancePx = tolerance;
            frame.shading = Shading::error;
            const FrameStats stats = drawn(*renderer, scene, frame).stats;
            EXPECT_LE(*stats.errorPxMax, tolerance + KNOTSPAN_ERROR_NOISE_PX) << name;
            EXPECT_GT(*stats.errorPxMax, 0.05 * tolerance) << name;
            EXPECT_LE(*stats.errorBoundPx, tolerance) << name;
        }
    }
}

TEST(CpuPath, WithAFixedRuleDrawsAUniformGridOverEverySurface)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("nine-16")->make();
    Frame frame = cpuFrame(scene, kFixed12);
    const Drawn first = drawn(*renderer, scene, frame);
    EXPECT_EQ(first.stats.triangles, 9U * 2 * 12 * 12);
    EXPECT_EQ(first.stats.evaluations, 9U * 13 * 13);
    EXPECT_EQ(first.stats.ksquadsDrawn, first.stats.ksquads);
    EXPECT_FALSE(first.stats.errorBoundPx);
    EXPECT_EQ(drawn(*renderer, scene, frame).stats.evaluations, 0U);
    frame.path = PathId::tessellation;
    frame.sampling = {SamplingRule::Kind::fixed, 32};
    EXPECT_EQ(compare(first.picture, drawn(*renderer, scene, frame).picture).silhouetteOff, 0U);
}

// A cell of such a grid lies on several KSQuads, and each of its pixels is compared with its own.
TEST(CpuPath, MeasuresTheErrorOfCellsThatLieAcrossKsQuads)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("single-100")->make();  // of 10 x 10 KSQuads
    Frame frame = cpuFrame(scene, {SamplingRule::Kind::fixed, 63});
    frame.shading = Shading::error;
    EXPECT_LT(*drawn(*renderer, scene, frame).stats.errorPxMax, 0.5);
    frame.sampling = {SamplingRule::Kind::fixed, 3};
    EXPECT_GT(*drawn(*renderer, scene, frame).stats.errorPxMax, 2.0);
}

TEST(CpuPath, SendsNothingWhileNothingMoves)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("nine-16")->make();
    for (const SamplingRule rule : {SamplingRule{}, kFixed12}) {
        const Frame frame = cpuFrame(scene, rule);
        const Drawn first = drawn(*renderer, scene, frame);
        const Drawn second = drawn(*renderer, scene, frame);
        EXPECT_EQ(second.stats.uploadBytesPerFrame, 0U);
        EXPECT_EQ(second.stats.evaluations, 0U);
        EXPECT_EQ(second.stats.triangles, first.stats.triangles);
        EXPECT_EQ(second.picture.rgba, first.picture.rgba);
    }
}

TEST(CpuPath, SendsNoVerticesOfAUniformGridForAnotherCamera)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("nine-16")->make();
    Frame frame = cpuFrame(scene, kFixed12);
    (void)drawn(*renderer, scene, frame);
    frame.camera.orbit(0.3, 0.1);
    const FrameStats stats = drawn(*renderer, scene, frame).stats;
    EXPECT_EQ(stats.evaluations, 0U);
    EXPECT_LE(stats.uploadBytesPerFrame, 9 * sizeof(gpu::SurfaceView) + sizeof(gpu::FrameRecord));
}

TEST(CpuPath, SendsLittleForAMovedControlPoint)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    Scene scene = findSample("single-100")->make();
    const Frame frame = cpuFrame(scene);
    const FrameStats first = drawn(*renderer, scene, frame).stats;
    const auto& [id, object] = *scene.objects().begin();
    const Vec3 from = controlPointInModel(*object, {5, 6});
    scene.exchange(id, withControlPointAt(*object, {5, 6}, from + Vec3(0, 0, 1e-5)).value());
    const FrameStats stats = drawn(*renderer, scene, frame).stats;
    EXPECT_GT(stats.evaluations, 0U);
    EXPECT_LT(stats.evaluations, first.evaluations / 3);
    EXPECT_GT(stats.uploadBytesPerFrame, 16U);
    EXPECT_LT(stats.uploadBytesPerFrame, first.evaluations * sizeof(gpu::ObjectVertex) / 2);
}

// Each combination of rule and shading has pipelines and buffers of its own on the same bindings.
TEST(CpuPath, DrawsTheSameAfterOtherPathsRulesAndShadings)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("torus")->make();
    const Frame bound = cpuFrame(scene);
    const Frame fixed = cpuFrame(scene, kFixed12);
    Frame errors = bound;
    errors.shading = Shading::error;
    Frame compute = bound;
    compute.path = PathId::compute;
    const Picture boundPicture = drawn(*renderer, scene, bound).picture;
    const Picture fixedPicture = drawn(*renderer, scene, fixed).picture;
    const Picture computePicture = drawn(*renderer, scene, compute).picture;
    (void)drawn(*renderer, scene, errors);
    EXPECT_EQ(drawn(*renderer, scene, compute).picture.rgba, computePicture.rgba);
    EXPECT_EQ(drawn(*renderer, scene, bound).picture.rgba, boundPicture.rgba);
    EXPECT_EQ(drawn(*renderer, scene, fixed).picture.rgba, fixedPicture.rgba);
}

TEST(CpuPath, ShowsItsVerticesOnce)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("nine-16")->make();
    Frame frame = cpuFrame(scene);
    frame.tolerancePx = 0.3;
    (void)drawn(*renderer, scene, frame);
    frame.tolerancePx = 4.0;  // leaves gaps between the vertices
    ASSERT_TRUE(renderer->sync(scene));
    const auto vertices = renderer->captureVertices(frame);
    ASSERT_TRUE(vertices);
    const FrameStats stats = drawn(*renderer, scene, frame).stats;
    EXPECT_GE(vertices->size(), 4 * stats.ksquadsDrawn);
    EXPECT_LE(vertices->size(), 4 * stats.ksdice);
    for (const CapturedVertex& vertex : *vertices) {
        EXPECT_NEAR(glm::length(vertex.normal), 1.0, 1e-5);
        EXPECT_GT(vertex.clip.w, 0.0);
    }
}

}  // namespace
}  // namespace knotspan::testing
