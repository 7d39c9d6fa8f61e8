#include "model/cad/occt_trim_loops.h"

#include <algorithm>
#include <cmath>

#include <BRepTools_WireExplorer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/cad/occt_pcurve.h"
#include "model/geometry/loop_direction.h"

namespace knotspan::occt {
namespace {

// Of the domain, between one curve's end and the next one's start: on small faces exporters' corners are half
// as far off.
constexpr double kWidestGap = 5e-3;

struct Domain {
    Vec2 low, size;
};

Domain domainOf(const NurbsSurface& surface)
{
    const Vec2 low(surface.knotsU().domainStart(), surface.knotsV().domainStart());
    return {low, Vec2(surface.knotsU().domainEnd(), surface.knotsV().domainEnd()) - low};
}

// The edges in the order of the boundary; as they are stored where OpenCASCADE cannot follow them.
std::vector<TopoDS_Edge> edgesInOrder(const TopoDS_Wire& wire, const TopoDS_Face& face)
{
    std::vector<TopoDS_Edge> stored;
    for (TopExp_Explorer it(wire, TopAbs_EDGE); it.More(); it.Next())
        if (const TopAbs_Orientation way = it.Current().Orientation();
            way == TopAbs_FORWARD || way == TopAbs_REVERSED)
            stored.push_back(TopoDS::Edge(it.Current()));
    std::vector<TopoDS_Edge> ordered;
    for (BRepTools_WireExplorer it(wire, face); it.More(); it.Next())
        ordered.push_back(it.Current());
    return ordered.size() == stored.size() ? ordered : stored;
}

TrimCurve withEnds(const TrimCurve& curve, const Vec2& start, const Vec2& end)
{
    std::vector<TrimPoint> points = curve.points();
    points.front().position = start;
    points.back().position = end;
    return TrimCurve::create(curve.knots(), std::move(points)).value();
}

// Curves' ends meet within the file's tolerance; here they meet exactly. A gap wider than that is bridged by
// nobody: the boundary is not one.
Result<void> close(std::vector<TrimCurve>& curves, const Domain& domain)
{
    for (size_t k = 0; k < curves.size(); ++k) {
        TrimCurve& next = curves[(k + 1) % curves.size()];
        const Vec2 end = curves[k].points().back().position;
        const Vec2 gap = (next.points().front().position - end) / domain.size;
        if (!(glm::length(gap) <= kWidestGap))
            return failure("The boundary is not closed");
        if (gap != Vec2(0.0))
            next = withEnds(next, end, next.points().back().position);
    }
    // The last step moved the first curve's start; the curve before it ends there already.
    return {};
}

// Whether a curve lies on one of the four sides of the domain, but for what exporters lose.
bool onASide(const TrimCurve& curve, const Domain& domain)
{
    for (int axis = 0; axis < 2; ++axis) {
        for (const double side : {0.0, 1.0}) {
            const auto lies = [&](const TrimPoint& point) {
                const double place = (point.position[axis] - domain.low[axis]) / domain.size[axis];
                return std::abs(place - side) < 2e-5;
            };
            if (std::all_of(curve.points().begin(), curve.points().end(), lies))
                return true;
        }
    }
    return false;
}

Result<std::vector<TrimCurve>> curvesOf(const TopoDS_Wire& wire, const TopoDS_Face& face,
                                        const ConvertedSurface& converted)
{
    std::vector<TrimCurve> curves;
    for (const TopoDS_Edge& edge : edgesInOrder(wire, face)) {
        auto curve = toTrimCurve(edge, face, converted);
        if (!curve)
            return tl::unexpected(curve.error());
        curves.push_back(std::move(*curve));
    }
    if (auto closed = close(curves, domainOf(converted.surface)); !closed)
        return tl::unexpected(closed.error());
    return curves;
}

// The largest loop is the outer one and runs anticlockwise, the holes clockwise.
std::vector<TrimLoop> sorted(std::vector<std::vector<TrimCurve>> chains)
{
    std::stable_sort(chains.begin(), chains.end(), [](const auto& a, const auto& b) {
        return std::abs(signedArea(a)) > std::abs(signedArea(b));
    });
    std::vector<TrimLoop> loops;
    for (std::vector<TrimCurve>& chain : chains) {
        const bool outer = loops.empty();
        if ((signedArea(chain) > 0) != outer)
            chain = turnedRound(chain);
        loops.push_back({outer, std::move(chain)});
    }
    return loops;
}

}  // namespace

Result<std::vector<TrimLoop>> trimLoops(const TopoDS_Face& face, const ConvertedSurface& converted)
{
    if (!converted.mapsHold)
        return failure("The surface could not keep its parameters");
    const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
    const Domain domain = domainOf(converted.surface);
    std::vector<std::vector<TrimCurve>> chains;
    for (TopExp_Explorer it(forward, TopAbs_WIRE); it.More(); it.Next()) {
        auto curves = curvesOf(TopoDS::Wire(it.Current()), forward, converted);
        if (!curves)
            return tl::unexpected(curves.error());
        if (!curves->empty())
            chains.push_back(std::move(*curves));
    }
    const auto natural = [&](const std::vector<TrimCurve>& chain) {
        return std::all_of(chain.begin(), chain.end(),
                           [&](const TrimCurve& curve) { return onASide(curve, domain); });
    };
    if (chains.empty() || (chains.size() == 1 && natural(chains.front())))
        return std::vector<TrimLoop>{};
    return sorted(std::move(chains));
}

}  // namespace knotspan::occt
