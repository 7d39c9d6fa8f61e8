#include "model/cad/occt_healing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Interface_Static.hxx>
#include <ShapeAlgo.hxx>
#include <ShapeAlgo_AlgoContainer.hxx>
#include <ShapeAlgo_ToolContainer.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeFix_Wire.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <XSAlgo.hxx>

namespace knotspan::formats {
namespace {

constexpr int kLongWire = 200;    // edges
constexpr double kMeeting = 1e-6;  // of the loop's size: ends that are so near are one

bool isLong(const TopoDS_Shape& wire)
{
    int edges = 0;
    for (TopoDS_Iterator it(wire); it.More(); it.Next())
        ++edges;
    return edges > kLongWire;
}

// Whether the edges, in their order, have curves in (u, v) that go on where the one before ends.
bool isComplete(const TopoDS_Shape& wire, const TopoDS_Face& face)
{
    std::vector<gp_Pnt2d> ends;  // start and end of each edge
    gp_Pnt2d low(1e300, 1e300);
    gp_Pnt2d high(-1e300, -1e300);
    for (TopoDS_Iterator it(wire); it.More(); it.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(it.Value());
        double first = 0;
        double last = 0;
        const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
        if (curve.IsNull())
            return false;
        if (edge.Orientation() == TopAbs_REVERSED)
            std::swap(first, last);
        for (const double place : {first, last}) {
            const gp_Pnt2d end = curve->Value(place);
            low.SetCoord(std::min(low.X(), end.X()), std::min(low.Y(), end.Y()));
            high.SetCoord(std::max(high.X(), end.X()), std::max(high.Y(), end.Y()));
            ends.push_back(end);
        }
    }
    for (size_t k = 1; k < ends.size(); k += 2) {
        const gp_Pnt2d& next = ends[(k + 1) % ends.size()];
        if (!(std::abs(next.X() - ends[k].X()) <= kMeeting * (high.X() - low.X()) &&
              std::abs(next.Y() - ends[k].Y()) <= kMeeting * (high.Y() - low.Y())))
            return false;
    }
    return true;
}

struct Wires {
    bool anyLong = false;
    bool allComplete = true;
};

Wires wiresOf(const TopoDS_Shape& shape)
{
    Wires found;
    for (TopExp_Explorer wires(shape, TopAbs_WIRE); wires.More() && !found.anyLong; wires.Next())
        found.anyLong = isLong(wires.Current());
    if (!found.anyLong)
        return found;
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More() && found.allComplete; faces.Next()) {
        const TopoDS_Face face = TopoDS::Face(faces.Current().Oriented(TopAbs_FORWARD));
        for (TopoDS_Iterator it(face); it.More() && found.allComplete; it.Next())
            found.allComplete = it.Value().ShapeType() != TopAbs_WIRE || isComplete(it.Value(), face);
    }
    return found;
}

class FewerFixes : public ShapeAlgo_ToolContainer {
public:
    Handle(ShapeFix_Shape) FixShape() const override
    {
        Handle(ShapeFix_Shape) tool = ShapeAlgo_ToolContainer::FixShape();
        tool->FixWireTool()->FixSelfIntersectionMode() = 0;
        return tool;
    }
};

class Healer : public XSAlgo_AlgoContainer {
public:
    TopoDS_Shape ProcessShape(const TopoDS_Shape& shape, const Standard_Real precision,
                              const Standard_Real maxTolerance, const Standard_CString resources,
                              const Standard_CString sequence, Handle(Standard_Transient) & info,
                              const Message_ProgressRange& progress,
                              const Standard_Boolean nonManifold) const override
    {
        const Wires wires = shape.IsNull() ? Wires() : wiresOf(shape);
        if (wires.anyLong && wires.allComplete)
            return shape;
        const Handle(ShapeAlgo_AlgoContainer) algorithms = ShapeAlgo::AlgoContainer();
        const Handle(ShapeAlgo_ToolContainer) tools = algorithms->ToolContainer();
        if (wires.anyLong)
            algorithms->SetToolContainer(new FewerFixes);
        TopoDS_Shape healed = XSAlgo_AlgoContainer::ProcessShape(shape, precision, maxTolerance, resources,
                                                                 sequence, info, progress, nonManifold);
        algorithms->SetToolContainer(tools);
        return healed;
    }
};

}  // namespace

SwiftHealing::SwiftHealing()
{
    // Which edges are smooth nobody asks us, and OpenCASCADE looks for it in quadratic time.
    Interface_Static::SetRVal("read.encoderegularity.angle", 0);
    XSAlgo::Init();
    before_ = XSAlgo::AlgoContainer();
    XSAlgo::SetAlgoContainer(new Healer);
}

SwiftHealing::~SwiftHealing()
{
    XSAlgo::SetAlgoContainer(before_);
}

}  // namespace knotspan::formats
