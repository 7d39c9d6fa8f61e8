#include <algorithm>
#include <array>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffset_MakeOffset.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <glm/geometric.hpp>
#include <gp_Circ.hxx>
#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "tests/model/formats/step_solids.h"

using namespace knotspan;
using knotspan::testing::SampledPoint;
using knotspan::testing::samplesOf;
using knotspan::testing::throughStep;

namespace {

// A place that is neither at the origin nor along the axes.
const gp_Ax2 kTilted(gp_Pnt(10, -20, 30), gp_Dir(1, 2, 2), gp_Dir(2, 1, -2));
const Vec3 kCentre(10, -20, 30);
const Vec3 kAxis = Vec3(1, 2, 2) / 3.0;

double radiusAroundAxis(const Vec3& point)
{
    return glm::length(glm::cross(point - kCentre, kAxis));
}

void expectDegrees(const Scene& scene, int degreeU, int degreeV)
{
    for (const auto& [id, object] : scene.objects()) {
        EXPECT_EQ(object->surface.degreeU(), degreeU);
        EXPECT_EQ(object->surface.degreeV(), degreeV);
    }
}

void expectLoopsClosedInsideTheDomain(const SceneObject& object)
{
    const KnotVector& knotsU = object.surface.knotsU();
    const KnotVector& knotsV = object.surface.knotsV();
    for (size_t k = 0; k < object.trimLoops.size(); ++k) {
        const TrimLoop& loop = object.trimLoops[k];
        EXPECT_EQ(loop.outer, k == 0);
        for (size_t c = 0; c < loop.curves.size(); ++c) {
            const TrimCurve& curve = loop.curves[c];
            const TrimCurve& next = loop.curves[(c + 1) % loop.curves.size()];
            EXPECT_EQ(curve.points().back().position, next.points().front().position);
            for (int s = 0; s <= 20; ++s) {
                const double start = curve.knots().domainStart();
                const Vec2 uv = curve.evaluate(start + (curve.knots().domainEnd() - start) * s / 20);
                EXPECT_GE(uv.x, knotsU.domainStart() - 1e-12);
                EXPECT_LE(uv.x, knotsU.domainEnd() + 1e-12);
                EXPECT_GE(uv.y, knotsV.domainStart() - 1e-12);
                EXPECT_LE(uv.y, knotsV.domainEnd() + 1e-12);
            }
        }
    }
}

// Twice the area that the loop encloses, positive if it runs anticlockwise.
double turn(const TrimLoop& loop)
{
    std::vector<Vec2> points;
    for (const TrimCurve& curve : loop.curves)
        for (int s = 0; s < 20; ++s) {
            const double start = curve.knots().domainStart();
            points.push_back(curve.evaluate(start + (curve.knots().domainEnd() - start) * s / 20));
        }
    double area = 0;
    for (size_t k = 0; k < points.size(); ++k) {
        const Vec2 a = points[k];
        const Vec2 b = points[(k + 1) % points.size()];
        area += a.x * b.y - a.y * b.x;
    }
    return area;
}

}  // namespace

TEST(StepSolids, ABoxIsSixUntrimmedPlanesThatFaceOutwards)
{
    const auto import = throughStep(BRepPrimAPI_MakeBox(kTilted, 3, 4, 5).Solid());
    ASSERT_EQ(import.scene.objects().size(), 6U);
    expectDegrees(import.scene, 1, 1);
    const Vec3 middle = import.scene.bounds().centre();
    for (const SampledPoint& sample : samplesOf(import.scene, 3))
        EXPECT_GT(glm::dot(sample.normal, sample.position - middle), 1.0);
    for (const auto& [id, object] : import.scene.objects())
        EXPECT_TRUE(object->trimLoops.empty());
    EXPECT_TRUE(import.notes.empty());
    EXPECT_EQ(import.scene.units(), "mm");
}

TEST(StepSolids, ASphereIsOneExactUntrimmedSurfaceThatFacesOutwards)
{
    const auto import = throughStep(BRepPrimAPI_MakeSphere(kTilted, 2.5).Solid());
    ASSERT_EQ(import.scene.objects().size(), 1U);
    expectDegrees(import.scene, 2, 2);
    for (const SampledPoint& sample : samplesOf(import.scene)) {
        EXPECT_NEAR(glm::length(sample.position - kCentre), 2.5, 1e-9);
        EXPECT_NEAR(glm::dot(sample.normal, sample.position - kCentre), 2.5, 1e-6);
    }
    EXPECT_TRUE(import.scene.objects().begin()->second->surface.isClosedU());
    EXPECT_TRUE(import.scene.objects().begin()->second->trimLoops.empty());
}

TEST(StepSolids, APartOfASphereIsBoundedToThatPart)
{
    const auto import = throughStep(BRepPrimAPI_MakeSphere(kTilted, 2.0, -0.5, 0.75, 1.25).Shell());
    bool found = false;
    for (const auto& [id, object] : import.scene.objects()) {
        if (object->surface.degreeU() != 2 || object->surface.degreeV() != 2)
            continue;
        found = true;
        EXPECT_NEAR(object->surface.knotsU().domainEnd() - object->surface.knotsU().domainStart(), 1.25,
                    1e-6);
        EXPECT_TRUE(object->trimLoops.empty());
    }
    EXPECT_TRUE(found);
}

TEST(StepSolids, ATorusIsOneExactUntrimmedSurface)
{
    const auto import = throughStep(BRepPrimAPI_MakeTorus(kTilted, 5, 1.5).Solid());
    ASSERT_EQ(import.scene.objects().size(), 1U);
    expectDegrees(import.scene, 2, 2);
    for (const SampledPoint& sample : samplesOf(import.scene)) {
        const double height = glm::dot(sample.position - kCentre, kAxis);
        EXPECT_NEAR(std::hypot(radiusAroundAxis(sample.position) - 5, height), 1.5, 1e-9);
    }
    EXPECT_TRUE(import.scene.objects().begin()->second->trimLoops.empty());
}

TEST(StepSolids, ACylinderHasOneRoundFaceAndTwoPlanesTrimmedByCircles)
{
    const auto import = throughStep(BRepPrimAPI_MakeCylinder(kTilted, 2, 7).Solid());
    ASSERT_EQ(import.scene.objects().size(), 3U);
    int caps = 0;
    for (const auto& [id, object] : import.scene.objects()) {
        expectLoopsClosedInsideTheDomain(*object);
        if (object->surface.degreeU() == 2) {
            EXPECT_TRUE(object->trimLoops.empty());
            for (int k = 0; k <= 30; ++k)
                EXPECT_NEAR(radiusAroundAxis(
                                evaluate(object->surface, k * 0.2, object->surface.knotsV()[0]).position),
                            2, 1e-9);
            continue;
        }
        ++caps;
        ASSERT_EQ(object->trimLoops.size(), 1U);
        EXPECT_GT(turn(object->trimLoops[0]), 0);
        for (const TrimCurve& curve : object->trimLoops[0].curves) {
            const Vec2 uv = curve.evaluate((curve.knots().domainStart() + curve.knots().domainEnd()) / 2);
            EXPECT_NEAR(radiusAroundAxis(evaluate(object->surface, uv.x, uv.y).position), 2, 1e-9);
        }
    }
    EXPECT_EQ(caps, 2);
}

TEST(StepSolids, AConeFacesOutwardsAndMeetsItsApex)
{
    const auto import = throughStep(BRepPrimAPI_MakeCone(kTilted, 3, 0, 6).Solid());
    ASSERT_EQ(import.scene.objects().size(), 2U);
    double nearest = 1e9;
    for (const SampledPoint& sample : samplesOf(import.scene))
        nearest = std::min(nearest, glm::length(sample.position - (kCentre + kAxis * 6.0)));
    EXPECT_LT(nearest, 1e-9);
}

TEST(StepSolids, AHoleIsALoopThatRunsClockwise)
{
    const gp_Circ circle(gp_Ax2(gp_Pnt(4, 3, 0), gp_Dir(0, 0, 1)), 1.0);
    BRepBuilderAPI_MakeFace plate(gp_Pln(), 0, 10, 0, 6);
    plate.Add(TopoDS::Wire(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)).Wire().Reversed()));
    const auto import = throughStep(plate.Face());
    ASSERT_EQ(import.scene.objects().size(), 1U);
    const SceneObject& object = *import.scene.objects().begin()->second;
    ASSERT_EQ(object.trimLoops.size(), 2U);
    EXPECT_NEAR(turn(object.trimLoops[0]), 2 * 60, 1e-9);
    EXPECT_NEAR(turn(object.trimLoops[1]), -2 * M_PI, 0.2);
    expectLoopsClosedInsideTheDomain(object);
}

TEST(StepSolids, TheTrimOfACylinderCutByAPlaneLiesOnThatPlane)
{
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(2, 10).Solid();
    const gp_Ax2 above(gp_Pnt(-20, -20, -5), gp_Dir(1, 0, 2));
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(above, 80, 80, 20).Solid();
    const Vec3 normal = Vec3(1, 0, 2) / std::sqrt(5.0);
    for (const TopoDS_Shape& cut : {BRepAlgoAPI_Cut(cylinder, box).Shape()}) {
        const auto import = throughStep(cut);
        EXPECT_TRUE(import.notes.empty());
        int onPlane = 0;
        for (const auto& [id, object] : import.scene.objects()) {
            expectLoopsClosedInsideTheDomain(*object);
            if (object->surface.degreeU() != 2)
                continue;
            ASSERT_EQ(object->trimLoops.size(), 1U);
            for (const TrimCurve& curve : object->trimLoops[0].curves) {
                if (curve.knots().degree() == 1)
                    continue;
                for (int s = 0; s <= 50; ++s) {
                    const double start = curve.knots().domainStart();
                    const Vec2 uv = curve.evaluate(start + (curve.knots().domainEnd() - start) * s / 50);
                    const Vec3 point = evaluate(object->surface, uv.x, uv.y).position;
                    onPlane += std::abs(glm::dot(point - Vec3(-20, -20, -5), normal) - 0) < 1e-5 ||
                                       std::abs(glm::dot(point - Vec3(-20, -20, -5), normal) - 20) < 1e-5
                                   ? 1
                                   : 0;
                }
            }
        }
        EXPECT_GE(onPlane, 51);
    }
}

TEST(StepSolids, AnOffsetSurfaceIsApproximatedAndSaidSo)
{
    TColgp_Array2OfPnt poles(1, 4, 1, 4);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            poles(i + 1, j + 1) = gp_Pnt(10 * i, 10 * j, (i == 1 && j == 2) ? 12 : 3 * (i + j) % 5);
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = 0;
    knots(2) = 1;
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(4);
    const Handle(Geom_BSplineSurface) wavy =
        new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, 3, 3);
    const Handle(Geom_OffsetSurface) offset = new Geom_OffsetSurface(wavy, 1.0);
    const auto import = throughStep(BRepBuilderAPI_MakeFace(offset, 1e-7).Face());
    ASSERT_EQ(import.scene.objects().size(), 1U);
    const NurbsSurface& surface = import.scene.objects().begin()->second->surface;
    const double size = surface.bounds().diagonal();
    for (double u : {0.0, 0.31, 0.5, 0.93, 1.0}) {
        for (double v : {0.0, 0.17, 0.5, 0.78, 1.0}) {
            const gp_Pnt wanted = offset->Value(u, v);
            EXPECT_LT(
                glm::length(evaluate(surface, u, v).position - Vec3(wanted.X(), wanted.Y(), wanted.Z())),
                2e-4 * size);
        }
    }
    ASSERT_EQ(import.notes.size(), 1U);
    EXPECT_NE(import.notes[0].find("approximated"), std::string::npos);
    EXPECT_EQ(import.report.approximated, 1);
    EXPECT_GT(import.report.approximationError, 0);
    EXPECT_LT(import.report.approximationError, 2e-4 * size);
}
