#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

#include <array>
#include <numeric>
#include <set>

namespace knotspan::testing {
namespace {

CullSet only(const char* name)
{
    return parseCullSet(name).value();
}

class Culling : public ::testing::TestWithParam<PathId> {};

TEST_P(Culling, DropsNothingWhereNoModeIsOn)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, GetParam());
    const Scene scene = findSample("torus")->make();
    const FrameStats stats = drawn(*renderer, scene, frameOf(scene, GetParam())).stats;
    EXPECT_EQ(stats.ksquads, scene.ksQuadCount());
    EXPECT_EQ(stats.ksquadsDrawn, stats.ksquads);
}

TEST_P(Culling, DrawsOrDropsEveryKsQuadJustOnce)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, GetParam());
    const Scene scene = findSample("torus")->make();
    Frame frame = frameOf(scene, GetParam());
    frame.culling = only("surface,lqc");
    const FrameStats stats = drawn(*renderer, scene, frame).stats;
    const auto culled =
        std::accumulate(stats.ksquadsCulled.begin(), stats.ksquadsCulled.end(), std::uint64_t{0});
    EXPECT_EQ(stats.ksquadsDrawn + culled, stats.ksquads);
}

// About half of a closed body faces away.
TEST_P(Culling, ByLqcDropsAboutHalfOfASphere)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, GetParam());
    const Scene scene = findSample("sphere")->make();
    Frame frame = frameOf(scene, GetParam());
    frame.culling = only("lqc");
    const FrameStats stats = drawn(*renderer, scene, frame).stats;
    EXPECT_GT(stats.ksquadsCulled[1], stats.ksquads / 4);
    EXPECT_LT(stats.ksquadsCulled[1], stats.ksquads * 3 / 4);
}

// A single flat sheet seen from behind is dropped whole, seen from the front drawn whole.
TEST_P(Culling, BySurfaceLooksAtTheWholeSurface)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, GetParam());
    const Scene scene = findSample("single-100")->make();
    Frame frame = frameOf(scene, GetParam(), 320, 240, "top");
    frame.culling = only("surface");
    const FrameStats front = drawn(*renderer, scene, frame).stats;
    frame.camera = frameOf(scene, GetParam(), 320, 240, "bottom").camera;
    const FrameStats behind = drawn(*renderer, scene, frame).stats;
    EXPECT_EQ(front.ksquadsDrawn + behind.ksquadsDrawn, front.ksquads);
    EXPECT_TRUE(front.ksquadsDrawn == 0 || behind.ksquadsDrawn == 0);
}

TEST(CullingLists, CountTheSameOnBothPaths)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh9x9);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellation);
    const Scene scene = findSample("knot")->make();
    for (const char* modes : {"none", "surface", "lqc", "surface,lqc"})
        for (const char* view : {"iso", "front"}) {
            Frame frame = frameOf(scene, PathId::mesh9x9, 64, 48, view);
            frame.culling = only(modes);
            const FrameStats mesh = drawn(*renderer, scene, frame).stats;
            frame.path = PathId::tessellation;
            frame.sampling = {SamplingRule::Kind::fixed, 1};
            const FrameStats tessellation = drawn(*renderer, scene, frame).stats;
            EXPECT_EQ(mesh.ksquadsCulled, tessellation.ksquadsCulled) << modes << ", " << view;
            EXPECT_EQ(mesh.ksquadsDrawn, tessellation.ksquadsDrawn) << modes << ", " << view;
            EXPECT_EQ(tessellation.triangles, 2 * tessellation.ksquadsDrawn);
            EXPECT_EQ(mesh.triangles, 128 * mesh.ksquadsDrawn);
            EXPECT_EQ(mesh.evaluations, 81 * mesh.ksquadsDrawn);
        }
}

// Over many groups of the culling pass: just the KSQuads that the task stage keeps, each once.
TEST(CullingLists, HoldTheSameKsQuadsOnBothPaths)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh9x9);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellation);
    const Scene scene = findSample("knot")->make();
    ASSERT_TRUE(renderer->sync(scene));
    const auto drawnBy = [&](PathId path) {
        Frame frame = frameOf(scene, path, 64, 48);
        frame.culling = only("lqc");
        if (path == PathId::tessellation)
            frame.sampling = {SamplingRule::Kind::fixed, 1};
        std::multiset<std::array<int, 3>> firstCorners;
        const auto vertices = renderer->captureVertices(frame);
        for (const CapturedVertex& vertex : vertices.value())
            if (vertex.u == 0 && vertex.v == 0)
                firstCorners.insert({static_cast<int>(vertex.object), vertex.spanU, vertex.spanV});
        return firstCorners;
    };
    const auto mesh = drawnBy(PathId::mesh9x9);
    EXPECT_GT(mesh.size(), 5000U);
    EXPECT_EQ(std::set(mesh.begin(), mesh.end()).size(), mesh.size());
    EXPECT_EQ(mesh, drawnBy(PathId::tessellation));
}

// A mirrored body shows the same side: what is outside stays outside.
TEST_P(Culling, OfAMirroredBodyDropsWhatFacesAway)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, GetParam());
    Scene scene = findSample("sphere")->make();
    const Scene::Objects upright = scene.objects();
    for (const auto& [id, object] : upright) {
        SceneObject mirrored = *object;
        mirrored.transform[0] = -mirrored.transform[0];
        scene.exchange(id, std::make_shared<const SceneObject>(std::move(mirrored)));
    }
    Frame frame = frameOf(scene, GetParam());
    const Picture whole = drawn(*renderer, scene, frame).picture;
    frame.culling = only("lqc");
    const Drawn culled = drawn(*renderer, scene, frame);
    EXPECT_GT(culled.stats.ksquadsCulled[1], 0U);
    // Light quad culling may lose some at the silhouette, not the half that faces the eye.
    EXPECT_GT(shownPixels(culled.picture), shownPixels(whole) * 8 / 10);
}

Scene told(const char* sample, Sides sides)
{
    Scene scene = findSample(sample)->make();
    const Scene::Objects objects = scene.objects();
    for (const auto& [id, object] : objects) {
        SceneObject changed = *object;
        changed.sides = sides;
        scene.exchange(id, std::make_shared<const SceneObject>(std::move(changed)));
    }
    return scene;
}

// Of an open sheet both sides show unless it is told otherwise, and then strong culling may drop the other.
TEST_P(Culling, ShowsTheSideThatAnObjectIsTold)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, GetParam());
    for (const Sides sides : {Sides::front, Sides::back}) {
        const Scene scene = told("single-100", sides);
        int shown = 0;
        for (const char* view : {"top", "bottom"}) {
            Frame frame = frameOf(scene, GetParam(), 160, 120, view);
            const Picture whole = drawn(*renderer, scene, frame).picture;
            frame.culling = only("sqc");
            const Drawn culled = drawn(*renderer, scene, frame);
            EXPECT_EQ(culled.picture.rgba, whole.rgba) << sidesName(sides) << ", " << view;
            const bool shows = shownPixels(whole) > 0;
            shown += shows;
            EXPECT_EQ(culled.stats.ksquadsDrawn, shows ? culled.stats.ksquads : 0) << view;
        }
        EXPECT_EQ(shown, 1) << sidesName(sides);
    }
    const Scene both = told("single-100", Sides::both);
    const Scene open = told("single-100", Sides::automatic);
    const Frame frame = frameOf(both, GetParam(), 160, 120);
    EXPECT_EQ(drawn(*renderer, both, frame).picture.rgba, drawn(*renderer, open, frame).picture.rgba);
}

TEST_P(Culling, DropsNothingByFacingOfWhatIsToldToShowBothSides)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, GetParam());
    const Scene closed = told("sphere", Sides::automatic);
    Frame frame = frameOf(closed, GetParam(), 160, 120);
    frame.culling = only("sqc");
    const Drawn outside = drawn(*renderer, closed, frame);
    EXPECT_LT(outside.stats.ksquadsDrawn, outside.stats.ksquads);
    const Drawn both = drawn(*renderer, told("sphere", Sides::both), frame);
    EXPECT_EQ(both.stats.ksquadsDrawn, both.stats.ksquads);
    EXPECT_EQ(both.picture.rgba, outside.picture.rgba);  // the outside hides the inside
}

INSTANTIATE_TEST_SUITE_P(Path, Culling, ::testing::Values(PathId::mesh9x9, PathId::tessellation, PathId::cpu),
                         [](const auto& test) {
                             return test.param == PathId::mesh9x9        ? "Mesh9x9"
                                    : test.param == PathId::tessellation ? "Tessellation"
                                                                         : "Cpu";
                         });

}  // namespace
}  // namespace knotspan::testing
