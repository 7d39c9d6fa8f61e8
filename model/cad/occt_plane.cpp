#include "model/cad/occt_plane.h"

#include <cmath>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <BndLib_Add2dCurve.hxx>
#include <Bnd_Box2d.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>

namespace knotspan::occt {
namespace {

std::optional<gp_Dir> longestStraightEdge(const TopoDS_Face& face)
{
    std::optional<gp_Dir> direction;
    double longest = 0;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(it.Current());
        if (BRep_Tool::Degenerated(edge) || !BRep_Tool::IsGeometric(edge))
            continue;
        const BRepAdaptor_Curve curve(edge);
        const double length = curve.LastParameter() - curve.FirstParameter();
        if (curve.GetType() != GeomAbs_Line || !(length > longest))
            continue;
        longest = length;
        direction = curve.Line().Direction();
    }
    return direction;
}

}  // namespace

std::optional<AlignedPlane> alignedPlane(const TopoDS_Face& face, const Handle(Geom_Plane) & plane)
{
    const auto along = longestStraightEdge(face);
    const gp_Dir normal = plane->Position().Direction();
    if (!along || std::abs(along->Dot(normal)) > 1e-3)
        return {};
    gp_Ax3 axes(plane->Location(), normal, *along);
    if (!plane->Position().Direct())
        axes.YReverse();
    const Handle(Geom_Plane) turned = new Geom_Plane(axes);
    Bnd_Box2d box;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
        double first = 0, last = 0;
        const Handle(Geom2d_Curve) curve =
            BRep_Tool::CurveOnPlane(TopoDS::Edge(it.Current()), turned, TopLoc_Location(), first, last);
        if (curve.IsNull())
            return {};
        BndLib_Add2dCurve::AddOptimal(curve, first, last, 0.0, box);
    }
    if (box.IsVoid())
        return {};
    box.SetGap(0.0);
    ParameterRange range{};
    box.Get(range.startU, range.startV, range.endU, range.endV);
    return AlignedPlane{turned, range};
}

}  // namespace knotspan::occt
