// Near the best that can be: what the default modes leave is little more than what shows. KNOTSPAN_SWEEP
// takes all 64 views of each orbit; without it a few.
#include <cstdlib>
#include <set>

#include <glm/gtc/constants.hpp>

#include "model/core/spread.h"
#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

constexpr int kViews = 64;

int viewsBetween()
{
    return std::getenv("KNOTSPAN_SWEEP") != nullptr ? 1 : kViews / 4;
}

Frame frameOfView(const Scene& scene, int view, const CullSet& culling)
{
    Frame frame = frameOf(scene, PathId::mesh, 640, 480);
    frame.camera.orbit(glm::two_pi<double>() * view / kViews, 0);
    frame.culling = culling;
    return frame;
}

FrameStats statsOf(Renderer& renderer, const Frame& frame)
{
    const auto stats = renderer.draw(frame);
    EXPECT_TRUE(stats) << stats.error().sentence();
    return stats ? *stats : FrameStats{};
}

// How many KSQuads own a pixel of the last frame.
size_t shownKsQuads(Renderer& renderer)
{
    const auto pixels = renderer.captureKsQuads();
    EXPECT_TRUE(pixels) << pixels.error().sentence();
    std::set<std::uint32_t> shown;
    if (pixels)
        shown.insert(pixels->indices.begin(), pixels->indices.end());
    shown.erase(0);
    return shown.size();
}

class NearTheBest : public ::testing::TestWithParam<const char*> {};

TEST_P(NearTheBest, DrawsLittleMoreThanOwnsAPixel)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh);
    const Scene scene = findSample(GetParam())->make();
    ASSERT_TRUE(renderer->sync(scene));
    std::vector<double> ratios;
    for (int view = 0; view < kViews; view += viewsBetween()) {
        // The views before it on the orbit: culling by occlusion starts from what it saw there, and takes two
        // frames to forget a jump.
        for (int before = 3; before > 0; --before)
            (void)statsOf(*renderer, frameOfView(scene, view - before, defaultCulling()));
        const FrameStats stats = statsOf(*renderer, frameOfView(scene, view, defaultCulling()));
        const size_t shown = shownKsQuads(*renderer);
        ASSERT_GT(shown, 0U);
        ASSERT_GE(stats.ksquadsDrawn, shown);
        ratios.push_back(static_cast<double>(stats.ksquadsDrawn) / static_cast<double>(shown));
    }
    const Spread spread = spreadOf(ratios);
    RecordProperty("drawn_per_shown", std::to_string(spread.median));
    RecordProperty("drawn_per_shown_most", std::to_string(spread.max));
    EXPECT_LE(spread.median, 1.3);
}

INSTANTIATE_TEST_SUITE_P(Sample, NearTheBest, ::testing::Values("sphere", "torus", "knot", "hull"),
                         [](const auto& test) { return std::string(test.param); });

// The eye in the middle of the model, so that most of it is beside the picture or behind.
class InsideTheModel : public ::testing::TestWithParam<const char*> {
protected:
    // How much is evaluated with culling, of what is evaluated without: the median over a few directions.
    static double evaluatedShare(Renderer& renderer, const char* sampling, const CullSet& culling)
    {
        const Scene scene = findSample(GetParam())->make();
        EXPECT_TRUE(renderer.sync(scene));
        std::vector<double> shares;
        for (int view = 0; view < kViews; view += kViews / 4) {
            Frame frame = frameOfView(scene, view, {});
            frame.camera.eye = frame.camera.target + 0.1 * (frame.camera.eye - frame.camera.target);
            frame.sampling = parseSamplingRule(sampling).value();
            const FrameStats without = statsOf(renderer, frame);
            frame.culling = culling;
            for (int before = 3; before > 0; --before)
                (void)statsOf(renderer, frame);
            const FrameStats with = statsOf(renderer, frame);
            shares.push_back(static_cast<double>(with.evaluations) /
                             static_cast<double>(without.evaluations));
        }
        const double share = spreadOf(shares).median;
        RecordProperty("evaluated", std::to_string(share));
        return share;
    }
};

TEST_P(InsideTheModel, LessThanATenthIsEvaluatedWhereSamplingDoesNotLookAtThePicture)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh);
    EXPECT_LE(evaluatedShare(*renderer, "fixed:2", defaultCulling()), 0.1);
}

// The bound gives no cells to what is not in the picture: there is next to nothing left for culling to save.
TEST_P(InsideTheModel, TheBoundEvaluatesNextToNothingBesideThePictureEvenWithoutCulling)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh);
    EXPECT_GE(evaluatedShare(*renderer, "bound", parseCullSet("frustum").value()), 0.95);
}

INSTANTIATE_TEST_SUITE_P(Sample, InsideTheModel, ::testing::Values("torus", "knot"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace knotspan::testing
