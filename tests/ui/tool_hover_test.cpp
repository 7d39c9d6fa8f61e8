// What lights up under the pointer, and what clicks take, with the gizmo and with filters.
#include "model/samples/sample_list.h"
#include "tests/ui/gizmo_harness.h"
#include "ui/tools/reach.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

using ToolHover = GizmoTest;

TEST_F(ToolHover, AHandleUnderThePointerLightsUpAndNothingElse)
{
    const auto litStrokes = [&] {
        settle(*window);
        return picture(*window);
    };
    Hand hand(*window);
    hand.move(Vec2(3, 3));
    const QImage plain = litStrokes();
    const Vec2 at = grip(HandleKind::move, DragAxis::z);
    hand.move(at);
    EXPECT_GT(differingPixels(litStrokes(), plain), 20);
    EXPECT_FALSE(window->selection().hovered().has_value());
    EXPECT_FALSE(window->selection().hoveredObject().has_value());
    hand.move(Vec2(3, 3));
    EXPECT_EQ(differingPixels(litStrokes(), plain), 0);
}

TEST_F(ToolHover, TheFilterLeavesOutPointsOrObjects)
{
    tell([](ToolSettings& settings) {
        settings.filter.points = false;
        settings.gizmo = GizmoFrame::none;
    });
    const Vec2 pixel = pixelOf(placeOf(start, {id, {3, 4}}));
    Hand hand(*window);
    hand.move(pixel);
    EXPECT_FALSE(window->selection().hovered().has_value());
    hand.click(pixel);
    EXPECT_TRUE(window->selection().points().isEmpty());
    tell([](ToolSettings& settings) { settings.filter = {true, false}; });
    window->selection().setObjects({});
    settle(*window);
    hand.click(pixel);
    EXPECT_TRUE(window->selection().objects().empty());
    expectNoTrace();
}

TEST_F(ToolHover, WhoWouldFollowShowsWhileHovering)
{
    tell([](ToolSettings& settings) {
        settings.drag.falloff = {2, FalloffShape::linear, FalloffDistance::netSteps};
    });
    Hand hand(*window);
    hand.move(Vec2(3, 3));
    settle(*window);
    const QImage plain = picture(*window);
    hand.move(pixelOf(placeOf(start, {id, {3, 4}})));
    settle(*window);
    ASSERT_TRUE(window->selection().hovered().has_value());
    // Around the four neighbours, too.
    for (const ControlPointIndex index : {ControlPointIndex{2, 4}, {4, 4}, {3, 3}, {3, 5}}) {
        const Vec2 at = pixelOf(placeOf(start, {id, index}));
        const QRect around(int(at.x) - 4, int(at.y) - 4, 8, 8);
        EXPECT_GT(differingPixels(picture(*window).copy(around), plain.copy(around)), 3);
    }
    hand.move(Vec2(3, 3));
    settle(*window);
    EXPECT_EQ(differingPixels(picture(*window), plain), 0);
}

TEST(Reach, MarksRunFromSmallAndBlueToLargeAndOrangeAndAreNeverTooMany)
{
    const ObjectId object{3};
    const PointSelection leader(object, {200, 200}, {{0, 0}});
    Followers followers;
    followers[object] = {{{0, 0}, 1}, {{0, 1}, 1}, {{0, 2}, 0.5}, {{0, 3}, 1e-9}};
    const auto marks = marksOf(followers, leader);
    ASSERT_EQ(marks.size(), 3U);
    EXPECT_EQ(marks[0].colour, kSelectedColour);
    EXPECT_EQ(marks[2].colour, 0x3b6fd4U);
    EXPECT_GT(marks[0].sizePx, marks[1].sizePx);
    EXPECT_GT(marks[1].sizePx, marks[2].sizePx);

    followers[object].clear();
    for (int i = 0; i < 200; ++i)
        for (int j = 0; j < 200; ++j)
            followers[object].push_back({{i, j}, 0.5});
    const auto many = marksOf(followers, leader);
    EXPECT_LE(many.size(), 5000U);
    EXPECT_GT(many.size(), 4000U);
    EXPECT_GE(many.back().index.i, 198);  // of all parts of the net
}

TEST(Reach, HiddenAndLockedObjectsNeverFollow)
{
    Scene scene = findSample("nine-16")->make();
    const ObjectId hidden = scene.objects().begin()->first;
    const ObjectId locked = scene.objects().rbegin()->first;
    auto one = *scene.find(hidden);
    one.visible = false;
    scene.exchange(hidden, std::make_shared<SceneObject>(one));
    auto other = *scene.find(locked);
    other.locked = true;
    scene.exchange(locked, std::make_shared<SceneObject>(other));
    DragSettings settings;
    EXPECT_TRUE(mayFollow(scene, settings).empty());
    settings.falloff.radius = 1;
    const auto objects = mayFollow(scene, settings);
    EXPECT_EQ(objects.size(), scene.objects().size() - 2);
    EXPECT_EQ(objects.count(hidden) + objects.count(locked), 0U);
}

}  // namespace
}  // namespace knotspan
