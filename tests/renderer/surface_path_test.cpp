// The path surface: a whole surface as the primitive, as the older scheme had it.
#include <gtest/gtest.h>

#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

TEST(SurfacePath, DrawsTheSameTorusAsThePathOfNineByNineVertices)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::surface);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh9x9);
    const Scene scene = findSample("torus")->make();
    Frame frame = frameOf(scene, PathId::surface);
    frame.sampling = {SamplingRule::Kind::fixed, 64};
    const Drawn whole = drawn(*renderer, scene, frame);
    const Drawn ksquads = drawn(*renderer, scene, frameOf(scene, PathId::mesh9x9));
    const Difference difference = compare(whole.picture, ksquads.picture);
    EXPECT_EQ(difference.silhouetteOff, 0U);
    EXPECT_LT(difference.meanShaded, 2.0);
    EXPECT_EQ(whole.stats.triangles, 2U * 64U * 64U);
    EXPECT_EQ(whole.stats.ksquadsDrawn, whole.stats.ksquads);
}

TEST(SurfacePath, CountsWhatTheTessellatorMakes)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::surface);
    const Scene scene = findSample("hull")->make();
    Frame frame = frameOf(scene, PathId::surface);
    frame.sampling = {SamplingRule::Kind::edge, 0};
    const FrameStats stats = drawn(*renderer, scene, frame).stats;
    const auto vertices = renderer->captureVertices(frame);
    ASSERT_TRUE(vertices);
    EXPECT_EQ(vertices->size(), stats.evaluations);
    EXPECT_GT(stats.triangles, stats.surfaces);
}

TEST(SurfacePath, FollowsTheToleranceByLengths)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::surface);
    const Scene scene = findSample("nine-16")->make();
    for (const SamplingRule::Kind rule : {SamplingRule::Kind::area, SamplingRule::Kind::edge}) {
        Frame frame = frameOf(scene, PathId::surface);
        frame.sampling = {rule, 0};
        std::uint64_t fewer = 0;
        for (const double tolerance : {4.0, 1.0}) {
            frame.tolerancePx = tolerance;
            const std::uint64_t triangles = drawn(*renderer, scene, frame).stats.triangles;
            EXPECT_GT(triangles, fewer) << tolerance;
            fewer = triangles;
        }
    }
}

TEST(SurfacePath, RefusesTheBoundWithASentence)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::surface);
    const Scene scene = findSample("torus")->make();
    Frame frame = frameOf(scene, PathId::surface);
    frame.sampling = {SamplingRule::Kind::bound, 0};
    const auto stats = renderer->draw(frame);
    ASSERT_FALSE(stats);
    EXPECT_NE(stats.error().sentence().find("area"), std::string::npos);
}

}  // namespace
}  // namespace knotspan::testing
