// Where the culling modes frustum, small and occlusion believe a KSQuad to be, by the shaders' own text in
// float: against dense samples in double of the surface that was given. KNOTSPAN_SOAK=1 looks ten times as
// often.
#include <gtest/gtest.h>

#include <array>

#include "model/samples/sample_list.h"
#include "shaders/culling/frustum.glsl"
#include "shaders/culling/hull_on_screen.glsl"
#include "shaders/culling/small.glsl"
#include "tests/facing_samples.h"
#include "tests/ksquad_views.h"
#include "tests/random_surface.h"
#include "tests/shaders/packed_source.h"

namespace knotspan::testing {
namespace {

class HullSource : public PackedSource<float> {
public:
    HullSource(const NurbsSurface& surface, const RandomView& random, const Mat4& transform)
        : PackedSource(surface)
    {
        Mat4 shift(1.0);
        shift[3] = Vec4(origin(), 1);
        map_ = mapOf(screenView(random.toClip * transform * shift, 1920, 1080));
    }

    [[nodiscard]] const gpu::PixelMap<float>& pixelMap(gpu::uint) const { return map_; }

private:
    gpu::PixelMap<float> map_;
};

struct HullCounts {
    long views = 0;
    long beyond = 0;
    long small = 0;
    long wronglyBeyond = 0;  // though a sample shows
    long wronglySmall = 0;   // though samples lie on both sides of a row and of a column of pixels' middles
    long outside = 0;        // of samples: not within the hull

    void add(const SeenKsQuad& seen, const HullSource& source)
    {
        const auto number = static_cast<gpu::uint>(seen.number);
        gpu::SeenKsQuad asked{};
        asked.hull = gpu::hullOnScreen(source, number);
        const bool isBeyond = gpu::culledByFrustum(source, number, asked);
        const bool isSmall = gpu::culledBySmall(source, number, asked);
        ++views;
        beyond += isBeyond;
        small += isSmall;
        const Vec2 middle = 0.5 * (seen.view.low + seen.view.high);
        bool shows = false;
        Vec2 low(1e300);
        Vec2 high(-1e300);
        constexpr int kSteps = 8;
        for (int i = 0; i <= kSteps; ++i)
            for (int j = 0; j <= kSteps; ++j) {
                const Vec4 at = evaluate(seen.net, double(i) / kSteps, double(j) / kSteps);
                if (at.w <= 0)
                    continue;
                const Vec2 pixel = Vec2(at) / at.w;
                shows =
                    shows || (at.z <= at.w && at.z >= 0 && glm::all(glm::lessThan(seen.view.low, pixel)) &&
                              glm::all(glm::lessThan(pixel, seen.view.high)));
                low = glm::min(low, pixel);
                high = glm::max(high, pixel);
                const Vec2 from = pixel - middle;
                outside += asked.hull.front && !(glm::all(glm::lessThanEqual(Vec2(asked.hull.low), from)) &&
                                                 glm::all(glm::lessThanEqual(from, Vec2(asked.hull.high))) &&
                                                 at.z / at.w <= static_cast<double>(asked.hull.nearest));
            }
        wronglyBeyond += isBeyond && shows;
        wronglySmall +=
            isSmall && shows && glm::all(glm::lessThan(glm::ceil(low - 0.5), glm::floor(high + 0.5)));
    }
    void record(const std::string& name) const
    {
        EXPECT_EQ(wronglyBeyond, 0) << name;
        EXPECT_EQ(wronglySmall, 0) << name;
        EXPECT_EQ(outside, 0) << name;
        ::testing::Test::RecordProperty(name + "_views", std::to_string(views));
        ::testing::Test::RecordProperty(name + "_beyond", std::to_string(beyond));
        ::testing::Test::RecordProperty(name + "_small", std::to_string(small));
    }
};

// Far away, close by and from among its points; every third from so far that a KSQuad is about a pixel.
void look(std::mt19937& random, const PlacedKsQuad& placed, Box box, int views, HullCounts& counts)
{
    for (int view = 0; view < views; ++view) {
        RandomView seen = view % 4 == 3 ? viewFromAmong(random, placed)
                                        : randomView(random, box, Vec3(0), view % 4 == 1, view % 3 == 0);
        if (view % 4 == 2) {
            Mat4 smaller(1.0);
            smaller[0][0] = smaller[1][1] = std::pow(10.0, randomBetween(random, -3.5, 0));
            seen.toClip = smaller * seen.toClip;
        }
        counts.add(seenIn(seen, placed), HullSource(*placed.surface, seen, placed.transform));
    }
}

TEST(HullOnScreen, EnclosesRandomSurfaces)
{
    constexpr std::array kOffsets{0.0, 1e3, 1e5, 1e7};
    constexpr int kViews = 20;
    std::mt19937 random(71);
    HullCounts counts;
    for (int trial = 0; trial < soakOf(70000) / (3 * kViews); ++trial) {
        const NurbsSurface surface = randomSurface(random, {.degreeU = 1 + trial % 9,
                                                            .degreeV = 1 + (trial * 4 + trial / 9) % 9,
                                                            .spans = 1 + trial % 3,
                                                            .rational = trial % 3 != 0,
                                                            .offset = kOffsets[trial / 2 % 4],
                                                            .spanRatio = trial % 4 == 0 ? 1e3 : 4.0,
                                                            .clamped = trial % 5 != 0,
                                                            .weightRatio = trial % 7 == 0 ? 100.0 : 4.0});
        for (int k = 0; k < 3; ++k)
            look(random, randomKsQuad(random, surface), surface.bounds(), kViews, counts);
    }
    counts.record("random");
    EXPECT_GT(counts.beyond, counts.views / 20);
    EXPECT_GT(counts.small, counts.views / 50);
}

TEST(HullOnScreen, EnclosesSamples)
{
    std::mt19937 random(72);
    HullCounts counts;
    const int each = soakOf(30000) / (10 * static_cast<int>(samples().size()));
    for (const Sample& sample : samples()) {
        const Scene scene = sample.make();
        const auto all = ksQuadsOf(scene);
        for (int k = 0; k < each; ++k)
            look(random, all[random() % all.size()], scene.bounds(), 10, counts);
    }
    counts.record("samples");
    EXPECT_GT(counts.beyond, counts.views / 20);
    EXPECT_GT(counts.small, counts.views / 50);
}

}  // namespace
}  // namespace knotspan::testing
