// Straight lines in the model: where they are, what hides them, when they travel.
#include <limits>

#include "model/geometry/primitives.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

constexpr std::uint32_t kOrange = 0xff8000;

SharedSpaceLines linesOf(std::vector<SpaceLine> lines, float widthPx = 4)
{
    return std::make_shared<const SpaceLines>(SpaceLines{std::move(lines), kOrange, widthPx});
}

class SpaceLinesTest : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (sharedRenderer() == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        frame.path = sharedRenderer()->bestPath();
        frame.width = 200;
        frame.height = 160;
        frame.camera = {.eye = {0, -10, 3}, .target = {0, 0, 0}, .up = {0, 0, 1}};
    }
    [[nodiscard]] Picture picture() const { return drawn(*sharedRenderer(), scene, frame).picture; }
    [[nodiscard]] Vec2 pixel(const Vec3& point) const
    {
        return frame.camera.toPixel(point, frame.width, frame.height).value();
    }
    // The square |x|, |z| <= 1 in the plane y = 0.
    void addWall()
    {
        SceneObject wall{.surface = plane({-1, 0, -1}, {2, 0, 0}, {0, 0, 2})};
        scene.add(wall);
    }

    Scene scene;
    Frame frame;
};

TEST_F(SpaceLinesTest, RunWhereTheirEndsAreSeen)
{
    // Behind it all: without a surface an orthographic picture has no depth.
    scene.add({.surface = plane({-4, 4, -4}, {8, 0, 0}, {0, 0, 8})});
    const Vec3 from(-1.5, 1, -0.5);
    const Vec3 to(1, -2, 0.7);
    for (const bool orthographic : {false, true}) {
        frame.camera.orthographic = orthographic;
        frame.overlays.spaceLines = {linesOf({{from, to}})};
        const Picture shown = picture();
        for (const double part : {0.02, 0.3, 0.6, 0.98})
            EXPECT_TRUE(isNear(shown, pixel(from + (to - from) * part), kOrange)) << part;
        for (const double part : {-0.1, 1.1})
            EXPECT_FALSE(isNear(shown, pixel(from + (to - from) * part), kOrange)) << part;
    }
}

TEST_F(SpaceLinesTest, HaveTheWidthAskedFor)
{
    frame.camera = {.eye = {0, -10, 0}, .target = {0, 0, 0}, .up = {0, 0, 1}};
    frame.overlays.spaceLines = {linesOf({{{-50, 0, 0}, {50, 0, 0}}}, 6)};
    EXPECT_EQ(pixelsOf(picture(), kOrange), 6U * 200U);
}

TEST_F(SpaceLinesTest, AreHiddenBySurfacesInFrontOfThem)
{
    addWall();
    frame.overlays.spaceLines = {linesOf({{{-0.5, 2, 0}, {0.5, 2, 0}}})};
    EXPECT_EQ(pixelsOf(picture(), kOrange), 0U);
    frame.overlays.spaceLines = {linesOf({{{-0.5, -2, 0}, {0.5, -2, 0}}})};
    EXPECT_GT(pixelsOf(picture(), kOrange), 40U);
    frame.overlays.spaceLines = {linesOf({{{-0.5, 0, 0.2}, {0.5, 0, 0.2}}})};
    EXPECT_GT(pixelsOf(picture(), kOrange), 40U) << "one that lies on the surface shows";
}

TEST_F(SpaceLinesTest, ThatReachBehindTheEyeEndAtIt)
{
    const Vec3 behind = frame.camera.eye + Vec3(0.4, -8, 2);
    frame.overlays.spaceLines = {linesOf({{{0, 0, 0}, behind}})};
    const Picture shown = picture();
    EXPECT_TRUE(isNear(shown, pixel({0, 0, 0}), kOrange));
    EXPECT_TRUE(isNear(shown, pixel(behind * 0.3), kOrange));
    frame.overlays.spaceLines = {linesOf({{behind, behind + Vec3(1, 0, 0)}})};
    EXPECT_EQ(pixelsOf(picture(), kOrange), 0U);
}

TEST_F(SpaceLinesTest, KeepTheirPlaceFarFromTheOrigin)
{
    const Vec3 far(3e7, -5e7, 1e7);
    frame.camera.eye += far;
    frame.camera.target += far;
    frame.overlays.spaceLines = {linesOf({{far + Vec3(-1, 0, 0), far + Vec3(1, 0, 0.5)}})};
    const Picture shown = picture();
    for (const double x : {-0.9, 0.0, 0.9})
        EXPECT_TRUE(isNear(shown, pixel(far + Vec3(x, 0, 0.25 + 0.25 * x)), kOrange)) << x;
}

TEST_F(SpaceLinesTest, TravelOnlyWhereOthersShow)
{
    const SharedSpaceLines first = linesOf({{{-1, 0, 0}, {1, 0, 0}}});
    const SharedSpaceLines second = linesOf({{{-1, 0, 1}, {1, 0, 1}}, {{-1, 0, 0.5}, {1, 0, 0.5}}});
    frame.overlays.spaceLines = {first, second};
    (void)picture();
    EXPECT_EQ(sharedRenderer()->draw(frame)->uploadBytesPerFrame, 0U);
    frame.overlays.spaceLines = {second};
    EXPECT_EQ(sharedRenderer()->draw(frame)->uploadBytesPerFrame, 2U * 32U);
    frame.overlays.spaceLines.clear();
    EXPECT_EQ(sharedRenderer()->draw(frame)->uploadBytesPerFrame, 0U);
    EXPECT_EQ(pixelsOf(sharedRenderer()->capture().value(), kOrange), 0U);
}

TEST_F(SpaceLinesTest, WithoutLengthOrNumbersAreLeftOut)
{
    constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
    const Picture bare = picture();
    frame.overlays.spaceLines = {
        linesOf({{{0, 0, 0}, {0, 0, 0}}, {{0, kNoNumber, 0}, {1, 0, 0}}, {{0, 0, 0}, {1e300, 0, 0}}})};
    EXPECT_EQ(bare.rgba, picture().rgba);
}

}  // namespace
}  // namespace knotspan::testing
