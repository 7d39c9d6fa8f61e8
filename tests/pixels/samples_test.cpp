// Every sample on every path: the same picture, whichever stages drew it.
#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

class SamplePicture : public ::testing::TestWithParam<std::string> {};

TEST_P(SamplePicture, IsTheSameOnBothPaths)
{
    KNOTSPAN_NEED_RENDERER(renderer);
    KNOTSPAN_NEED_PATH(*renderer, PathId::mesh9x9);
    KNOTSPAN_NEED_PATH(*renderer, PathId::tessellation);
    const Scene scene = findSample(GetParam())->make();
    for (const char* view : {"iso", "front", "top"}) {
        Frame frame = frameOf(scene, PathId::mesh9x9, 640, 480, view);
        const Picture mesh = drawn(*renderer, scene, frame).picture;
        frame.path = PathId::tessellation;
        const Picture tessellation = drawn(*renderer, scene, frame).picture;
        const Difference difference = compare(mesh, tessellation);
        EXPECT_GT(shownPixels(mesh), 2000U) << view;
        EXPECT_EQ(difference.silhouetteOff, 0U) << view;
        EXPECT_LT(difference.meanShaded, 1.0) << view;
        RecordProperty(std::string(view) + "_mean_difference", std::to_string(difference.meanShaded));
    }
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
