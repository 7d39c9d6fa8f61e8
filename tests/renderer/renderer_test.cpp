#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace knotspan::testing {
namespace {

TEST(RendererBorder, RefusesADeviceNumberThatDoesNotExist)
{
    const auto renderer = Renderer::create({.device = 1000, .validation = false});
    ASSERT_FALSE(renderer);
    EXPECT_NE(renderer.error().sentence().find("no Vulkan device number 1000"), std::string::npos);
}

TEST(RendererBorder, RefusesPicturesWithoutSizeOrTooLarge)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    Frame frame;
    frame.path = renderer->bestPath();
    for (const auto& [width, height] : {std::pair(0, 100), std::pair(100, -1), std::pair(1 << 20, 100)}) {
        frame.width = width;
        frame.height = height;
        EXPECT_FALSE(renderer->draw(frame)) << width << " by " << height;
    }
}

TEST(RendererBorder, RefusesASamplingRuleThatThePathCannotFollow)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh9x9);
    const Scene scene = findSample("single-100")->make();
    Frame frame = frameOf(scene, PathId::mesh9x9);
    frame.sampling = {SamplingRule::Kind::area, 0};
    const auto stats = renderer->draw(frame);
    ASSERT_FALSE(stats);
    EXPECT_NE(stats.error().sentence().find("fixed:8"), std::string::npos);
}

TEST(RendererBorder, DrawsASmallerToleranceWithMoreTriangles)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellation);
    const Scene scene = findSample("torus")->make();
    Frame frame = frameOf(scene, PathId::tessellation);
    std::uint64_t fewer = 0;
    for (const double tolerance : {4.0, 1.0, 0.25}) {
        frame.tolerancePx = tolerance;
        const std::uint64_t triangles = drawn(*renderer, scene, frame).stats.triangles;
        EXPECT_GT(triangles, fewer) << tolerance;
        fewer = triangles;
    }
}

// Counted from the levels, checked against the vertices that the tessellator really made: a quad with V
// vertices, B of them on its border, has 2V - B - 2 triangles (Euler).
TEST(RendererBorder, CountsWhatTheTessellatorMakes)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellation);
    for (const char* sample : {"hull", "torus", "single-100"}) {
        const Scene scene = findSample(sample)->make();
        Frame frame = frameOf(scene, PathId::tessellation);
        frame.tolerancePx = 4;  // no KSQuad is so fine that it is cut into tiles
        const FrameStats stats = drawn(*renderer, scene, frame).stats;
        const auto vertices = renderer->captureVertices(frame);
        ASSERT_TRUE(vertices);
        EXPECT_EQ(vertices->size(), stats.evaluations) << sample;
        const auto border =
            std::count_if(vertices->begin(), vertices->end(), [](const CapturedVertex& vertex) {
                return vertex.u == 0 || vertex.u == 1 || vertex.v == 0 || vertex.v == 1;
            });
        EXPECT_EQ(stats.triangles,
                  2 * vertices->size() - static_cast<size_t>(border) - 2 * stats.ksquadsDrawn)
            << sample;
    }
}

TEST(RendererBorder, RefusesToEvaluateWhatIsNotThere)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    ASSERT_TRUE(renderer->sync(findSample("torus")->make()));
    EXPECT_FALSE(renderer->evaluate({{ObjectId{77}, 2, 2, 0.5, 0.5}}));
    EXPECT_FALSE(renderer->evaluate({{ObjectId{0}, 0, 2, 0.5, 0.5}}));
    EXPECT_TRUE(renderer->evaluate({{ObjectId{0}, 2, 2, 0.5, 0.5}}));
}

TEST(RendererBorder, LeavesOutMarksOutsideTheNet)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("hull")->make();
    Frame frame = frameOf(scene, renderer->bestPath());
    const Picture bare = drawn(*renderer, scene, frame).picture;
    frame.overlays.marks = {{scene.objects().begin()->first, {-1, 0}},
                            {scene.objects().begin()->first, {0, 100000}},
                            {ObjectId{999}, {0, 0}}};
    EXPECT_EQ(bare.rgba, drawn(*renderer, scene, frame).picture.rgba);
}

// From inside a body most of it is behind the eye and asks for nothing.
TEST(RendererBorder, SpendsNothingOnWhatLiesBehindTheEye)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellation);
    const Scene scene = findSample("torus")->make();
    Frame frame = frameOf(scene, PathId::tessellation);
    frame.camera.target = frame.camera.eye + (frame.camera.eye - frame.camera.target);
    EXPECT_EQ(drawn(*renderer, scene, frame).stats.triangles, 0U);
}

TEST(Stats, NameEveryFieldOfTheContract)
{
    FrameStats stats;
    stats.culling = {"none"};
    const auto json = nlohmann::json::parse(toJson(stats));
    for (const char* name :
         {"device", "path", "culling", "tolerance_px", "width", "height", "surfaces", "ksquads",
          "ksquads_drawn", "ksquads_culled", "ksdice", "triangles", "evaluations", "frames", "cpu_ms",
          "gpu_ms", "upload_bytes_first", "upload_bytes_per_frame", "device_bytes"})
        EXPECT_TRUE(json.contains(name)) << name;
    EXPECT_TRUE(json["culling"].is_array());
    EXPECT_TRUE(json["ksquads_culled"].contains("lqc"));
    for (const char* part : {"min", "median", "max"})
        EXPECT_TRUE(json["gpu_ms"].contains(part));
}

TEST(Stats, OfARunAreLeastMedianAndMost)
{
    std::vector<FrameStats> frames(3);
    frames[0].cpuMs = {5, 5, 5};
    frames[1].cpuMs = {1, 1, 1};
    frames[2].cpuMs = {2, 2, 2};
    frames[0].uploadBytesFirst = 100;
    frames[2].uploadBytesPerFrame = 16;
    const FrameStats stats = combined(frames);
    EXPECT_EQ(stats.cpuMs.min, 1);
    EXPECT_EQ(stats.cpuMs.median, 2);
    EXPECT_EQ(stats.cpuMs.max, 5);
    EXPECT_EQ(stats.frames, 3U);
    EXPECT_EQ(stats.uploadBytesFirst, 100U);
    EXPECT_EQ(stats.uploadBytesPerFrame, 16U);
}

TEST(Stats, AreWrittenForPeople)
{
    FrameStats stats;
    stats.triangles = 1234567;
    stats.deviceBytes = 3 << 20;
    for (const StatField& field : statFields()) {
        if (field.name == "triangles") {
            EXPECT_EQ(display(field, stats), "1,234,567");
        }
        if (field.name == "device_bytes") {
            EXPECT_EQ(display(field, stats), "3.0 MB");
        }
    }
}

}  // namespace
}  // namespace knotspan::testing
