// Every sample on every path: the same picture, whichever stages drew it.
#include <algorithm>

#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

// As large as 9 by 9 vertices a KSQuad follow: at 640 by 480 those of nine-16 are more than a pixel off.
constexpr int kWidth = 320;
constexpr int kHeight = 240;

class SamplePicture : public ::testing::TestWithParam<std::string> {};

// What mesh-9x9 draws against the tessellation path with `sampling`, from three sides. The mean is over all
// three: a contour inside a picture that is a pixel off counts as a difference of shaded pixels, and seen
// from the front there is much contour and little else.
void expectSamePictures(Renderer& renderer, const Scene& scene, SamplingRule sampling)
{
    double sum = 0;
    const std::vector<const char*> views = {"iso", "front", "top"};
    for (const char* view : views) {
        Frame frame = frameOf(scene, PathId::mesh9x9, kWidth, kHeight, view);
        const Picture mesh = drawn(renderer, scene, frame).picture;
        frame.path = PathId::tessellation;
        frame.sampling = sampling;
        frame.tolerancePx = 0.25;
        const Picture tessellation = drawn(renderer, scene, frame).picture;
        const Difference difference = compare(mesh, tessellation);
        EXPECT_GT(shownPixels(mesh), 1000U) << view;
        EXPECT_EQ(difference.silhouetteOff, 0U) << view;
        EXPECT_LT(difference.meanShaded, 1.5) << view;
        sum += difference.meanShaded;
    }
    const double mean = sum / static_cast<double>(views.size());
    EXPECT_LT(mean, 1.0);
    ::testing::Test::RecordProperty("mean_difference", std::to_string(mean));
}

TEST_P(SamplePicture, IsTheSameOnBothPathsWithTheSameSampling)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh9x9);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellation);
    expectSamePictures(*renderer, findSample(GetParam())->make(), {SamplingRule::Kind::fixed, 8});
}

TEST_P(SamplePicture, IsTheSameOnBothPathsWithTheirOwnSampling)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh9x9);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellation);
    expectSamePictures(*renderer, findSample(GetParam())->make(), {});
}

std::vector<std::string> sampleNames()
{
    std::vector<std::string> list;
    for (const Sample& sample : samples())
        list.push_back(sample.name);
    return list;
}

INSTANTIATE_TEST_SUITE_P(Sample, SamplePicture, ::testing::ValuesIn(sampleNames()), [](const auto& test) {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(Picture, IsTheSameEachTime)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    const Scene scene = findSample("hull")->make();
    for (const PathInfo& path : paths()) {
        if (!renderer->whyUnavailable(path.id).empty())
            continue;
        const Frame frame = frameOf(scene, path.id);
        const Picture first = drawn(*renderer, scene, frame).picture;
        EXPECT_EQ(first.rgba, drawn(*renderer, scene, frame).picture.rgba) << path.name;
    }
}

}  // namespace
}  // namespace knotspan::testing
