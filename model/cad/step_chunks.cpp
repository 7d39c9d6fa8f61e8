#include "model/cad/step_chunks.h"

#include <unordered_set>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_HArray1OfPcurveOrSurface.hxx>
#include <StepGeom_Pcurve.hxx>
#include <StepGeom_PcurveOrSurface.hxx>
#include <StepGeom_SurfaceCurve.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_HArray1OfFace.hxx>
#include <StepShape_HArray1OfFaceBound.hxx>
#include <StepShape_HArray1OfOrientedEdge.hxx>
#include <StepShape_OrientedEdge.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Wire.hxx>
#include <TransferBRep.hxx>
#include <TransferBRep_ShapeMapper.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>

namespace knotspan::formats {
namespace {

constexpr int kChunk = 200;  // edges

Handle(TCollection_HAsciiString) noName()
{
    return new TCollection_HAsciiString("");
}

// The edges that the writer takes, each once; those on both sides of a seam come first, with one other behind
// them, because it makes a point of a boundary that is only a seam.
struct Edges {
    std::vector<TopoDS_Edge> onSeams;
    std::vector<TopoDS_Edge> others;
};

Edges edgesOf(const TopoDS_Face& face)
{
    TopTools_IndexedMapOfShape once;
    TopTools_MapOfShape twice;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
        if (!BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) {
            const int before = once.Extent();
            if (once.Add(it.Current()) <= before)
                twice.Add(it.Current());
        }
    Edges edges;
    for (int k = 1; k <= once.Extent(); ++k)
        (twice.Contains(once(k)) ? edges.onSeams : edges.others).push_back(TopoDS::Edge(once(k)));
    return edges;
}

class ChunkedFace {
public:
    explicit ChunkedFace(const TopoDS_Face& face)
        : surface_(BRep_Tool::Surface(face)),
          tolerance_(BRep_Tool::Tolerance(face))
    {
        builder_.MakeShell(shell_);
        begin();
    }

    void add(const TopoDS_Shape& edge)
    {
        builder_.Add(wire_, edge);
        ++count_;
    }

    void endIfFull()
    {
        if (count_ < kChunk)
            return;
        end();
        begin();
    }

    TopoDS_Shell shell()
    {
        end();
        return shell_;
    }

private:
    void begin()
    {
        count_ = 0;
        builder_.MakeWire(wire_);
    }

    void end()
    {
        if (count_ == 0)
            return;
        TopoDS_Face part;
        builder_.MakeFace(part, surface_, tolerance_);
        builder_.Add(part, wire_);
        builder_.Add(shell_, part);
    }

    Handle(Geom_Surface) surface_;
    double tolerance_;
    BRep_Builder builder_;
    TopoDS_Shell shell_;
    TopoDS_Wire wire_;
    int count_ = 0;
};

bool isChunked(const Edges& edges)
{
    return !edges.others.empty() && edges.onSeams.size() + edges.others.size() > kChunk;
}

using EdgeCurve = Handle(StepShape_EdgeCurve);

class Joining {
public:
    explicit Joining(STEPControl_Writer& writer)
        : model_(writer.Model()),
          protocol_(writer.WS()->Protocol()),
          process_(writer.WS()->TransferWriter()->FinderProcess())
    {
    }

    [[nodiscard]] Result<void> join(const Handle(StepShape_ConnectedFaceSet) & shell, const TopoDS_Face& face)
    {
        const auto kept = Handle(StepShape_FaceSurface)::DownCast(shell->CfsFacesValue(1));
        std::vector<Handle(StepShape_FaceBound)> bounds;
        for (TopoDS_Iterator it(face); it.More(); it.Next()) {
            auto bound = boundOf(TopoDS::Wire(it.Value()), kept->FaceGeometry());
            if (!bound)
                return tl::unexpected(bound.error());
            bounds.push_back(*bound);
        }
        const Handle(StepShape_HArray1OfFaceBound) all =
            new StepShape_HArray1OfFaceBound(1, static_cast<int>(bounds.size()));
        for (size_t k = 0; k < bounds.size(); ++k)
            all->SetValue(static_cast<int>(k) + 1, bounds[k]);
        for (int k = 1; k <= kept->NbBounds(); ++k)
            dropped_.insert(kept->BoundsValue(k).get());
        kept->SetBounds(all);
        for (int k = 2; k <= shell->NbCfsFaces(); ++k)
            dropped_.insert(shell->CfsFacesValue(k).get());
        const Handle(StepShape_HArray1OfFace) one = new StepShape_HArray1OfFace(1, 1);
        one->SetValue(1, kept);
        shell->SetCfsFaces(one);
        return {};
    }

    // Takes what only the dropped faces and their boundaries need out of the model.
    void clean()
    {
        if (dropped_.empty())
            return;
        const Interface_Graph graph(model_, protocol_);
        std::vector<Handle(Standard_Transient)> open;
        std::unordered_set<Standard_Transient*> needed;
        const auto need = [&](const Handle(Standard_Transient) & entity) {
            if (needed.insert(entity.get()).second)
                open.push_back(entity);
        };
        for (int k = 1; k <= model_->NbEntities(); ++k)
            if (!dropped_.contains(model_->Value(k).get()) &&
                graph.Sharings(model_->Value(k)).NbEntities() == 0)
                need(model_->Value(k));
        while (!open.empty()) {
            const Handle(Standard_Transient) entity = open.back();
            open.pop_back();
            for (Interface_EntityIterator it = graph.Shareds(entity); it.More(); it.Next())
                need(it.Value());
        }
        std::vector<Handle(Standard_Transient)> all;
        for (int k = 1; k <= model_->NbEntities(); ++k)
            all.push_back(model_->Value(k));
        model_->ClearEntities();
        for (const auto& entity : all)
            if (needed.contains(entity.get()))
                model_->AddEntity(entity);
    }

private:
    [[nodiscard]] Result<Handle(StepShape_FaceBound)> boundOf(const TopoDS_Wire& wire,
                                                              const Handle(StepGeom_Surface) & surface)
    {
        std::vector<Handle(StepShape_OrientedEdge)> edges;
        for (TopoDS_Iterator it(wire); it.More(); it.Next()) {
            const TopoDS_Edge edge = TopoDS::Edge(it.Value());
            if (BRep_Tool::Degenerated(edge))
                continue;
            EdgeCurve curve;
            if (!process_->FindTypedTransient(TransferBRep::ShapeMapper(process_, edge),
                                              STANDARD_TYPE(StepShape_EdgeCurve), curve))
                return failure("OpenCASCADE left out an edge", "Save the model as .knotspan instead");
            move(curve, surface);
            const Handle(StepShape_OrientedEdge) oriented = new StepShape_OrientedEdge;
            oriented->Init(noName(), curve, edge.Orientation() == TopAbs_FORWARD);
            model_->AddEntity(oriented);
            edges.push_back(oriented);
        }
        const Handle(StepShape_HArray1OfOrientedEdge) all =
            new StepShape_HArray1OfOrientedEdge(1, static_cast<int>(edges.size()));
        for (size_t k = 0; k < edges.size(); ++k)
            all->SetValue(static_cast<int>(k) + 1, edges[k]);
        const Handle(StepShape_EdgeLoop) loop = new StepShape_EdgeLoop;
        loop->Init(noName(), all);
        const Handle(StepShape_FaceBound) bound = new StepShape_FaceBound;
        bound->Init(noName(), loop, wire.Orientation() == TopAbs_FORWARD);
        model_->AddEntity(loop);
        model_->AddEntity(bound);
        return bound;
    }

    // Its curves in (u, v) to the surface of the face that is kept.
    static void move(const EdgeCurve& edge, const Handle(StepGeom_Surface) & surface)
    {
        const auto curve = Handle(StepGeom_SurfaceCurve)::DownCast(edge->EdgeGeometry());
        if (curve.IsNull() || curve->AssociatedGeometry().IsNull())
            return;
        for (int k = 1; k <= curve->NbAssociatedGeometry(); ++k)
            if (const auto inPlane = curve->AssociatedGeometryValue(k).Pcurve(); !inPlane.IsNull())
                inPlane->SetBasisSurface(surface);
    }

    Handle(Interface_InterfaceModel) model_;
    Handle(Interface_Protocol) protocol_;
    Handle(Transfer_FinderProcess) process_;
    std::unordered_set<Standard_Transient*> dropped_;
};

}  // namespace

TopoDS_Shell inChunks(const TopoDS_Face& face)
{
    const Edges edges = edgesOf(face);
    if (!isChunked(edges)) {
        TopoDS_Shell shell;
        BRep_Builder().MakeShell(shell);
        BRep_Builder().Add(shell, face);
        return shell;
    }
    ChunkedFace chunks(face);
    for (const TopoDS_Edge& edge : edges.onSeams) {
        chunks.add(edge.Oriented(TopAbs_FORWARD));
        chunks.add(edge.Oriented(TopAbs_REVERSED));
    }
    for (const TopoDS_Edge& edge : edges.others) {
        chunks.add(edge);
        chunks.endIfFull();
    }
    return chunks.shell();
}

Result<void> joinChunks(STEPControl_Writer& writer,
                        const std::vector<Handle(StepShape_ConnectedFaceSet)>& shells,
                        const std::vector<TopoDS_Face>& faces)
{
    Joining joining(writer);
    for (size_t k = 0; k < faces.size(); ++k)
        if (isChunked(edgesOf(faces[k])))
            if (auto joined = joining.join(shells[k], faces[k]); !joined)
                return joined;
    joining.clean();
    return {};
}

}  // namespace knotspan::formats
