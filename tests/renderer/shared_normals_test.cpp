// Normals that come with the neighbour's position, as the paths draw and count them.
#include <algorithm>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/geometry/knot_insertion.h"
#include "model/samples/sample_list.h"
#include "tests/joined_surfaces.h"
#include "tests/random_surface.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

// Of the text that they share, one of each kind: a mesh stage, a stage with vertices of its own, the
// processor.
constexpr PathId kPaths[] = {PathId::mesh, PathId::tessellation, PathId::cpu};

Frame plainFrame(const Scene& scene, PathId path)
{
    Frame frame = frameOf(scene, path, 64, 48);
    frame.culling = {};
    if (path != PathId::cpu)
        frame.sampling = {SamplingRule::Kind::fixed, 4};
    return frame;
}

// A sheet that is folded along one of its knot lines, and smooth across the others.
Scene foldedSheet()
{
    const NurbsSurface sheet = withKnotInserted(curvedSheet(), Direction::U, 1.0, 2);
    std::vector<ControlPoint> points = sheet.controlPoints();
    for (size_t k = 0; k < points.size(); ++k)
        points[k].position.z += 0.2 * static_cast<double>(k * k % 7);
    return sceneOf(NurbsSurface::create(sheet.knotsU(), sheet.knotsV(), std::move(points)).value());
}

// The normal on the KSQuad's own side of the knot lines around it.
Vec3 ownNormal(const NurbsSurface& surface, const CapturedVertex& vertex)
{
    const auto within = [](const KnotVector& knots, int span, double t) {
        return knots[span] + std::clamp(t, 1e-9, 1 - 1e-9) * (knots[span + 1] - knots[span]);
    };
    return evaluateNormal(surface, within(surface.knotsU(), vertex.spanU, vertex.u),
                          within(surface.knotsV(), vertex.spanV, vertex.v))
        .direction;
}

TEST(NormalsOfAllPaths, AreTheKsQuadsOwnAlongKnotLinesAndCreases)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    for (const Scene& scene : {foldedSheet(), findSample("hull")->make()}) {
        ASSERT_TRUE(renderer->sync(scene));
        for (const PathId path : kPaths) {
            if (!renderer->whyUnavailable(path).empty())
                continue;
            const auto vertices = renderer->captureVertices(plainFrame(scene, path));
            ASSERT_TRUE(vertices) << vertices.error().sentence();
            ASSERT_FALSE(vertices->empty());
            double worst = 0;
            for (const CapturedVertex& vertex : *vertices)
                worst = std::max(worst, glm::distance(ownNormal(scene.find(vertex.object)->surface, vertex),
                                                      vertex.normal));
            EXPECT_LT(worst, 1e-4) << pathInfo(path).name << " of " << scene.objects().begin()->second->name;
        }
    }
}

// Every KSQuad of a smooth surface that meets nobody has 4 corners, of which each lattice point's belongs to
// one KSQuad alone, and shares what lies within the two sides that it starts with.
TEST(NormalsOfAllPaths, AreCounted)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("single-100")->make();
    const NurbsSurface& surface = scene.objects().begin()->second->surface;
    const auto u = static_cast<std::uint64_t>(surface.knotsU().spans().size());
    const auto v = static_cast<std::uint64_t>(surface.knotsV().spans().size());
    const std::uint64_t wanted = 4 * u * v - (u + 1) * (v + 1) + 3 * ((u - 1) * v + u * (v - 1));
    for (const PathId path : kPaths) {
        if (!renderer->whyUnavailable(path).empty())
            continue;
        const auto shared = drawn(*renderer, scene, plainFrame(scene, path)).stats.normalsShared;
        EXPECT_EQ(shared.has_value(), path != PathId::cpu);
        if (shared) {
            EXPECT_EQ(*shared, wanted) << pathInfo(path).name;
        }
    }
}

TEST(NormalsOfAllPaths, AreSharedAcrossNoKnotOfFullMultiplicity)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene smooth = sceneOf(curvedSheet());
    const Scene folded = foldedSheet();
    const PathId path = renderer->bestPath();
    const auto all = drawn(*renderer, smooth, plainFrame(smooth, path)).stats.normalsShared;
    const auto fewer = drawn(*renderer, folded, plainFrame(folded, path)).stats.normalsShared;
    ASSERT_TRUE(all && fewer);
    EXPECT_EQ(*all - *fewer, 2 * (3 + 2U));  // along two sides, with their ends
}

}  // namespace
}  // namespace knotspan::testing
