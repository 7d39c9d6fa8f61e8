// What the path mesh spends: triangles beside the fewest that would do and beside an edge rule, work groups
// beside mesh-9x9.
#include <algorithm>
#include <map>

#include <glm/gtc/matrix_transform.hpp>

#include "model/analysis/net_on_screen.h"
#include "model/samples/sample_list.h"
#include "shaders/shared/bindings.h"
#include "tests/model/analysis/measured_error.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

// Triangles of the smallest uniform grid of each KSQuad that shows, found by trying all.
std::uint64_t fewestTriangles(const Scene& scene, const Frame& frame)
{
    std::uint64_t triangles = 0;
    const Mat4 projection =
        frame.camera.projection(static_cast<double>(frame.width) / frame.height, scene.bounds());
    for (const auto& [id, object] : scene.objects()) {
        const Vec3 origin = object->surface.bounds().centre();
        Mat4 toView = frame.camera.rotation() * object->transform;
        toView[3] =
            frame.camera.rotation() * Vec4(transformed(origin, object->transform) - frame.camera.eye, 1.0);
        const ScreenView view = screenView(projection * toView, frame.width, frame.height);
        const BezierConversion conversion(object->surface, origin);
        for (const KsQuad& quad : ksQuads(object->surface)) {
            const BezierNet net = transformed(conversion.net(quad), view.toPixels);
            if (!NetOnScreen(net, view).visible)
                continue;
            const auto best = smallestMeasuredGrid(net, view, frame.tolerancePx, false, 1000);
            EXPECT_TRUE(best);
            triangles += best ? 2 * static_cast<std::uint64_t>(best->cells()) : 0;
        }
    }
    return triangles;
}

TEST(MeshPath, DrawsFewTrianglesMoreThanTheFewestThatWouldDo)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh);
    std::vector<double> ratios;
    // Not nine-16: its KSQuads take hundreds of cells each, and to try all grids takes minutes.
    for (const char* name : {"single-100", "sphere", "torus", "hull", "knot"}) {
        const Scene scene = findSample(name)->make();
        const Frame frame = frameOf(scene, PathId::mesh, 640, 480);
        const auto spent = static_cast<double>(drawn(*renderer, scene, frame).stats.triangles);
        ratios.push_back(spent / static_cast<double>(fewestTriangles(scene, frame)));
        RecordProperty(name, std::to_string(ratios.back()));
    }
    EXPECT_LE(median(ratios), 1.6);
}

// An edge rule of 8 pixels a KSDie, as the papers take it, at half a pixel.
TEST(MeshPath, SpendsAtMostHalfOfWhatAnEdgeRuleSpends)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh);
    std::vector<double> ratios;
    for (const char* name : {"single-100", "nine-16", "sphere", "torus", "hull", "knot"}) {
        const Scene scene = findSample(name)->make();
        Frame frame = frameOf(scene, PathId::mesh, 640, 480);
        const auto bound = static_cast<double>(drawn(*renderer, scene, frame).stats.triangles);
        frame.sampling = {SamplingRule::Kind::edge, 0};
        ratios.push_back(bound / static_cast<double>(drawn(*renderer, scene, frame).stats.triangles));
        RecordProperty(name, std::to_string(ratios.back()));
    }
    EXPECT_LE(median(ratios), 0.5);
}

TEST(MeshPath, TakesFewerWorkGroupsThanMesh9x9AtTheSameErrorAndKeepsThemBusy)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh);
    const Scene scene = findSample("knot")->make();
    Frame frame = frameOf(scene, PathId::mesh9x9, 320, 240);
    frame.shading = Shading::error;
    const FrameStats nine = drawn(*renderer, scene, frame).stats;
    frame.path = PathId::mesh;
    frame.tolerancePx = nine.errorPxMax.value();
    const FrameStats mesh = drawn(*renderer, scene, frame).stats;
    ASSERT_TRUE(mesh.meshGroups && mesh.busyLanes);
    EXPECT_LE(mesh.errorPxMax.value(), nine.errorPxMax.value());
    // mesh-9x9 has one for each KSQuad.
    EXPECT_LE(static_cast<double>(*mesh.meshGroups), 0.6 * static_cast<double>(nine.ksquadsDrawn));
    EXPECT_GE(*mesh.busyLanes, 0.9);
    RecordProperty("mesh_groups", std::to_string(*mesh.meshGroups));
    RecordProperty("busy_lanes", std::to_string(*mesh.busyLanes));
    static_assert(4 * (1 + TILE_PAYLOAD_WORDS) <= 128, "bytes of the payload");
}

}  // namespace
}  // namespace knotspan::testing
