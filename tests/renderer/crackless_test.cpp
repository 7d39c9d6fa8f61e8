// No cracks: on a closed model every vertex on a KSQuad's border is drawn, to the bit, by a neighbour too.
// Nothing here knows how the renderer finds neighbours.
#include <array>
#include <bit>
#include <map>
#include <set>

#include "model/samples/sample_list.h"
#include "tests/joined_surfaces.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

using Bits = std::array<std::uint32_t, 4>;
using KsQuadKey = std::array<int, 3>;

Bits bitsOf(const Vec4& clip)
{
    Bits bits{};
    for (int k = 0; k < 4; ++k)
        bits[static_cast<size_t>(k)] = std::bit_cast<std::uint32_t>(static_cast<float>(clip[k]));
    return bits;
}

struct Case {
    std::string name;
    Scene scene;
};

class Crackless : public ::testing::TestWithParam<PathId> {};

void expectEveryBorderVertexTwice(Renderer& renderer, const Case& model, const Frame& frame)
{
    const auto vertices = renderer.captureVertices(frame);
    ASSERT_TRUE(vertices) << vertices.error().sentence();
    std::map<Bits, std::set<KsQuadKey>> drawnBy;
    std::map<Bits, bool> onBorder;
    for (const CapturedVertex& vertex : *vertices) {
        const Bits bits = bitsOf(vertex.clip);
        drawnBy[bits].insert({static_cast<int>(vertex.object), vertex.spanU, vertex.spanV});
        if (vertex.u == 0 || vertex.u == 1 || vertex.v == 0 || vertex.v == 1)
            onBorder[bits] = true;
    }
    size_t alone = 0;
    for (const auto& [bits, border] : onBorder)
        alone += drawnBy[bits].size() < 2;
    EXPECT_GT(onBorder.size(), 50U) << model.name;
    EXPECT_EQ(alone, 0U) << model.name << ", of " << onBorder.size() << " border vertices";
}

TEST_P(Crackless, OnClosedModelsEveryBorderVertexIsANeighboursToo)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, GetParam());
    const std::vector<Case> cases = {{"torus", findSample("torus")->make()},
                                     {"sphere", findSample("sphere")->make()},
                                     {"torus with T-joints", torusWithTJoints()}};
    for (const Case& model : cases) {
        ASSERT_TRUE(renderer->sync(model.scene));
        for (const double tolerance : {2.0, 0.5}) {
            Frame frame = frameOf(model.scene, GetParam(), 320, 240);
            frame.tolerancePx = tolerance;
            expectEveryBorderVertexTwice(*renderer, model, frame);
        }
    }
}

// Where a surface was pulled away from its neighbour the two no longer share vertices.
TEST_P(Crackless, SurfacesThatWerePulledApartShareNothing)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, GetParam());
    Scene scene = torusWithTJoints();
    ASSERT_TRUE(renderer->sync(scene));
    const ObjectId id = scene.objects().begin()->first;
    SceneObject moved = *scene.objects().begin()->second;
    moved.transform[3] += Vec4(0, 0, 0.01, 0);
    scene.exchange(id, std::make_shared<const SceneObject>(std::move(moved)));
    ASSERT_TRUE(renderer->sync(scene));
    const auto vertices = renderer->captureVertices(frameOf(scene, GetParam(), 320, 240));
    ASSERT_TRUE(vertices) << vertices.error().sentence();
    std::set<Bits> own;
    std::set<Bits> others;
    for (const CapturedVertex& vertex : *vertices)
        (vertex.object == id ? own : others).insert(bitsOf(vertex.clip));
    EXPECT_GT(own.size(), 20U);
    for (const Bits& bits : own)
        EXPECT_EQ(others.count(bits), 0U);
}

std::vector<PathId> pathsThatKeepTheTolerance()
{
    std::vector<PathId> found;
    for (const PathInfo& path : paths())
        if (path.keepsTolerance())
            found.push_back(path.id);
    return found;
}

INSTANTIATE_TEST_SUITE_P(Path, Crackless, ::testing::ValuesIn(pathsThatKeepTheTolerance()), pathTestName);

}  // namespace
}  // namespace knotspan::testing
