// Conservative culling changes no pixel: the picture with each such mode, and with all of them, is to the bit
// that without, on every path. KNOTSPAN_SWEEP=50 takes all 50 views of each closed sample; without it a few.
#include <algorithm>

#include "model/samples/sample_list.h"
#include "tests/joined_surfaces.h"
#include "tests/pixels/error_measurement.h"

namespace knotspan::testing {
namespace {

std::vector<CullSet> conservativeSets()
{
    std::vector<CullSet> sets;
    CullSet all;
    for (int mode = 0; mode < kCullModeCount; ++mode)
        if (cullModes()[static_cast<size_t>(mode)].conservative) {
            all.set(mode, true);
            sets.push_back({1U << mode});
        }
    sets.push_back(all);
    return sets;
}

std::uint64_t culled(const FrameStats& stats)
{
    std::uint64_t sum = 0;
    for (const std::uint64_t count : stats.ksquadsCulled)
        sum += count;
    return sum;
}

// The others cull by occlusion not at all: they draw all at once.
bool drawsInHalves(PathId path)
{
    return path != PathId::mesh9x9 && path != PathId::cpu && path != PathId::surface;
}

class ConservativeCulling : public ::testing::TestWithParam<PathId> {
protected:
    // What is drawn with `culling`, of a scene that is held.
    Picture pictureWith(Renderer& renderer, Frame frame, const CullSet& culling)
    {
        frame.culling = culling;
        const auto stats = renderer.draw(frame);
        EXPECT_TRUE(stats) << stats.error().sentence();
        if (!stats)
            return {};
        culled_ += culled(*stats);
        auto picture = renderer.capture();
        EXPECT_TRUE(picture) << picture.error().sentence();
        return picture ? *picture : Picture{};
    }

    void expectSamePictures(Renderer& renderer, const Frame& frame)
    {
        const Picture without = pictureWith(renderer, frame, {});
        for (const CullSet& set : conservativeSets()) {
            const Picture with = pictureWith(renderer, frame, set);
            size_t differing = 0;
            for (size_t k = 0; k < without.rgba.size(); ++k)
                differing += with.rgba[k] != without.rgba[k];
            EXPECT_EQ(differing, 0U) << "bytes, with " << ::testing::PrintToString(names(set));
        }
    }

    std::uint64_t culled_ = 0;
};

TEST_P(ConservativeCulling, ChangesNoPixelOfClosedModels)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, GetParam());
    const int views = sweepViews(4);
    for (const char* name : {"torus", "sphere", "knot"}) {
        const Scene scene = findSample(name)->make();
        ASSERT_TRUE(renderer->sync(scene));
        std::mt19937 random(5);
        Frame frame = frameOf(scene, GetParam(), isWholeSweep() ? 320 : 120, isWholeSweep() ? 240 : 90);
        // Many KSQuads take their time.
        const int few = name == std::string("knot") && !isWholeSweep() ? 1 : views;
        for (int view = 0; view < few; ++view) {
            frame.camera = randomCamera(random, scene.bounds(), 0.02);
            frame.tolerancePx = view % 2 == 0 ? 0.5 : 2;
            SCOPED_TRACE(std::string(name) + ", view " + std::to_string(view));
            expectSamePictures(*renderer, frame);
        }
    }
    if (GetParam() != PathId::surface) {  // it knows no KSQuads
        EXPECT_GT(culled_, 0U);
    }
    RecordProperty("culled", std::to_string(culled_));
}

// What the last frame saw decides what is drawn first: a camera that jumps, and one that stays.
TEST_P(ConservativeCulling, ByOcclusionChangesNoPixelWhenTheCameraJumpsOrStays)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, GetParam());
    if (!drawsInHalves(GetParam()))
        GTEST_SKIP() << "it draws all at once, without culling by occlusion";
    std::uint64_t occluded = 0;
    for (const char* name : {"torus", "knot"}) {
        const Scene scene = findSample(name)->make();
        ASSERT_TRUE(renderer->sync(scene));
        std::mt19937 random(6);
        std::vector<Frame> frames;
        for (int view = 0; view < sweepViews(3); ++view) {
            Frame frame = frameOf(scene, GetParam(), 120, 90);
            frame.camera = randomCamera(random, scene.bounds(), 0.05);
            frames.insert(frames.end(), 3, frame);
        }
        std::vector<Picture> without;
        for (const Frame& frame : frames)
            without.push_back(pictureWith(*renderer, frame, {}));
        for (size_t k = 0; k < frames.size(); ++k) {
            SCOPED_TRACE(std::string(name) + ", frame " + std::to_string(k));
            const std::uint64_t before = culled_;
            const Picture with = pictureWith(*renderer, frames[k], parseCullSet("occlusion").value());
            occluded += culled_ - before;
            EXPECT_TRUE(with.rgba == without[k].rgba);
        }
    }
    EXPECT_GT(occluded, 0U);
    RecordProperty("occluded", std::to_string(occluded));
}

// An eye within a body, a mirrored body, one whose normals point inwards.
TEST_P(ConservativeCulling, ChangesNoPixelFromInsideNorOfMirroredOrTurnedBodies)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, GetParam());
    const Scene torus = findSample("torus")->make();
    for (const bool turned : {false, true}) {
        const bool mirrored = !turned;
        SceneObject object = *torus.objects().begin()->second;
        if (mirrored)
            object.transform[0] *= -1.0;
        else
            object.surface = reversedU(object.surface);
        Scene scene;
        scene.add(std::move(object));
        ASSERT_TRUE(renderer->sync(scene));
        Frame frame = frameOf(scene, GetParam(), 120, 90);
        expectSamePictures(*renderer, frame);
        frame.camera.eye = {mirrored ? -2.0 : 2.0, 0, 0};  // in the middle of the tube
        frame.camera.target = {0, 2, 0};
        expectSamePictures(*renderer, frame);
    }
}

INSTANTIATE_TEST_SUITE_P(Path, ConservativeCulling, ::testing::ValuesIn(allPaths()), pathTestName);

}  // namespace
}  // namespace knotspan::testing
