// Culling by a camera that stands still: what it drops stays dropped wherever the eye goes, and is outlined.
#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <set>

#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

using KsQuads = std::set<std::array<int, 3>>;

std::uint64_t culledBy(const FrameStats& stats)
{
    return std::accumulate(stats.ksquadsCulled.begin(), stats.ksquadsCulled.end(), std::uint64_t{0});
}

size_t pixelsOf(const Picture& picture, std::uint32_t colour)
{
    size_t count = 0;
    for (size_t k = 0; k < picture.rgba.size(); k += 4) {
        const auto near = [&](size_t channel, std::uint32_t wanted) {
            return std::abs(int(picture.rgba[k + channel]) - int(wanted & 255U)) <= 1;
        };
        count += near(0, colour >> 16U) && near(1, colour >> 8U) && near(2, colour) ? 1 : 0;
    }
    return count;
}

std::uint32_t colourOf(const char* name)
{
    for (const CullMode& mode : cullModes())
        if (mode.name == name)
            return mode.colour;
    ADD_FAILURE() << "no mode " << name;
    return 0;
}

class FrozenCulling : public ::testing::TestWithParam<PathId> {
protected:
    void SetUp() override
    {
        if (sharedRenderer() == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        KNOTSPAN_NEED_PATH(*sharedRenderer(), GetParam());
        frame = frameOf(scene, GetParam(), 160, 120, "front");
        frame.culling = modes();
        from = frame.camera;
        ASSERT_TRUE(sharedRenderer()->sync(scene));
    }

    // What drops some on every path, all of them at once.
    static CullSet modes()
    {
        return GetParam() == PathId::surface ? parseCullSet("surface").value() : defaultCulling();
    }
    [[nodiscard]] Frame frozenSeenFrom(std::string_view view) const
    {
        Frame frozen = frame;
        frozen.camera = frameOf(scene, GetParam(), 160, 120, view).camera;
        frozen.cullingCamera = from;
        return frozen;
    }
    static FrameStats draw(const Frame& wanted)
    {
        const auto stats = sharedRenderer()->draw(wanted);
        EXPECT_TRUE(stats) << stats.error().sentence();
        return stats.value_or(FrameStats());
    }
    static KsQuads drawnOf(const Frame& wanted)
    {
        KsQuads found;
        const auto vertices = sharedRenderer()->captureVertices(wanted);
        EXPECT_TRUE(vertices) << vertices.error().sentence();
        if (vertices)
            for (const CapturedVertex& vertex : *vertices)
                found.insert({static_cast<int>(vertex.object), vertex.spanU, vertex.spanV});
        return found;
    }

    // The sheet among them faces away from the front, all of it.
    Scene scene = [] {
        Scene both = findSample("torus")->make();
        const Scene sheet = findSample("single-100")->make();
        for (const auto& [id, object] : sheet.objects()) {
            SceneObject turned = *object;
            turned.transform = Mat4(Vec4(1, 0, 0, 0), Vec4(0, 0, -1, 0), Vec4(0, 1, 0, 0), Vec4(0, 5, 0, 1));
            both.add(std::move(turned));
        }
        return both;
    }();
    Frame frame;
    Camera from;
};

TEST_P(FrozenCulling, DropsTheSameWhereverTheEyeGoes)
{
    const FrameStats first = draw(frozenSeenFrom("front"));
    EXPECT_TRUE(first.cullingFrozen);
    EXPECT_EQ(first.culling, draw(frame).culling);
    EXPECT_GT(culledBy(first), 0U);
    EXPECT_EQ(first.ksquadsDrawn + culledBy(first), first.ksquads);
    const KsQuads kept = drawnOf(frozenSeenFrom("front"));
    for (const char* view : {"left", "back", "iso"}) {
        const FrameStats seen = draw(frozenSeenFrom(view));
        EXPECT_EQ(seen.ksquadsDrawn, first.ksquadsDrawn) << view;
        EXPECT_EQ(seen.ksquadsCulled, first.ksquadsCulled) << view;
        if (GetParam() != PathId::surface) {  // it captures whole surfaces
            EXPECT_EQ(drawnOf(frozenSeenFrom(view)), kept) << view;
        }
    }
}

TEST_P(FrozenCulling, DropsWhatItsCameraDropsAndFollowsTheEyeAgainAfterwards)
{
    const auto exact = [&](Frame wanted) {
        wanted.culling.set(CULL_OCCLUSION, false);  // that depends on the frame before
        return wanted;
    };
    const FrameStats whole = draw(exact(frame));
    const FrameStats frozen = draw(exact(frozenSeenFrom("back")));
    EXPECT_EQ(frozen.ksquadsCulled, whole.ksquadsCulled);
    Frame thawed = exact(frozenSeenFrom("back"));
    thawed.cullingCamera.reset();
    const FrameStats after = draw(thawed);
    EXPECT_FALSE(after.cullingFrozen);
    EXPECT_EQ(after.ksquadsDrawn + culledBy(after), after.ksquads);
    const Frame behind = exact(frozenSeenFrom("back"));
    Frame fresh = behind;
    fresh.cullingCamera = behind.camera;
    EXPECT_EQ(after.ksquadsCulled, draw(fresh).ksquadsCulled);
    EXPECT_NE(after.ksquadsCulled, whole.ksquadsCulled);
}

// Modes that are switched and a model that is edited are culled anew, from the camera that stands still.
TEST_P(FrozenCulling, StandsStillWhileModesAndModelChange)
{
    (void)draw(frozenSeenFrom("left"));
    Frame none = frozenSeenFrom("left");
    none.culling = {};
    EXPECT_EQ(culledBy(draw(none)), 0U);
    Scene grown = scene;
    grown.add(*findSample("sphere")->make().objects().begin()->second);
    ASSERT_TRUE(sharedRenderer()->sync(grown));
    const FrameStats left = draw(frozenSeenFrom("left"));
    EXPECT_EQ(left.ksquads, grown.ksQuadCount());
    EXPECT_EQ(left.ksquadsDrawn + culledBy(left), left.ksquads);
    EXPECT_EQ(draw(frozenSeenFrom("top")).ksquadsCulled, left.ksquadsCulled);
}

TEST_P(FrozenCulling, OutlinesWhatIsDroppedInTheColourOfItsMode)
{
    Frame wanted = frozenSeenFrom("back");
    wanted.culling = parseCullSet("surface").value();
    (void)draw(wanted);
    const auto outlined = sharedRenderer()->capture();
    ASSERT_TRUE(outlined);
    EXPECT_GT(pixelsOf(*outlined, colourOf("surface")), 50U);
    EXPECT_EQ(pixelsOf(*outlined, colourOf("frustum")), 0U);
    wanted.cullingCamera.reset();
    (void)draw(wanted);
    EXPECT_EQ(pixelsOf(*sharedRenderer()->capture(), colourOf("surface")), 0U);
}

INSTANTIATE_TEST_SUITE_P(Path, FrozenCulling, ::testing::ValuesIn(allPaths()), pathTestName);

// Each mode's own: light quad culling drops the half that faces away, whose outlines show from behind.
TEST(FrozenCullingColours, AreThoseOfTheModesAndAllDifferent)
{
    std::set<std::uint32_t> colours;
    for (const CullMode& mode : cullModes())
        EXPECT_TRUE(colours.insert(mode.colour).second) << mode.name;
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("sphere")->make();
    ASSERT_TRUE(renderer->sync(scene));
    for (const char* mode : {"lqc", "sqc", "sqc-full"}) {
        Frame frame = frameOf(scene, renderer->bestPath(), 160, 120, "back");
        frame.cullingCamera = frameOf(scene, frame.path, 160, 120, "front").camera;
        frame.culling = parseCullSet(mode).value();
        ASSERT_TRUE(renderer->draw(frame));
        const Picture picture = renderer->capture().value();
        EXPECT_GT(pixelsOf(picture, colourOf(mode)), 100U) << mode;
    }
}

TEST(FrozenCullingCounts, WrongDecisionsAreThoseOfItsCamera)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("sphere")->make();
    ASSERT_TRUE(renderer->sync(scene));
    Frame frame = frameOf(scene, renderer->bestPath(), 160, 120, "iso");
    frame.culling = parseCullSet("lqc").value();
    frame.countWrongCulls = true;
    const auto whole = renderer->draw(frame);
    ASSERT_TRUE(whole && whole->wronglyCulled);
    EXPECT_EQ(whole->wronglyCulled->size(), 1U);
    frame.cullingCamera = frame.camera;
    frame.camera = frameOf(scene, frame.path, 160, 120, "back").camera;
    EXPECT_EQ(renderer->draw(frame)->wronglyCulled, whole->wronglyCulled);
}

// A wave moves the model: it is culled anew in each frame.
TEST(FrozenCullingOfAWave, DropsOrDrawsEveryKsQuad)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("torus")->make();
    ASSERT_TRUE(renderer->sync(scene));
    Frame frame = frameOf(scene, renderer->bestPath(), 160, 120, "left");
    frame.cullingCamera = frameOf(scene, frame.path, 160, 120, "front").camera;
    frame.culling = parseCullSet("lqc").value();
    for (int step = 1; step < 3; ++step) {
        frame.wave = waveAt(scene, Deformation::all, step);
        const auto stats = renderer->draw(frame);
        ASSERT_TRUE(stats);
        EXPECT_GT(culledBy(*stats), 0U);
        EXPECT_EQ(stats->ksquadsDrawn + culledBy(*stats), stats->ksquads);
    }
}

}  // namespace
}  // namespace knotspan::testing
