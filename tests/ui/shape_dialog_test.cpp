// Add a shape, driven through its boxes and buttons: the document, one undo step, the preview.
#include <algorithm>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "tests/ui/making_harness.h"
#include "ui/shape_dialog.h"

namespace knotspan::testing {

namespace {

// The largest difference from `distance` of the surface's places, measured from `centre`.
double unroundness(const SceneObject& object, const Vec3& centre, double distance)
{
    const NurbsSurface& surface = object.surface;
    double worst = 0;
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 20; ++j) {
            const auto at = [](const KnotVector& knots, int k) {
                return knots.domainStart() + (knots.domainEnd() - knots.domainStart()) * k / 20;
            };
            const Vec3 point =
                transformed(evaluate(surface, at(surface.knotsU(), i), at(surface.knotsV(), j)).position,
                            object.transform);
            worst = std::max(worst, std::abs(glm::distance(point, centre) - distance));
        }
    return worst;
}

double difference(const Vec3& a, const Vec3& b)
{
    return glm::distance(a, b);
}

}  // namespace

TEST(ShapeDialog, AddsEachShapeAsOneStepThatIsSelectedAndThatUndoTakesBackToTheBit)
{
    MakingWindow opened("single-100");
    opened.bringUp<ShapeDialog>("object.add");
    const std::pair<const char*, const char*> shapes[] = {{"Plane 1", "Add a plane"},
                                                          {"Cylinder 1", "Add a cylinder"},
                                                          {"Cone 1", "Add a cone"},
                                                          {"Sphere 1", "Add a sphere"},
                                                          {"Torus 1", "Add a torus"}};
    int index = 0;
    for (const auto& [name, step] : shapes) {
        opened.choose("shape", (index + 1) % 5);  // so that each choice is a change
        opened.choose("shape", index++);
        opened.expectOneStep(step);
        ASSERT_EQ(opened.window.selection().objects().size(), 1U);
        const SharedObject added = opened.scene().find(*opened.window.selection().objects().begin());
        ASSERT_NE(added, nullptr);
        EXPECT_EQ(added->name, name);
        EXPECT_GT(added->bounds().diagonal(), opened.start.bounds().diagonal() / 20);
        EXPECT_LT(added->bounds().diagonal(), opened.start.bounds().diagonal() * 2);
        opened.expectUndone();
    }
}

TEST(ShapeDialog, MakesTheNumbersThatAreTypedIntoAnEmptyDocument)
{
    MakingWindow opened("");
    ASSERT_TRUE(opened.start.objects().empty());
    opened.bringUp<ShapeDialog>("object.add");
    EXPECT_EQ(opened.the<QDoubleSpinBox>("radius").value(), 1);
    opened.choose("shape", static_cast<int>(ShapeKind::sphere));
    opened.type("radius", 2.5);
    opened.type("centre-x", -4);
    opened.type("centre-z", 7.25);
    opened.choose("axis", 0);
    opened.click("apply");
    opened.click("apply");
    ASSERT_EQ(opened.scene().objects().size(), 2U);
    EXPECT_EQ(opened.steps(), 2);
    const SceneObject& first = *opened.scene().objects().begin()->second;
    EXPECT_EQ(first.name, "Sphere 1");
    EXPECT_EQ(opened.scene().objects().rbegin()->second->name, "Sphere 2");
    EXPECT_LT(unroundness(first, {-4, 0, 7.25}, 2.5), 1e-13);
}

// The base of the cone stands at the place typed, and its axis where the choice says.
TEST(ShapeDialog, StandsTheShapeAlongTheAxisChosen)
{
    for (int axis = 0; axis < 3; ++axis) {
        MakingWindow opened("");
        opened.bringUp<ShapeDialog>("object.add");
        opened.choose("shape", static_cast<int>(ShapeKind::cylinder));
        opened.choose("axis", axis);
        opened.type("radius", 2);
        opened.type("height", 10);
        opened.click("apply");
        ASSERT_EQ(opened.scene().objects().size(), 1U);
        const Box bounds = opened.scene().objects().begin()->second->bounds();
        Vec3 low(-2);
        Vec3 high(2);
        low[axis] = 0;
        high[axis] = 10;
        EXPECT_LT(difference(bounds.low, low), 1e-13) << axis;
        EXPECT_LT(difference(bounds.high, high), 1e-13) << axis;
    }
}

// The preview comes up between the keys, and leaves what is half typed alone.
TEST(ShapeDialog, TakesANumberThatIsTypedSlowly)
{
    MakingWindow opened("");
    opened.bringUp<ShapeDialog>("object.add");
    auto& box = opened.the<QDoubleSpinBox>("radius");
    box.setFocus();
    box.selectAll();
    for (const QChar key : box.locale().toString(12.25, 'f', 2)) {
        QTest::keyClicks(&box, QString(key));
        opened.wait();
    }
    EXPECT_EQ(box.value(), 12.25);
    opened.click("apply");
    ASSERT_EQ(opened.scene().objects().size(), 1U);
    EXPECT_LT(unroundness(*opened.scene().objects().begin()->second, Vec3(0), 12.25), 1e-13);
}

TEST(ShapeDialog, SaysWhatIsWrongWithANumberAndAddsNothing)
{
    MakingWindow opened("single-100");
    opened.bringUp<ShapeDialog>("object.add");
    opened.choose("shape", static_cast<int>(ShapeKind::sphere));
    opened.type("radius", 0);
    opened.expectNothing("The radius");
    opened.type("radius", -3);
    opened.expectNothing("The radius");
    opened.choose("shape", static_cast<int>(ShapeKind::torus));
    opened.type("radius", 1);
    opened.type("tube", 2);
    opened.expectNothing("no hole is left");
    opened.type("tube", 0.5);
    EXPECT_TRUE(opened.canApply());
    EXPECT_TRUE(opened.dialog->isPreviewing());
    opened.click("close");
    EXPECT_TRUE(opened.scene() == opened.start);
    EXPECT_EQ(opened.steps(), 0);
}

}  // namespace knotspan::testing
