#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

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

// The counted triangles are those that the tessellator made: equal vertices close every triangle of the
// pattern.
TEST(RendererBorder, CountsTheVerticesThatTheTessellatorMakes)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellation);
    const Scene scene = findSample("hull")->make();
    const Frame frame = frameOf(scene, PathId::tessellation);
    ASSERT_TRUE(renderer->sync(scene));
    const auto stats = renderer->draw(frame);
    ASSERT_TRUE(stats);
    const auto vertices = renderer->captureVertices(frame);
    ASSERT_TRUE(vertices);
    EXPECT_EQ(vertices->size(), stats->evaluations);
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
