#include "model/cad/iges_faces.h"

#include <vector>

#include <BRepToIGES_BRWire.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomToIGES_GeomSurface.hxx>
#include <Geom_Surface.hxx>
#include <IGESData_HArray1OfIGESEntity.hxx>
#include <IGESGeom_CompositeCurve.hxx>
#include <IGESGeom_CurveOnSurface.hxx>
#include <IGESGeom_HArray1OfCurveOnSurface.hxx>
#include <IGESGeom_TrimmedSurface.hxx>
#include <ShapeAlgo.hxx>
#include <ShapeAlgo_AlgoContainer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>

namespace knotspan::formats {
namespace {

using Entity = Handle(IGESData_IGESEntity);

// One curve as it is, several in a row.
Entity inOne(const std::vector<Entity>& curves)
{
    if (curves.size() < 2)
        return curves.empty() ? Entity() : curves.front();
    const Handle(IGESData_HArray1OfIGESEntity) all =
        new IGESData_HArray1OfIGESEntity(1, static_cast<int>(curves.size()));
    for (size_t k = 0; k < curves.size(); ++k)
        all->SetValue(static_cast<int>(k) + 1, curves[k]);
    Handle(IGESGeom_CompositeCurve) composite = new IGESGeom_CompositeCurve;
    composite->Init(all);
    return Entity(composite);
}

class Boundaries {
public:
    Boundaries(const TopoDS_Face& face, const BRepToIGES_BREntity& maker, Entity surface, double length)
        : maker_(maker),
          surface_(std::move(surface)),
          length_(length)
    {
        TopLoc_Location place;
        const Handle(Geom_Surface) under = BRep_Tool::Surface(face, place);
        BRep_Builder().MakeFace(bare_, under, place, BRep_Tool::Tolerance(face));
    }

    [[nodiscard]] Handle(IGESGeom_CurveOnSurface) of(const TopoDS_Wire& wire)
    {
        std::vector<Entity> inSpace;
        std::vector<Entity> inPlane;
        for (TopoDS_Iterator it(wire); it.More(); it.Next()) {
            const TopoDS_Edge edge = TopoDS::Edge(it.Value());
            if (Entity curve = maker_.TransferEdge(edge, Standard_False); !curve.IsNull())
                inSpace.push_back(curve);
            if (Entity curve = maker_.TransferEdge(edge, bare_, length_, Standard_False); !curve.IsNull())
                inPlane.push_back(curve);
        }
        constexpr int kPlane = 1;
        constexpr int kSpace = 2;
        const int preferred = (inPlane.empty() ? 0 : kPlane) + (inSpace.empty() ? 0 : kSpace);
        const Handle(IGESGeom_CurveOnSurface) result = new IGESGeom_CurveOnSurface;
        result->Init(0, surface_, inOne(inPlane), inOne(inSpace), preferred);
        return result;
    }

private:
    BRepToIGES_BRWire maker_;
    Entity surface_;
    double length_;
    TopoDS_Face bare_;  // the surface without its boundaries, whose extent is asked for at each edge
};

}  // namespace

Handle(IGESData_IGESEntity) igesFace(const TopoDS_Face& face, const BRepToIGES_BREntity& maker)
{
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    double low[2];
    double high[2];
    BRepTools::UVBounds(face, low[0], high[0], low[1], high[1]);
    GeomToIGES_GeomSurface surfaces;
    surfaces.SetModel(maker.GetModel());
    const Entity written = surfaces.TransferSurface(surface, low[0], high[0], low[1], high[1]);
    if (written.IsNull())
        return written;
    Boundaries boundaries(face, maker, written, surfaces.Length());
    const TopoDS_Wire outer = ShapeAlgo::AlgoContainer()->OuterWire(face);
    Handle(IGESGeom_CurveOnSurface) around;
    const bool isWhole = BRep_Tool::NaturalRestriction(face);  // and needs nothing around it
    if (!isWhole)
        around = boundaries.of(outer);
    std::vector<Handle(IGESGeom_CurveOnSurface)> holes;
    for (TopoDS_Iterator it(face); it.More(); it.Next())
        if (!it.Value().IsSame(outer))
            holes.push_back(boundaries.of(TopoDS::Wire(it.Value())));
    Handle(IGESGeom_HArray1OfCurveOnSurface) inner;
    if (!holes.empty())
        inner = new IGESGeom_HArray1OfCurveOnSurface(1, static_cast<int>(holes.size()));
    for (size_t k = 0; k < holes.size(); ++k)
        inner->SetValue(static_cast<int>(k) + 1, holes[k]);
    const Handle(IGESGeom_TrimmedSurface) trimmed = new IGESGeom_TrimmedSurface;
    trimmed->Init(written, isWhole ? 0 : 1, around, inner);
    return Entity(trimmed);
}

}  // namespace knotspan::formats
