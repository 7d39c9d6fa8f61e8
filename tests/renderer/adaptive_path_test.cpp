// The path tessellation-adaptive: within the tolerance, without a crack, and never more than the drawn grid.
#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <set>

#include "model/samples/sample_list.h"
#include "shaders/shared/layouts.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

FrameStats errorsOf(Renderer& renderer, const Scene& scene, PathId path, std::string_view view,
                    double tolerance)
{
    Frame frame = frameOf(scene, path, 320, 240, view);
    frame.tolerancePx = tolerance;
    frame.shading = Shading::error;
    return drawn(renderer, scene, frame).stats;
}

TEST(TessellationAdaptive, KeepsTheToleranceWithNoMoreTrianglesThanTheDrawnGrid)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellationAdaptive);
    for (const char* sample : {"torus", "sphere", "nine-16", "hull"}) {
        const Scene scene = findSample(sample)->make();
        for (const char* view : {"iso", "front"})
            for (const double tolerance : {0.25, 1.0, 4.0}) {
                SCOPED_TRACE(sample + std::string(" ") + view + " " + std::to_string(tolerance));
                const FrameStats adaptive =
                    errorsOf(*renderer, scene, PathId::tessellationAdaptive, view, tolerance);
                const FrameStats even = errorsOf(*renderer, scene, PathId::tessellation, view, tolerance);
                ASSERT_TRUE(adaptive.errorPxMax);
                EXPECT_LE(*adaptive.errorPxMax, tolerance + KNOTSPAN_ERROR_NOISE_PX);
                EXPECT_LE(adaptive.triangles, even.triangles);
                EXPECT_GT(adaptive.triangles, 0U);
            }
    }
}

// A patchwork bends unevenly: somewhere fewer than the grid's lines are enough.
TEST(TessellationAdaptive, SpendsLessWhereTheSurfaceBendsLess)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellationAdaptive);
    const Scene scene = findSample("nine-16")->make();
    Frame frame = frameOf(scene, PathId::tessellationAdaptive);
    const FrameStats adaptive = drawn(*renderer, scene, frame).stats;
    frame.path = PathId::cpu;  // the same regular grid, all of it
    EXPECT_LT(static_cast<double>(adaptive.triangles),
              0.95 * static_cast<double>(drawn(*renderer, scene, frame).stats.triangles));
}

// The bits of all vertices on the borders of KSQuads inside a surface, from either side.
using Bits = std::array<std::uint32_t, 4>;
Bits bitsOf(const Vec4& clip)
{
    const glm::vec4 floats(clip);
    Bits bits{};
    std::memcpy(bits.data(), &floats, sizeof(bits));
    return bits;
}

TEST(TessellationAdaptive, MeetsItsNeighboursInTheSameBits)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellationAdaptive);
    const Scene scene = findSample("hull")->make();
    ASSERT_TRUE(renderer->sync(scene));
    for (const SamplingRule::Kind rule : {SamplingRule::Kind::bound, SamplingRule::Kind::area}) {
        Frame frame = frameOf(scene, PathId::tessellationAdaptive);
        frame.tolerancePx = 0.25;
        frame.sampling = {rule, 0};
        const auto vertices = renderer->captureVertices(frame);
        ASSERT_TRUE(vertices);
        // By the line of constant u: object, the span before it, the span along it.
        std::map<std::tuple<ObjectId, int, int>, std::pair<std::set<Bits>, std::set<Bits>>> lines;
        for (const CapturedVertex& vertex : *vertices) {
            if (vertex.u == 1)
                lines[{vertex.object, vertex.spanU, vertex.spanV}].first.insert(bitsOf(vertex.clip));
            if (vertex.u == 0)
                lines[{vertex.object, vertex.spanU - 1, vertex.spanV}].second.insert(bitsOf(vertex.clip));
        }
        size_t compared = 0;
        for (const auto& [line, sides] : lines)
            if (!sides.first.empty() && !sides.second.empty()) {
                EXPECT_EQ(sides.first, sides.second);
                ++compared;
            }
        EXPECT_GT(compared, 50U);
    }
}

// RPNS eq. 5: without friends the borders where surfaces meet smoothly are oversampled, too.
TEST(TessellationAdaptive, OversamplesSharedBordersOnlyWithoutFriends)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellationAdaptive);
    const Scene scene = findSample("hull")->make();
    Frame frame = frameOf(scene, PathId::tessellationAdaptive);
    frame.sampling = {SamplingRule::Kind::area, 0};
    const FrameStats friends = drawn(*renderer, scene, frame).stats;
    frame.sampling = {SamplingRule::Kind::areaNoFriends, 0};
    const FrameStats none = drawn(*renderer, scene, frame).stats;
    EXPECT_GT(none.triangles, friends.triangles);
    // nine-16's surfaces share all their borders, and meet at angles: none is a friend.
    const Scene creases = findSample("nine-16")->make();
    const FrameStats all = drawn(*renderer, creases, frame).stats;
    frame.sampling = {SamplingRule::Kind::area, 0};
    EXPECT_EQ(drawn(*renderer, creases, frame).stats.triangles, all.triangles);
    EXPECT_EQ(none.sampling, "area-no-friends");
}

// One row of nine-16's control points pulled: its neighbours no longer meet it smoothly, though they still
// touch.
TEST(TessellationAdaptive, OversamplesBordersWhereSurfacesMeetInACrease)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellationAdaptive);
    Scene scene = findSample("hull")->make();
    Frame frame = frameOf(scene, PathId::tessellationAdaptive);
    frame.sampling = {SamplingRule::Kind::area, 0};
    const FrameStats smooth = drawn(*renderer, scene, frame).stats;
    ASSERT_TRUE(smooth.samplesSaved);
    EXPECT_GT(*smooth.samplesSaved, 0U);
    const auto [id, object] = *scene.objects().begin();
    std::vector<ControlPoint> points = object->surface.controlPoints();
    const int countU = object->surface.countU();
    const int countV = object->surface.countV();
    for (int i = 1; i + 1 < countU; ++i)
        for (int j = 1; j + 1 < countV; ++j)
            points[static_cast<size_t>(i * countV + j)].position.z += 0.05 * object->bounds().diagonal();
    SceneObject pulled = *object;
    pulled.surface =
        NurbsSurface::create(object->surface.knotsU(), object->surface.knotsV(), std::move(points)).value();
    scene.exchange(id, std::make_shared<const SceneObject>(std::move(pulled)));
    const FrameStats creased = drawn(*renderer, scene, frame).stats;
    ASSERT_TRUE(creased.samplesSaved);
    EXPECT_LT(*creased.samplesSaved, *smooth.samplesSaved);
    EXPECT_GT(*creased.samplesSaved, 0U);  // among the others nothing changed
    frame.sampling = {SamplingRule::Kind::areaNoFriends, 0};
    EXPECT_FALSE(drawn(*renderer, scene, frame).stats.samplesSaved);
}

TEST(TessellationAdaptive, AloneKnowsTheRuleWithoutFriends)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::compute);
    const Scene scene = findSample("nine-16")->make();
    Frame frame = frameOf(scene, PathId::compute);
    frame.sampling = {SamplingRule::Kind::areaNoFriends, 0};
    const auto stats = renderer->draw(frame);
    ASSERT_FALSE(stats);
    EXPECT_NE(stats.error().sentence().find("area-no-friends"), std::string::npos);
}

// Every cell of a fixed grid: the same triangles as the path compute.
TEST(TessellationAdaptive, DrawsAFixedGridWhole)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellationAdaptive);
    const Scene scene = findSample("torus")->make();
    for (const int count : {1, 2, 3, 7, 20}) {
        Frame frame = frameOf(scene, PathId::tessellationAdaptive, 64, 48);
        frame.sampling = {SamplingRule::Kind::fixed, count};
        const FrameStats stats = drawn(*renderer, scene, frame).stats;
        const auto cells = static_cast<std::uint64_t>(count) * static_cast<std::uint64_t>(count);
        EXPECT_EQ(stats.ksdice, stats.ksquadsDrawn * cells) << count;
        EXPECT_EQ(stats.triangles, 2 * stats.ksdice) << count;
    }
}

}  // namespace
}  // namespace knotspan::testing
