#include "model/cad/occt_export_wires.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include "model/cad/occt_spline.h"

namespace knotspan::occt {
namespace {

constexpr double kFitTolerance = 1e-8;  // of the face's size
constexpr int kHighestDegree = 9;
constexpr int kMostPieces = 1000;
constexpr int kSamples = 32;

// Where a curve runs straight from one corner to another, as sides do.
struct Straight {
    Vec2 from, to;
};

std::optional<Straight> straight(const TrimCurve& curve)
{
    const KnotVector& knots = curve.knots();
    if (knots.degree() != 1 || curve.points().size() != 2 ||
        curve.points()[0].weight != curve.points()[1].weight)
        return std::nullopt;
    return Straight{curve.points()[0].position, curve.points()[1].position};
}

class LoopBuilder {
public:
    LoopBuilder(TopoDS_Face& face, double size)
        : face_(face),
          surface_(BRep_Tool::Surface(face)),
          tolerance_(std::max(Precision::Confusion(), kFitTolerance * size))
    {
    }

    [[nodiscard]] Result<void> add(const std::vector<TrimCurve>& curves)
    {
        makeVertices(curves);
        TopoDS_Wire wire;
        builder_.MakeWire(wire);
        std::vector<TopoDS_Edge> edges(curves.size());
        for (size_t k = 0; k < curves.size(); ++k) {
            if (const auto across = acrossTheSeam(curves, k); across && *across < k) {
                builder_.Add(wire, edges[*across].Reversed());
                continue;
            } else {
                auto edge = makeEdge(curves, k, across);
                if (!edge)
                    return tl::unexpected(edge.error());
                edges[k] = *edge;
                builder_.Add(wire, edges[k]);
            }
        }
        wire.Closed(true);
        builder_.Add(face_, wire);
        return {};
    }

private:
    [[nodiscard]] gp_Pnt place(const Vec2& uv) const { return surface_->Value(uv.x, uv.y); }

    // One a place in space: at a pole, and on both sides of a seam, several corners are one.
    void makeVertices(const std::vector<TrimCurve>& curves)
    {
        vertices_.clear();
        std::vector<gp_Pnt> places;
        for (const TrimCurve& curve : curves) {
            const gp_Pnt here = place(curve.points().front().position);
            TopoDS_Vertex vertex;
            for (size_t k = 0; k < places.size() && vertex.IsNull(); ++k)
                if (places[k].Distance(here) <= tolerance_)
                    vertex = vertices_[k];
            if (vertex.IsNull())
                builder_.MakeVertex(vertex, here, tolerance_);
            places.push_back(here);
            vertices_.push_back(vertex);
        }
    }

    // The curve that is this one in space, run backwards on the other side of the parameter plane.
    [[nodiscard]] std::optional<size_t> acrossTheSeam(const std::vector<TrimCurve>& curves, size_t k) const
    {
        const auto here = straight(curves[k]);
        if (!here || isPoint(curves[k]))
            return std::nullopt;
        double low[2];
        double high[2];
        surface_->Bounds(low[0], high[0], low[1], high[1]);
        for (size_t other = 0; other < curves.size(); ++other) {
            const auto there = straight(curves[other]);
            if (other == k || !there || curves[other].knots() != curves[k].knots())
                continue;
            for (const int axis : {0, 1}) {
                const int along = 1 - axis;
                const bool closed = axis == 0 ? surface_->IsUClosed() : surface_->IsVClosed();
                const auto on = [&](const Straight& line, double side) {
                    return line.from[axis] == side && line.to[axis] == side;
                };
                const bool facing = (on(*here, low[axis]) && on(*there, high[axis])) ||
                                    (on(*here, high[axis]) && on(*there, low[axis]));
                if (closed && facing && here->from[along] == there->to[along] &&
                    here->to[along] == there->from[along])
                    return other;
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] bool isPoint(const TrimCurve& curve) const
    {
        const double start = curve.knots().domainStart();
        const double length = curve.knots().domainEnd() - start;
        const gp_Pnt first = place(curve.evaluate(start));
        for (int k = 1; k <= kSamples; ++k)
            if (place(curve.evaluate(start + length * k / kSamples)).Distance(first) > tolerance_)
                return false;
        return true;
    }

    [[nodiscard]] Result<TopoDS_Edge> makeEdge(const std::vector<TrimCurve>& curves, size_t k,
                                               std::optional<size_t> across)
    {
        const auto inPlane = splineOf(curves[k]);
        if (!inPlane)
            return tl::unexpected(inPlane.error());
        TopoDS_Edge edge;
        builder_.MakeEdge(edge);
        builder_.UpdateEdge(edge, *inPlane, face_, tolerance_);
        builder_.Range(edge, curves[k].knots().domainStart(), curves[k].knots().domainEnd());
        const bool pole = isPoint(curves[k]);
        builder_.Degenerated(edge, pole);
        builder_.Add(edge, vertices_[k].Oriented(TopAbs_FORWARD));
        builder_.Add(edge, vertices_[(k + 1) % curves.size()].Oriented(TopAbs_REVERSED));
        if (!pole && !BRepLib::BuildCurve3d(edge, tolerance_, GeomAbs_C1, kHighestDegree, kMostPieces))
            return failure("A trim curve could not be brought into space",
                           "Save the model as .knotspan instead");
        cleanPoles(edge);
        if (across) {
            auto other = splineOf(curves[*across]);
            if (!other)
                return tl::unexpected(other.error());
            (*other)->Reverse();
            builder_.UpdateEdge(edge, *inPlane, *other, face_, tolerance_);
        }
        return edge;
    }

    static void cleanPoles(const TopoDS_Edge& edge)
    {
        double first = 0, last = 0;
        const auto curve = Handle(Geom_BSplineCurve)::DownCast(BRep_Tool::Curve(edge, first, last));
        if (curve.IsNull())
            return;
        for (int k = 1; k <= curve->NbPoles(); ++k) {
            const gp_Pnt pole = curve->Pole(k);
            curve->SetPole(k, {withoutDust(pole.X()), withoutDust(pole.Y()), withoutDust(pole.Z())});
        }
    }

    TopoDS_Face& face_;
    Handle(Geom_Surface) surface_;
    double tolerance_;
    BRep_Builder builder_;
    std::vector<TopoDS_Vertex> vertices_;
};

}  // namespace

Result<void> addWires(TopoDS_Face& face, const std::vector<TrimLoop>& loops, double size)
{
    LoopBuilder builder(face, size);
    for (const TrimLoop& loop : loops)
        if (auto added = builder.add(loop.curves); !added)
            return added;
    return {};
}

}  // namespace knotspan::occt
