// Surface from curves, driven through its boxes and buttons: the document, one undo step, the preview.
#include <algorithm>

#include <QCheckBox>

#include <glm/geometric.hpp>

#include "model/making/object_making.h"
#include "tests/ui/making_harness.h"
#include "ui/curves_dialog.h"

namespace knotspan::testing {

namespace {

const SceneObject& made(MakingWindow& opened)
{
    return *opened.scene().find(*opened.window.selection().objects().begin());
}

// The largest distance between two curves, place for place of their domains.
double distanceBetween(const NurbsCurve& a, const NurbsCurve& b)
{
    const auto at = [](const NurbsCurve& curve, int k) {
        const double start = curve.knots().domainStart();
        return evaluate(curve, start + (curve.knots().domainEnd() - start) * k / 50);
    };
    double worst = 0;
    for (int k = 0; k <= 50; ++k)
        worst = std::max(worst, glm::distance(at(a, k), at(b, k)));
    return worst;
}

NurbsCurve isoCurveOf(const SceneObject& object, Direction across, double part)
{
    const KnotVector& knots = across == Direction::U ? object.surface.knotsU() : object.surface.knotsV();
    return isoCurveInModel(object, across,
                           knots.domainStart() + part * (knots.domainEnd() - knots.domainStart()))
        .value();
}

}  // namespace

TEST(CurvesDialog, ExtrudesTheBorderOfTheSelectedSurfaceAlongTheVectorTyped)
{
    MakingWindow opened("single-100");
    opened.select(1);
    const SceneObject source = *opened.start.objects().begin()->second;
    const double size = source.bounds().diagonal();
    opened.bringUp<CurvesDialog>("object.curves");
    opened.type("vector-x", 1.5);
    opened.type("vector-z", 4);
    opened.expectOneStep("Extrude curves");
    const SceneObject extrusion = made(opened);
    EXPECT_EQ(extrusion.name, "Extrusion 1");
    const NurbsCurve border = isoCurveOf(source, Direction::V, 0);
    EXPECT_LT(distanceBetween(isoCurveOf(extrusion, Direction::V, 0), border), 1e-12 * size);
    const NurbsCurve far = transformed(border, transformMatrix({.translation = {1.5, 0, 4}}).value()).value();
    EXPECT_LT(distanceBetween(isoCurveOf(extrusion, Direction::V, 1), far), 1e-12 * size);
    opened.expectUndone();
}

TEST(CurvesDialog, RevolvesACurveFromWithinTheSurface)
{
    MakingWindow opened("single-100");
    opened.select(1);
    const SceneObject source = *opened.start.objects().begin()->second;
    const double size = source.bounds().diagonal();
    opened.bringUp<CurvesDialog>("object.curves");
    opened.choose("use", static_cast<int>(CurveUse::revolve));
    opened.choose("along", 1);
    opened.type("at", 0.25);
    opened.type("point-x", 2 * size);
    opened.type("degrees", 90);
    opened.expectOneStep("Revolve curves");
    const SceneObject revolution = made(opened);
    const NurbsCurve curve = isoCurveOf(source, Direction::U, 0.25);
    EXPECT_LT(distanceBetween(isoCurveOf(revolution, Direction::U, 0), curve), 1e-12 * size);
    const double through = opened.the<QDoubleSpinBox>("point-x").value();
    const Mat4 turn = transformMatrix({.degrees = {0, 0, 90}, .pivot = {through, 0, 0}}).value();
    EXPECT_LT(distanceBetween(isoCurveOf(revolution, Direction::U, 1), transformed(curve, turn).value()),
              1e-12 * size);
    opened.expectUndone();
}

TEST(CurvesDialog, LoftsThroughTheCurvesOfSeveralSurfacesAndThroughTheKnotLinesOfOne)
{
    for (const int count : {1, 3}) {
        MakingWindow opened(count == 1 ? "single-100" : "nine-16");
        opened.select(count);
        const SceneObject source = *opened.start.objects().begin()->second;
        const double size = opened.start.bounds().diagonal();
        opened.bringUp<CurvesDialog>("object.curves");
        opened.choose("use", static_cast<int>(CurveUse::loft));
        opened.expectOneStep("Loft through curves");
        EXPECT_EQ(opened.scene().objects().size(), opened.start.objects().size() + 1);
        EXPECT_LT(
            distanceBetween(isoCurveOf(made(opened), Direction::V, 0), isoCurveOf(source, Direction::V, 0)),
            1e-12 * size);
        opened.expectUndone();
    }
}

TEST(CurvesDialog, SaysWhatIsWrongAndMakesNothing)
{
    MakingWindow opened("nine-16");
    opened.select(2);
    opened.bringUp<CurvesDialog>("object.curves");
    for (const char* box : {"vector-x", "vector-y", "vector-z"})
        opened.type(box, 0);
    opened.expectNothing("vector");
    opened.choose("use", static_cast<int>(CurveUse::revolve));
    opened.type("degrees", 400);
    opened.expectNothing("360");
    opened.choose("use", static_cast<int>(CurveUse::loft));
    opened.the<QCheckBox>("closed").setChecked(true);
    opened.wait();
    opened.expectNothing("three");
}

}  // namespace knotspan::testing
