// Straight lines in the picture: how much of which pixel they cover.
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

constexpr std::uint32_t kWhite = 0xffffff;
constexpr std::uint32_t kBackgroundColour = kBackground[0] << 16U | kBackground[1] << 8U | kBackground[2];

class Strokes : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (sharedRenderer() == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        frame = frameOf(scene, sharedRenderer()->bestPath(), 160, 100);
    }

    [[nodiscard]] Picture picture() const { return drawn(*sharedRenderer(), scene, frame).picture; }

    // How much of the pixel a white stroke covers.
    [[nodiscard]] static double covered(const Picture& picture, int x, int y)
    {
        return (double(colourAt(picture, x, y) >> 16U) - kBackground[0]) / (255.0 - kBackground[0]);
    }
    [[nodiscard]] static double coveredArea(const Picture& picture)
    {
        double sum = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                sum += covered(picture, x, y);
        return sum;
    }

    Scene scene;
    Frame frame;
};

TEST_F(Strokes, CoverTheirLengthAndWidthAndNoMore)
{
    frame.overlays.strokes = {{{20, 50}, {120, 50}, 0xff8000, 6, 6, 1}};
    const Picture drawnOne = picture();
    EXPECT_EQ(changedPixels(drawnOne,
                            drawn(*sharedRenderer(), scene, frameOf(scene, frame.path, 160, 100)).picture),
              600U);
    for (const int x : {20, 70, 119})
        for (const int y : {47, 50, 52})
            EXPECT_EQ(colourAt(drawnOne, x, y), 0xff8000U) << x << ", " << y;
    EXPECT_EQ(colourAt(drawnOne, 70, 46), kBackgroundColour);
    EXPECT_EQ(colourAt(drawnOne, 70, 53), kBackgroundColour);
    EXPECT_EQ(colourAt(drawnOne, 19, 50), kBackgroundColour);
    EXPECT_EQ(colourAt(drawnOne, 120, 50), kBackgroundColour);
}

TEST_F(Strokes, AreSmoothWhateverTheirDirection)
{
    for (const double angle : {0.0, 0.3, 0.8, 1.9, 3.0, 4.4}) {
        const Vec2 along(std::cos(angle), std::sin(angle));
        const Vec2 middle(80.3, 49.6);
        frame.overlays.strokes = {{middle - along * 30.0, middle + along * 30.0, kWhite, 3.5F, 3.5F, 1}};
        EXPECT_NEAR(coveredArea(picture()), 60 * 3.5, 3) << angle;
    }
    frame.overlays.strokes = {{{20, 50.5}, {120, 50.5}, kWhite, 0.5F, 0.5F, 1}};  // thinner than a pixel
    EXPECT_NEAR(covered(picture(), 70, 50), 0.5, 0.01);
}

TEST_F(Strokes, LetThroughWhatLiesBehindByTheirOpacity)
{
    for (const float opacity : {0.25F, 0.5F, 1.0F}) {
        frame.overlays.strokes = {{{20, 50}, {120, 50}, kWhite, 6, 6, opacity}};
        EXPECT_NEAR(covered(picture(), 70, 50), opacity, 0.01);
    }
    frame.overlays.strokes = {{{20, 50}, {120, 50}, kWhite, 6, 6, 0}};
    EXPECT_EQ(pixelsOf(picture(), kBackgroundColour), 160U * 100U);
}

TEST_F(Strokes, TaperAsAnArrowsHead)
{
    frame.overlays.strokes = {{{30, 50}, {110, 50}, kWhite, 40, 0, 1}};
    const Picture head = picture();
    EXPECT_NEAR(coveredArea(head), 80 * 40 / 2.0, 10);
    for (const int x : {40, 60, 80, 100}) {
        double width = 0;
        for (int y = 0; y < head.height; ++y)
            width += covered(head, x, y);
        EXPECT_NEAR(width, 0.5 * (110 - (x + 0.5)), 0.1) << x;
    }
}

TEST_F(Strokes, StandInFrontOfEverything)
{
    scene = findSample("single-100")->make();
    frame = frameOf(scene, frame.path, 160, 100);
    frame.overlays.controlNets = true;
    frame.overlays.marks = {{scene.objects().begin()->first, {5, 5}}};
    frame.overlays.strokes = {{{-1e4, 50}, {1e4, 50}, 0x009e73, 4, 4, 1}};
    const Picture crossed = picture();
    for (int x = 0; x < crossed.width; ++x)
        EXPECT_EQ(colourAt(crossed, x, 50), 0x009e73U) << x;
}

TEST_F(Strokes, WithoutLengthOrNumbersAreLeftOut)
{
    constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
    const Picture bare = picture();
    frame.overlays.strokes = {{{50, 50}, {50, 50}}, {{50, kNoNumber}, {60, 60}}, {{5, 5}, {1e300, 60}}};
    EXPECT_EQ(bare.rgba, picture().rgba);
}

TEST_F(Strokes, TravelOnlyWhereTheyChanged)
{
    frame.overlays.strokes = {{{20, 50}, {120, 50}}, {{20, 60}, {120, 60}}};
    (void)picture();
    EXPECT_EQ(sharedRenderer()->draw(frame)->uploadBytesPerFrame, 0U);
    frame.overlays.strokes[1].opacity = 0.5F;
    EXPECT_EQ(sharedRenderer()->draw(frame)->uploadBytesPerFrame, 2U * 36U);
    Frame bare = frame;
    bare.overlays.strokes.clear();
    EXPECT_EQ(sharedRenderer()->draw(bare)->uploadBytesPerFrame, 0U);
    EXPECT_EQ(pixelsOf(sharedRenderer()->capture().value(), kBackgroundColour), 160U * 100U);
}

}  // namespace
}  // namespace knotspan::testing
