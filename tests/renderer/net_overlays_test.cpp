// What pictures show of control points and of objects that are pointed at: marks, the parts of nets, tints.
#include "model/geometry/evaluation.h"
#include "model/geometry/primitives.h"
#include "model/samples/sample_list.h"
#include "tests/renderer/render_support.h"

namespace knotspan::testing {
namespace {

constexpr std::uint32_t kBlue = 0x0072b2;
constexpr std::uint32_t kVermilion = 0xd55e00;
constexpr std::uint32_t kPointColour = 0xfadb6b;  // of a net's points where nothing hides them

class NetOverlays : public ::testing::Test {
protected:
    void SetUp() override
    {
        renderer = sharedRenderer();
        if (renderer == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        frame = frameOf(scene, renderer->bestPath(), 240, 180);
    }

    [[nodiscard]] Picture picture() const { return drawn(*renderer, scene, frame).picture; }
    [[nodiscard]] Vec2 pixelOf(ObjectId id, ControlPointIndex index) const
    {
        return frame.camera.toPixel(controlPointInModel(*scene.find(id), index), frame.width, frame.height)
            .value();
    }
    [[nodiscard]] Vec2 middleOf(ObjectId id) const
    {
        const SceneObject& object = *scene.find(id);
        const auto middle = [](const KnotVector& knots) {
            return 0.5 * (knots.domainStart() + knots.domainEnd());
        };
        const Vec3 point =
            evaluate(object.surface, middle(object.surface.knotsU()), middle(object.surface.knotsV()))
                .position;
        return frame.camera.toPixel(transformed(point, object.transform), frame.width, frame.height).value();
    }
    void lock(ObjectId id)
    {
        SceneObject locked = *scene.find(id);
        locked.locked = true;
        scene.exchange(id, std::make_shared<const SceneObject>(locked));
    }

    Renderer* renderer = nullptr;
    Scene scene = findSample("nine-16")->make();
    ObjectId first = scene.objects().begin()->first;
    ObjectId last = scene.objects().rbegin()->first;
    Frame frame;
};

TEST_F(NetOverlays, MarksHaveTheirColoursAndSizes)
{
    frame.overlays.marks = {{first, {1, 2}, kBlue, 14}, {last, {2, 1}, kVermilion, 6}};
    const Picture marked = picture();
    const auto isMarked = [&](ObjectId id, ControlPointIndex index, std::uint32_t colour) {
        const Vec2 at = pixelOf(id, index);
        return colourAt(marked, int(at.x), int(at.y)) == colour;
    };
    EXPECT_TRUE(isMarked(first, {1, 2}, kBlue));
    EXPECT_TRUE(isMarked(last, {2, 1}, kVermilion));
    // Round: the pixels that a circle covers wholly are fewer than its area, and more than that of one a
    // pixel smaller.
    const double pi = std::acos(-1.0);
    EXPECT_LE(double(pixelsOf(marked, kBlue)), pi * 7 * 7);
    EXPECT_GE(double(pixelsOf(marked, kBlue)), pi * 6 * 6);
    EXPECT_LE(double(pixelsOf(marked, kVermilion)), pi * 3 * 3);
    EXPECT_GE(double(pixelsOf(marked, kVermilion)), pi * 2 * 2);
}

TEST_F(NetOverlays, MarksShowThroughSurfaces)
{
    SceneObject ball{.surface = sphere(Vec3(0), 1)};
    scene = Scene();
    const ObjectId id = scene.add(ball);
    frame = frameOf(scene, frame.path, 240, 180, "front");
    for (int i = 0; i < ball.surface.countU(); ++i) {  // all round, half of them behind
        frame.overlays.marks = {{id, {i, 4}, kBlue, 10}};
        const Vec2 at = pixelOf(id, {i, 4});
        EXPECT_EQ(colourAt(picture(), int(at.x), int(at.y)), kBlue) << i;
    }
}

TEST_F(NetOverlays, MarksTravelOnlyWhereTheyChanged)
{
    frame.overlays.marks = {{first, {1, 2}, kBlue, 14}, {last, {2, 1}, kVermilion, 6}};
    (void)picture();
    EXPECT_EQ(renderer->draw(frame)->uploadBytesPerFrame, 0U);
    frame.overlays.marks[0].colour = kHoverColour;
    EXPECT_EQ(renderer->draw(frame)->uploadBytesPerFrame, 2U * 16U);
    // They go with their control points, of which the device knows.
    const SharedObject before = scene.find(first);
    scene.exchange(
        first,
        withControlPointAt(*before, {1, 2}, controlPointInModel(*before, {1, 2}) + Vec3(0, 0, 0.4)).value());
    const Drawn moved = drawn(*renderer, scene, frame);
    EXPECT_EQ(moved.stats.uploadBytesPerFrame, 16U);
    const Vec2 at = pixelOf(first, {1, 2});
    EXPECT_EQ(colourAt(moved.picture, int(at.x), int(at.y)), kHoverColour);
    frame.overlays.marks.clear();
    EXPECT_EQ(drawn(*renderer, scene, frame).stats.uploadBytesPerFrame, 0U);
}

TEST_F(NetOverlays, NetsShowTheirPointsAndTheirHullsAsAsked)
{
    const Picture bare = picture();
    frame.overlays.controlNets = true;
    const Picture whole = picture();
    frame.overlays.hulls = false;
    const Picture points = picture();
    frame.overlays.hulls = true;
    frame.overlays.points = false;
    const Picture hulls = picture();
    frame.overlays.hulls = false;
    EXPECT_EQ(bare.rgba, picture().rgba);
    EXPECT_GT(pixelsOf(points, kPointColour), 200U);
    EXPECT_EQ(pixelsOf(hulls, kPointColour), 0U);
    EXPECT_GT(changedPixels(bare, hulls), 500U);
    EXPECT_GT(changedPixels(whole, points), 500U);
    EXPECT_GT(changedPixels(whole, hulls), 500U);
    for (const ControlPointIndex index : {ControlPointIndex{0, 0}, {1, 1}, {3, 3}}) {
        const Vec2 at = pixelOf(first, index);
        EXPECT_NE(colourAt(points, int(at.x), int(at.y)), colourAt(bare, int(at.x), int(at.y)));
    }
}

TEST_F(NetOverlays, ControlPointsArePickedWhereTheyShow)
{
    frame.overlays.netsOf = {first};
    frame.overlays.hulls = false;
    (void)picture();
    const Vec2 at = pixelOf(first, {1, 2});
    const auto pick = renderer->pick(at.x + 3, at.y - 4);
    ASSERT_TRUE(pick && pick->controlPoint);
    EXPECT_EQ(pick->controlPoint->index, (ControlPointIndex{1, 2}));
    EXPECT_NEAR(pick->distancePx, 5, 1e-9);
    frame.overlays.hulls = true;
    frame.overlays.points = false;
    (void)picture();
    EXPECT_FALSE(renderer->pick(at.x, at.y)->controlPoint);
    EXPECT_TRUE(renderer->pick(middleOf(first).x, middleOf(first).y)->place);
}

TEST_F(NetOverlays, LockedObjectsHaveNoNetsButStillMarksAndPlaces)
{
    const Picture bare = picture();
    frame.overlays.controlNets = true;
    const Picture all = picture();
    lock(first);
    const Picture others = picture();
    EXPECT_NE(all.rgba, others.rgba);
    EXPECT_NE(bare.rgba, others.rgba);
    const Vec2 inside = pixelOf(first, {1, 1});
    const Vec2 other = pixelOf(last, {1, 1});
    EXPECT_EQ(colourAt(bare, int(inside.x), int(inside.y)), colourAt(others, int(inside.x), int(inside.y)));
    EXPECT_EQ(colourAt(all, int(other.x), int(other.y)), colourAt(others, int(other.x), int(other.y)));
    EXPECT_FALSE(renderer->pick(inside.x, inside.y, 3)->controlPoint);
    EXPECT_EQ(renderer->pick(middleOf(first).x, middleOf(first).y)->object(), first);
    EXPECT_TRUE(renderer->pick(other.x, other.y, 3)->controlPoint);

    frame.overlays.controlNets = false;
    frame.overlays.netsOf = {first};
    EXPECT_EQ(bare.rgba, picture().rgba);
    EXPECT_FALSE(renderer->pick(inside.x, inside.y, 3)->controlPoint);
    frame.overlays.marks = {{first, {1, 1}, kBlue}};
    EXPECT_GT(pixelsOf(picture(), kBlue), 20U);
}

TEST_F(NetOverlays, TheHoveredObjectHasHalfTheTintOfAHighlightedOne)
{
    const Picture bare = picture();
    frame.overlays.highlighted = {first};
    const Picture highlighted = picture();
    frame.overlays.hovered = first;
    EXPECT_EQ(highlighted.rgba, picture().rgba);
    frame.overlays.highlighted.clear();
    const Picture hovered = picture();
    EXPECT_EQ(changedPixels(bare, hovered), changedPixels(bare, highlighted));
    const Vec2 at = middleOf(first);
    const auto red = [&](const Picture& from) { return colourAt(from, int(at.x), int(at.y)) >> 16U; };
    const auto blue = [&](const Picture& from) { return colourAt(from, int(at.x), int(at.y)) & 255U; };
    EXPECT_LT(red(bare), red(hovered));
    EXPECT_LT(red(hovered), red(highlighted));
    EXPECT_GT(blue(bare), blue(hovered));
    EXPECT_GT(blue(hovered), blue(highlighted));
    const Vec2 other = middleOf(last);
    EXPECT_EQ(colourAt(bare, int(other.x), int(other.y)), colourAt(hovered, int(other.x), int(other.y)));
    frame.overlays.hovered = ObjectId(999);
    EXPECT_EQ(bare.rgba, picture().rgba);
}

}  // namespace
}  // namespace knotspan::testing
