// The edges of solids made by OpenCASCADE, read from STEP: who meets whom, and at which angle, against its
// own topology and its own normals.
#include <cmath>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Pnt2d.hxx>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "model/friends/scene_friends.h"
#include "tests/model/formats/step_solids.h"

using namespace knotspan;
using knotspan::testing::throughStep;

namespace {

constexpr int kSteps = 16;

struct SolidEdge {
    std::vector<Vec3> points;
    double angleDeg = 0;  // largest between outward normals
};

// By OpenCASCADE's own surfaces and curves in their parameters.
SolidEdge lookAt(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces)
{
    SolidEdge result;
    for (int k = 0; k <= kSteps; ++k) {
        std::vector<Vec3> normals;
        for (const TopoDS_Shape& shape : faces) {
            const TopoDS_Face face = TopoDS::Face(shape);
            double first = 0;
            double last = 1;
            const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
            const gp_Pnt2d place = curve->Value(first + (last - first) * k / kSteps);
            gp_Pnt at;
            gp_Vec du;
            gp_Vec dv;
            BRepAdaptor_Surface(face).D1(place.X(), place.Y(), at, du, dv);
            const gp_Vec normal = du.Crossed(dv) * (face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0);
            normals.push_back(glm::normalize(Vec3(normal.X(), normal.Y(), normal.Z())));
            if (normals.size() == 1)
                result.points.emplace_back(at.X(), at.Y(), at.Z());
        }
        result.angleDeg =
            std::max(result.angleDeg, glm::degrees(std::atan2(glm::length(glm::cross(normals[0], normals[1])),
                                                              glm::dot(normals[0], normals[1]))));
    }
    return result;
}

std::vector<SolidEdge> edgesOf(const TopoDS_Shape& solid)
{
    TopTools_IndexedDataMapOfShapeListOfShape faces;
    TopExp::MapShapesAndUniqueAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces);
    std::vector<SolidEdge> result;
    for (int k = 1; k <= faces.Extent(); ++k) {
        const TopoDS_Edge edge = TopoDS::Edge(faces.FindKey(k));
        if (!BRep_Tool::Degenerated(edge) && faces(k).Extent() == 2)  // no seams
            result.push_back(lookAt(edge, faces(k)));
    }
    return result;
}

double distanceTo(const SceneFriends& friends, const EdgePart& part, const Vec3& point)
{
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 400; ++k)
        least = std::min(least, glm::distance(point, pointOn(*friends.object(part.surface), part,
                                                             part.from + (part.to - part.from) * k / 400)));
    return least;
}

TEST(StepEdges, OfASolidMeetWhereItsTopologySaysAndAtItsAngles)
{
    const TopoDS_Solid box = BRepPrimAPI_MakeBox(60, 40, 30).Solid();
    BRepFilletAPI_MakeFillet rounding(box);
    int number = 0;
    for (TopExp_Explorer at(box, TopAbs_EDGE); at.More() && number < 9; at.Next(), ++number)
        if (number % 4 == 0)
            rounding.Add(5, TopoDS::Edge(at.Current()));
    const gp_Ax2 slanted(gp_Pnt(25, 18, -10), gp_Dir(0.2, 0.1, 1));
    const TopoDS_Shape solid =
        BRepAlgoAPI_Cut(rounding.Shape(), BRepPrimAPI_MakeCylinder(slanted, 7, 60).Shape()).Shape();
    const std::vector<SolidEdge> wanted = edgesOf(solid);
    ASSERT_GE(wanted.size(), 15U);

    const formats::Import import = throughStep(solid);
    SceneFriends friends(defaultTolerances(true));
    friends.follow(import.scene);
    EXPECT_TRUE(friends.nakedEdges().empty());
    size_t smooth = 0;
    size_t found = 0;
    for (const SolidEdge& solidEdge : wanted)
        for (const FriendEdge& edge : friends.edges()) {
            bool same = edge.a.surface != edge.b.surface;
            for (int k = 2; k <= kSteps - 2 && same; k += 3)
                same = distanceTo(friends, edge.a, solidEdge.points[static_cast<size_t>(k)]) < 0.2;
            if (!same)
                continue;
            ++found;
            smooth += edge.areFriends() ? 1 : 0;
            EXPECT_NEAR(edge.angleMaxDeg, solidEdge.angleDeg, 0.2);
            EXPECT_GE(edge.angleBoundDeg, solidEdge.angleDeg - 1e-3);
            EXPECT_EQ(edge.areFriends(), solidEdge.angleDeg < 0.5);
            EXPECT_LE(edge.gapMax, 1e-3);
        }
    EXPECT_EQ(found, wanted.size());  // each once
    EXPECT_GE(smooth, 6U);            // beside the roundings
}

}  // namespace
