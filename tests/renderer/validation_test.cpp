// The validation layer, with synchronization validation, has nothing to say of a frame on any path.
#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

TEST(ValidationLayer, HasNoMessageInARenderOfAnyPath)
{
    const auto made = Renderer::create({.device = {}, .validation = true});
    if (!made &&
        (made.error().what.find("layer is not installed") != std::string::npos || !Renderer::create()))
        GTEST_SKIP() << made.error().sentence();
    ASSERT_TRUE(made) << made.error().sentence();
    Renderer& renderer = **made;
    const Scene scene = findSample("hull")->make();
    for (const PathInfo& path : paths()) {
        if (!renderer.whyUnavailable(path.id).empty())
            continue;
        Frame frame = frameOf(scene, path.id);
        frame.overlays.controlNets = true;
        frame.overlays.knotLines = true;
        frame.overlays.marks = {{scene.objects().begin()->first, {0, 0}}};
        frame.overlays.isoCurves = 3;
        frame.overlays.normals = true;
        frame.overlays.isoLines = {{scene.objects().begin()->first, Direction::V, 0.5}};
        frame.overlays.strokes = {{{10, 10}, {90, 60}}};
        frame.culling = parseCullSet("surface,lqc").value();
        for (const auto& [width, height] : {std::pair(160, 120), std::pair(200, 100)}) {
            frame.width = width;
            frame.height = height;
            EXPECT_GT(shownPixels(drawn(renderer, scene, frame).picture), 100U) << path.name;
        }
        // The next frame after a pick finds its depths as it left them.
        EXPECT_TRUE(renderer.pick(80, 60));
        EXPECT_TRUE(renderer.pick(81, 61));
        EXPECT_TRUE(renderer.draw(frame));
        EXPECT_TRUE(renderer.pick(80, 60));
        EXPECT_TRUE(renderer.captureVertices(frame));
    }
    const ObjectId id = scene.objects().begin()->first;
    const NurbsSurface& surface = scene.find(id)->surface;
    EXPECT_TRUE(
        renderer.evaluate({{id, surface.knotsU().spans()[0], surface.knotsV().spans()[0], 0.5, 0.5}}));
    EXPECT_EQ(renderer.validationMessages(), std::vector<std::string>());
}

}  // namespace
}  // namespace knotspan::testing
