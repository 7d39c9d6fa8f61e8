// Brushes and weights by the hand: what they change is what the pure functions say, in one step.
#include <cmath>

#include <QDoubleSpinBox>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/sculpting/best_plane.h"
#include "model/sculpting/brushes.h"
#include "model/sculpting/net_directions.h"
#include "model/sculpting/weights.h"
#include "tests/ui/one_surface_test.h"
#include "ui/panels/tool_panel.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

// The sum of squared distances from the plane that fits best.
double unevenness(const std::vector<Vec3>& points)
{
    const BestPlane plane = bestPlaneOf(points, std::vector<double>(points.size(), 1.0));
    double sum = 0;
    for (const Vec3& point : points)
        sum += std::pow(glm::dot(point - plane.point, plane.normal), 2);
    return sum;
}

class BrushToolTest : public OneSurfaceTest {
protected:
    [[nodiscard]] Vec2 middle()
    {
        const PictureSize size = window->viewport().pictureSize();
        return {size.width * 0.5, size.height * 0.5};
    }
    [[nodiscard]] Vec3 under(const Vec2& pixel)
    {
        settle(*window);
        const Result<Pick> pick = window->viewport().renderer()->pick(pixel.x, pixel.y);
        EXPECT_TRUE(pick && pick->place);
        return pick && pick->place ? pick->place->position : Vec3(0);
    }
    [[nodiscard]] double radiusAt(const Vec3& place)
    {
        const Viewport& viewport = window->viewport();
        return viewport.toolSettings().brush.radiusPx *
               viewport.frame().camera.unitsPerPixel(place, viewport.pictureSize().height);
    }
    void undoAll()
    {
        while (window->document().canUndo())
            window->document().undo();
        EXPECT_TRUE(scene() == start);
        EXPECT_FALSE(window->document().isModified());
    }
    // A control point in the middle of the picture, pulled towards the eye; by the document, as one step.
    ControlPointIndex withPointMoved()
    {
        const NurbsSurface& surface = scene().find(id)->surface;
        const ControlPointIndex index{surface.countU() / 2, surface.countV() / 2};
        const Vec3 up = -window->viewport().frame().camera.forward() * 0.1 * surface.bounds().diagonal();
        const auto drag = PointDrag::begin(scene(), pointOf(scene(), {id, index}), {});
        const auto edit = drag->moved(up);
        EXPECT_TRUE(edit);
        window->document().apply(*edit, "Spike");
        settle(*window);
        return index;
    }
    // Towards the eye.
    [[nodiscard]] double heightOf(ControlPointIndex index)
    {
        const Vec3 by =
            controlPointInModel(*scene().find(id), index) - controlPointInModel(*start.find(id), index);
        return -glm::dot(by, window->viewport().frame().camera.forward());
    }
    // Of the surface where the control point weighs most.
    [[nodiscard]] Vec2 pixelOf(ControlPointIndex index)
    {
        const NurbsSurface& surface = scene().find(id)->surface;
        const PictureSize size = window->viewport().pictureSize();
        const auto at = window->viewport().frame().camera.toPixel(
            evaluate(surface, grevilleParameter(surface.knotsU(), index.i),
                     grevilleParameter(surface.knotsV(), index.j))
                .position,
            size.width, size.height);
        EXPECT_TRUE(at);
        return at.value_or(Vec2(0));
    }
    // Changed control points are those within the radius of the place, and some are.
    void expectOnlyNear(const Vec3& place, double radius)
    {
        const auto all = moves();
        const auto& before = start.find(id)->surface.controlPoints();
        for (size_t k = 0; k < all.size(); ++k)
            if (all[k] != Vec3(0)) {
                EXPECT_LE(glm::distance(before[k].position, place), radius * 1.01);
            }
        EXPECT_GT(countOf(all), 0U);
    }
};

TEST_F(BrushToolTest, GrabTakesThePointsInTheCircleAlongWithTheHand)
{
    act("tools.grab");
    const Vec3 place = under(middle());
    const double radius = radiusAt(place);
    Hand hand(*window);
    const Vec2 way(30, -25);
    hand.drag(middle(), middle() + way);
    const Camera& camera = window->viewport().frame().camera;
    const double unit = camera.unitsPerPixel(place, window->viewport().pictureSize().height);
    const Vec3 by = (camera.right() * way.x - camera.upward() * way.y) * unit;
    const auto expected = dabbed(start.find(id), BrushKind::grab,
                                 {.centre = place, .radius = radius, .strength = 1, .by = by, .mirror = {}});
    ASSERT_TRUE(expected);
    EXPECT_TRUE(scene().find(id)->surface == (*expected)->surface);
    expectOnlyNear(place, radius);
    EXPECT_EQ(steps(), 1);
    EXPECT_EQ(window->document().undoText(), "Grab");
    undoAll();
}

TEST_F(BrushToolTest, GrabbedAndBroughtBackIsAsItWas)
{
    act("tools.grab");
    Hand hand(*window);
    hand.press(middle());
    hand.move(middle() + Vec2(40, 10));
    EXPECT_FALSE(scene() == start);
    hand.move(middle());
    EXPECT_TRUE(scene() == start);
    hand.move(middle() + Vec2(10, 10));
    hand.key(Qt::Key_Escape);
    hand.release();
    EXPECT_TRUE(scene() == start);
    EXPECT_EQ(steps(), 0);
}

TEST_F(BrushToolTest, InflateRaisesControlLowersAndSmoothEvensOut)
{
    act("tools.inflate");
    const Vec3 place = under(middle());
    Hand hand(*window);
    hand.drag(middle(), middle() + Vec2(4, 0));
    expectOnlyNear(place, radiusAt(place));
    const Vec3 normal = [&] {
        const NurbsSurface& surface = start.find(id)->surface;
        const SurfacePoint at = evaluate(surface, 0.5, 0.5);
        return glm::normalize(glm::cross(at.du, at.dv));
    }();
    const auto raised = moves();
    double most = 0;
    for (const Vec3& by : raised)
        most = std::max(most, glm::dot(by, normal));
    EXPECT_GT(most, 0);
    EXPECT_EQ(steps(), 1);
    undoAll();
    settle(*window);
    hand.drag(middle(), middle() + Vec2(4, 0), Qt::LeftButton, Qt::ControlModifier);
    const auto lowered = moves();
    for (size_t k = 0; k < raised.size(); ++k)
        EXPECT_LE(glm::length(raised[k] + lowered[k]), 1e-9);
    undoAll();

    // A spike is worn down by smoothing, with the smooth brush and with Shift.
    const auto spiked = withPointMoved();
    for (const bool byShift : {false, true}) {
        act(byShift ? "tools.flatten" : "tools.smooth");
        settle(*window);
        const double before = heightOf(spiked);
        hand.press(pixelOf(spiked), Qt::LeftButton, byShift ? Qt::ShiftModifier : Qt::NoModifier);
        hand.release();
        EXPECT_LT(heightOf(spiked), before);
        EXPECT_EQ(window->document().undoText(), "Smooth");
    }
}

TEST_F(BrushToolTest, FlattenBringsPointsToAPlaneAndTheCircleShows)
{
    const auto spiked = withPointMoved();
    act("tools.flatten");
    Hand hand(*window);
    hand.hover(pixelOf(spiked));
    settle(*window);
    const QImage withCircle = picture(*window);
    act("tools.select");
    settle(*window);
    EXPECT_GT(differingPixels(withCircle, picture(*window)), 100);
    act("tools.flatten");
    const SharedObject before = scene().find(id);
    hand.click(pixelOf(spiked));
    EXPECT_EQ(steps(), 2);
    EXPECT_EQ(window->document().undoText(), "Flatten");
    // What has moved is nearer to a plane than it was.
    std::vector<Vec3> was;
    std::vector<Vec3> is;
    for (size_t k = 0; k < before->surface.controlPoints().size(); ++k) {
        const Vec3 from = before->surface.controlPoints()[k].position;
        const Vec3 to = scene().find(id)->surface.controlPoints()[k].position;
        if (from != to) {
            was.push_back(from);
            is.push_back(to);
        }
    }
    ASSERT_GT(was.size(), 3U);
    EXPECT_LT(unevenness(is), unevenness(was));
}

TEST_F(BrushToolTest, BesideTheModelABrushTurnsTheViewAndLeavesIt)
{
    act("tools.inflate");
    const Vec3 eye = window->viewport().frame().camera.eye;
    Hand hand(*window);
    hand.drag({4, 4}, {60, 40});
    EXPECT_TRUE(window->viewport().frame().camera.eye != eye);
    EXPECT_TRUE(scene() == start);
}

TEST_F(BrushToolTest, KeysAndThePanelSizeTheBrush)
{
    const double before = window->viewport().toolSettings().brush.radiusPx;
    act("tools.largerBrush");
    auto* radius = window->findChild<ToolPanel*>()->findChild<QDoubleSpinBox*>("brush-radius");
    EXPECT_NEAR(window->viewport().toolSettings().brush.radiusPx, 1.2 * before, 1e-9);
    EXPECT_NEAR(radius->value(), 1.2 * before, 0.51);
    for (int k = 0; k < 50; ++k)
        act("tools.smallerBrush");
    EXPECT_EQ(window->viewport().toolSettings().brush.radiusPx, kLeastBrushPx);
    radius->setValue(33);
    EXPECT_EQ(window->viewport().toolSettings().brush.radiusPx, 33);
}

TEST_F(BrushToolTest, WeightsFollowTheHandUpAndDownAndStopAtTheirBounds)
{
    act("tools.weight");
    const VisiblePoint at = point();
    settle(*window);
    const auto weight = [&] { return scene().find(id)->surface.controlPoint(at.index.i, at.index.j).weight; };
    const double before = weight();
    Hand hand(*window);
    hand.drag(at.pixel, at.pixel - Vec2(0, 50));
    EXPECT_NEAR(weight(), before * std::exp(0.5), 1e-9);
    EXPECT_EQ(countOf(moves()), 0U);
    EXPECT_EQ(steps(), 1);
    settle(*window);
    hand.drag(at.pixel, at.pixel + Vec2(0, 50), Qt::LeftButton, Qt::ShiftModifier);
    hand.press(at.pixel);
    for (int k = 1; k < 8; ++k)
        hand.move(at.pixel - Vec2(0, 400 * k));
    EXPECT_LE(weight(), kMostWeight);
    EXPECT_GE(weight(), 0.999 * kMostWeight);
    hand.release();
    undoAll();
    hand.press(at.pixel);
    hand.move(at.pixel - Vec2(0, 30));
    EXPECT_FALSE(scene() == start);
    hand.move(at.pixel);
    EXPECT_TRUE(scene() == start);
    hand.key(Qt::Key_Escape);
    hand.release();
    EXPECT_TRUE(scene() == start);
}

}  // namespace
}  // namespace knotspan
