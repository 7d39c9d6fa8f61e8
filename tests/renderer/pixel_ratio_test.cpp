// Widths and sizes of overlays are in the hand's pixels: on a screen of smaller ones they take more.
#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

class PixelRatio : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (sharedRenderer() == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        frame = frameOf(scene, sharedRenderer()->bestPath(), 200, 150, "top");
    }

    // How many pixels have the colour, for the same picture with `ratio` times as many pixels each way.
    [[nodiscard]] double pixelsAt(int ratio, std::uint32_t colour)
    {
        Frame larger = frame;
        larger.width *= ratio;
        larger.height *= ratio;
        larger.pixelRatio = ratio;
        return static_cast<double>(pixelsOf(drawn(*sharedRenderer(), scene, larger).picture, colour));
    }

    Scene scene = findSample("single-100")->make();
    ObjectId object = scene.objects().begin()->first;
    Frame frame;
};

TEST_F(PixelRatio, MarksGrowWithIt)
{
    frame.overlays.marks = {{object, {3, 4}, 0xff00ff, 12}};
    const double plain = pixelsAt(1, 0xff00ff);
    EXPECT_GT(plain, 60);
    EXPECT_NEAR(pixelsAt(2, 0xff00ff) / plain, 4, 0.6);
}

TEST_F(PixelRatio, LinesAlongEdgesDoSo)
{
    frame.overlays.isoLines = {{object, Direction::U, 3.5, 0xff00ff, 5}};
    const double plain = pixelsAt(1, 0xff00ff);
    EXPECT_GT(plain, 100);
    EXPECT_NEAR(pixelsAt(2, 0xff00ff) / plain, 4, 0.8);
}

TEST_F(PixelRatio, LinesInTheModelDoSo)
{
    auto lines = std::make_shared<SpaceLines>();
    lines->lines = {{{1, 2, 3}, {8, 7, 3}}};
    lines->colour = 0xff00ff;
    lines->widthPx = 5;
    frame.overlays.spaceLines = {lines};
    const double plain = pixelsAt(1, 0xff00ff);
    EXPECT_GT(plain, 100);
    EXPECT_NEAR(pixelsAt(2, 0xff00ff) / plain, 4, 0.8);
}

TEST_F(PixelRatio, KnotLinesAndControlPointsDoSo)
{
    const auto changed = [&](int ratio, bool knots) {
        Frame larger = frame;
        larger.width *= ratio;
        larger.height *= ratio;
        larger.pixelRatio = ratio;
        const Picture bare = drawn(*sharedRenderer(), scene, larger).picture;
        larger.overlays.knotLines = knots;
        larger.overlays.controlNets = !knots;
        larger.overlays.hulls = false;
        return static_cast<double>(changedPixels(bare, drawn(*sharedRenderer(), scene, larger).picture));
    };
    for (const bool knots : {true, false}) {
        const double plain = changed(1, knots);
        EXPECT_GT(plain, 300);
        EXPECT_NEAR(changed(2, knots) / plain, 4, 1) << knots;
    }
}

}  // namespace
}  // namespace knotspan::testing
