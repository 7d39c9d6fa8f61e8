#include "model/cad/occt_export_wires.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>

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

// The corners of a loop that are one point in space, found without comparing each with each.
class Places {
public:
    explicit Places(double tolerance) : tolerance_(tolerance) {}

    // Counts this place, and gives the first one before it that lies within the tolerance of it.
    std::optional<size_t> add(const gp_Pnt& place)
    {
        const Cell cell{cellOf(place.X()), cellOf(place.Y()), cellOf(place.Z())};
        std::optional<size_t> first;
        for (int k = 0; k < 27; ++k) {
            const Cell beside{cell[0] + k % 3 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k / 9 - 1};
            const auto found = cells_.find(beside);
            if (found == cells_.end())
                continue;
            for (const size_t other : found->second)
                if (places_[other].Distance(place) <= tolerance_ && (!first || other < *first))
                    first = other;
        }
        cells_[cell].push_back(places_.size());
        places_.push_back(place);
        return first;
    }

private:
    using Cell = std::array<double, 3>;
    struct Hash {
        size_t operator()(const Cell& cell) const
        {
            size_t hash = 0;
            for (const double part : cell)
                hash = hash * 1000003 + std::hash<double>()(part);
            return hash;
        }
    };
    [[nodiscard]] double cellOf(double coordinate) const { return std::floor(coordinate / tolerance_); }

    double tolerance_;
    std::vector<gp_Pnt> places_;
    std::unordered_map<Cell, std::vector<size_t>, Hash> cells_;
};

class LoopBuilder {
public:
    LoopBuilder(TopoDS_Face& face, double size)
        : face_(face),
          surface_(BRep_Tool::Surface(face)),
          tolerance_(std::max(Precision::Confusion(), kFitTolerance * size))
    {
        surface_->Bounds(low_[0], high_[0], low_[1], high_[1]);
        closed_[0] = surface_->IsUClosed();
        closed_[1] = surface_->IsVClosed();
    }

    [[nodiscard]] Result<void> add(const std::vector<TrimCurve>& curves)
    {
        makeVertices(curves);
        findSides(curves);
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
        Places places(tolerance_);
        for (const TrimCurve& curve : curves) {
            const gp_Pnt here = place(curve.points().front().position);
            const auto same = places.add(here);
            TopoDS_Vertex vertex = same ? vertices_[*same] : TopoDS_Vertex();
            if (!same)
                builder_.MakeVertex(vertex, here, tolerance_);
            vertices_.push_back(vertex);
        }
    }

    // The lines that run along one side of a closed direction, by where they do.
    struct Side {
        int axis = 0;
        bool atEnd = false;
        double from = 0;
        double to = 0;

        auto operator<=>(const Side&) const = default;
    };

    [[nodiscard]] std::optional<Side> sideOf(const TrimCurve& curve) const
    {
        const auto line = straight(curve);
        for (const int axis : {0, 1}) {
            const int along = 1 - axis;
            if (!line || !closed_[axis] || line->from[axis] != line->to[axis])
                continue;
            if (const bool atEnd = line->from[axis] == high_[axis]; atEnd || line->from[axis] == low_[axis])
                return Side{axis, atEnd, line->from[along], line->to[along]};
        }
        return std::nullopt;
    }

    void findSides(const std::vector<TrimCurve>& curves)
    {
        sides_.clear();
        for (size_t k = 0; k < curves.size(); ++k)
            if (const auto side = sideOf(curves[k]))
                sides_[*side].push_back(k);
    }

    // The curve that is this one in space, run backwards on the other side of the parameter plane.
    [[nodiscard]] std::optional<size_t> acrossTheSeam(const std::vector<TrimCurve>& curves, size_t k) const
    {
        const auto here = sideOf(curves[k]);
        if (!here || isPoint(curves[k]))
            return std::nullopt;
        const auto there = sides_.find({here->axis, !here->atEnd, here->to, here->from});
        if (there == sides_.end())
            return std::nullopt;
        for (const size_t other : there->second)
            if (curves[other].knots() == curves[k].knots())
                return other;
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
    double low_[2];
    double high_[2];
    bool closed_[2];  // asked once: OpenCASCADE makes curves of the sides each time
    BRep_Builder builder_;
    std::map<Side, std::vector<size_t>> sides_;
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
