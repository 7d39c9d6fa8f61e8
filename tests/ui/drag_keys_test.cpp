// Keys during a drag: axes, and numbers typed in place of what the hand does.
#include "tests/ui/gizmo_harness.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class DragKeys : public GizmoTest {
protected:
    [[nodiscard]] Vec3 was() { return placeOf(start, point()); }
    [[nodiscard]] Vec3 is() { return placeOf(scene(), point()); }
    [[nodiscard]] Vec3 moved() { return is() - was(); }
    [[nodiscard]] ScenePoint point() const { return {id, {3, 4}}; }
    Vec2 press(Hand& hand)
    {
        const Vec2 pixel = pixelOf(was());
        hand.press(pixel);
        return pixel;
    }
};

TEST_F(DragKeys, ChooseAnAxisAndTheSameAgainNone)
{
    Hand hand(*window);
    const Vec2 pixel = press(hand);
    hand.move(pixel + Vec2(20, -30));
    const Vec3 free = moved();
    key(Qt::Key_Z, "z");
    EXPECT_TRUE(hint().startsWith("Along Z")) << hint().toStdString();
    EXPECT_EQ(moved().x, 0);
    EXPECT_EQ(moved().y, 0);
    EXPECT_NE(moved().z, 0);
    key(Qt::Key_X, "x");
    EXPECT_EQ(moved().z, 0);
    EXPECT_NE(moved().x, 0);
    for (const auto& [code, axis] : {std::pair(Qt::Key_U, DragAxis::u), std::pair(Qt::Key_V, DragAxis::v),
                                     std::pair(Qt::Key_N, DragAxis::normal)}) {
        key(code);
        DragSettings settings;
        settings.axis = axis;
        const Vec3 direction = PointDrag::begin(start, pointOf(start, point()), settings)->direction();
        EXPECT_NEAR(glm::length(glm::cross(moved(), direction)), 0, 1e-9);
        EXPECT_GT(glm::length(moved()), 0);
    }
    key(Qt::Key_N);
    EXPECT_EQ(moved(), free);
    hand.release();
    expectOneStep("Move control point");
}

TEST_F(DragKeys, NumbersMoveExactlyAndTheHandDoesNotCountMeanwhile)
{
    Hand hand(*window);
    const Vec2 pixel = press(hand);
    hand.move(pixel + Vec2(20, -30));
    key(Qt::Key_Z);
    type("2.5");
    const QString units = QString::fromStdString(scene().units());
    EXPECT_EQ(hint(), "Along Z: 2.5 " + units + " - Enter to take it, Escape to leave it");
    EXPECT_EQ(is(), was() + Vec3(0, 0, 2.5));
    hand.move(pixel + Vec2(60, 50));
    EXPECT_EQ(is(), was() + Vec3(0, 0, 2.5));
    key(Qt::Key_Return, "\r");
    EXPECT_EQ(is(), was() + Vec3(0, 0, 2.5));
    hand.move(pixel + Vec2(90, 50));  // still down, and no longer drags
    hand.release();
    EXPECT_EQ(is(), was() + Vec3(0, 0, 2.5));
    EXPECT_EQ(hint(), "");
    expectOneStep("Move control point");
}

TEST_F(DragKeys, NumbersNeedNoMovementOfTheHand)
{
    Hand hand(*window);
    press(hand);
    type("0.5 0 -0.25");
    EXPECT_EQ(is(), was() + Vec3(0.5, 0, -0.25));
    hand.release();  // takes it as Enter does
    expectOneStep("Move control point");

    press(hand);
    type("=4 5 6");
    EXPECT_NEAR(glm::distance(is(), Vec3(4, 5, 6)), 0, 1e-14);
    for (int k = 0; k < 4; ++k)
        key(Qt::Key_Backspace);
    EXPECT_NEAR(glm::distance(is(), Vec3(4, was().y, was().z)), 0, 1e-14);
    key(Qt::Key_Y);
    EXPECT_NEAR(glm::distance(is(), Vec3(was().x, 4, was().z)), 0, 1e-14);
    key(Qt::Key_Return);
    hand.release();
    EXPECT_EQ(steps(), 1);
    window->document().undo();
    EXPECT_TRUE(scene() == start);
}

TEST_F(DragKeys, NonsenseIsRefusedInASentenceAndNeverApplied)
{
    Hand hand(*window);
    press(hand);
    type("2");
    type("-");
    EXPECT_TRUE(hint().contains("no number")) << hint().toStdString();
    EXPECT_EQ(is(), was() + Vec3(2, 0, 0));
    key(Qt::Key_Return);  // is not taken
    EXPECT_EQ(steps(), 0);
    key(Qt::Key_Backspace);
    EXPECT_TRUE(hint().contains("Enter to take it"));
    key(Qt::Key_N);
    type(" 5");
    EXPECT_TRUE(hint().contains("One number")) << hint().toStdString();
    hand.release();
    EXPECT_TRUE(window->message().contains("One number"));
    expectNoTrace();

    press(hand);
    key(Qt::Key_U);
    type("=3");
    EXPECT_TRUE(hint().contains("X, Y or Z")) << hint().toStdString();
    key(Qt::Key_Escape);
    hand.release();
    expectNoTrace();
}

TEST_F(DragKeys, BackspaceGivesTheHandItsWayBack)
{
    Hand hand(*window);
    const Vec2 pixel = press(hand);
    hand.move(pixel + Vec2(20, -30));
    const Vec3 byHand = moved();
    type("7");
    EXPECT_EQ(is(), was() + Vec3(7, 0, 0));
    key(Qt::Key_Backspace);
    EXPECT_EQ(moved(), byHand);
    hand.move(pixel);
    EXPECT_EQ(is(), was());
    key(Qt::Key_Escape);
    hand.release();
    expectNoTrace();
}

TEST_F(DragKeys, NumbersTurnAndScaleObjectsByTheirHandles)
{
    Hand hand(*window);
    const Vec3 centre = placed().centre;
    hand.press(grip(HandleKind::turn, DragAxis::x));
    key(Qt::Key_Z);
    type("90");
    EXPECT_TRUE(hint().startsWith("About Z: 90")) << hint().toStdString();
    const Vec3 rest = was() - centre;
    EXPECT_NEAR(glm::distance(is(), centre + Vec3(-rest.y, rest.x, rest.z)), 0, 1e-12);
    key(Qt::Key_Return);
    hand.release();
    expectOneStep("Turn object");
    window->document().undoStack().clear();

    hand.press(grip(HandleKind::scale, DragAxis::x));
    type("2");
    EXPECT_NEAR(glm::distance(is(), was() + Vec3(rest.x, 0, 0)), 0, 1e-12);
    type("-");
    key(Qt::Key_Backspace);
    key(Qt::Key_Backspace);
    type("0");  // flat
    EXPECT_FALSE(hint().contains("Enter to take it")) << hint().toStdString();
    key(Qt::Key_Escape);
    hand.release();
    expectNoTrace();

    hand.press(grip(HandleKind::move, DragAxis::y));
    type("=12");
    EXPECT_NEAR(glm::distance(placed().centre, Vec3(centre.x, 12, centre.z)), 0, 1e-12);
    key(Qt::Key_Y);
    key(Qt::Key_Backspace);
    key(Qt::Key_Backspace);
    key(Qt::Key_Backspace);
    type("1 2 3");
    EXPECT_NEAR(glm::distance(is(), was() + Vec3(1, 2, 3)), 0, 1e-12);
    key(Qt::Key_Enter);
    hand.release();
    expectOneStep("Move object");
}

}  // namespace
}  // namespace knotspan
