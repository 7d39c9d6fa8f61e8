#include "model/cad/occt_surface.h"

#include <algorithm>
#include <cmath>

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <ShapeConstruct.hxx>
#include <Standard_Failure.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <glm/geometric.hpp>

#include "model/cad/occt_plane.h"
#include "model/cad/occt_revolution.h"
#include "model/geometry/evaluation.h"

namespace knotspan::occt {

// An arc of half angle h is, at the local parameter t in [0,1], at the angle a from its middle with
// tan(a / 2) = (2 t - 1) tan(h / 2).
double ParameterMap::operator()(double theirs) const
{
    const double inside = std::clamp(theirs, start, end);
    double ours = ourStart + (inside - start);
    if (kind == Kind::angle) {
        const double step = (end - start) / spans;
        const int arc = std::clamp(static_cast<int>((inside - start) / step), 0, spans - 1);
        const double middle = start + step * (arc + 0.5);
        const double t = 0.5 + 0.5 * std::tan((inside - middle) / 2) / std::tan(step / 4);
        ours = ourStart + step * (arc + std::clamp(t, 0.0, 1.0));
    }
    const double ourEnd = ourStart + (end - start);
    return backwards ? ourStart + ourEnd - ours : ours;
}

double ParameterMap::derivative(double theirs) const
{
    double slope = 1;
    if (kind == Kind::angle) {
        const double step = (end - start) / spans;
        const int arc = std::clamp(static_cast<int>((theirs - start) / step), 0, spans - 1);
        const double cosine = std::cos((theirs - start - step * (arc + 0.5)) / 2);
        slope = step / (4 * std::tan(step / 4) * cosine * cosine);
    }
    return backwards ? -slope : slope;
}

namespace {

// A bound that lies on a knot but for rounding is that knot: a span of 1e-12 helps nobody.
double snapped(double bound, double first, double last)
{
    const double tolerance = 1e-7 * (last - first);
    if (std::abs(bound - first) <= tolerance)
        return first;
    return std::abs(bound - last) <= tolerance ? last : bound;
}

// Also ends its being periodic.
void cutToRange(const Handle(Geom_BSplineSurface) & spline, ParameterRange& range)
{
    const auto snapToKnots = [](double bound, auto knot, int count) {
        const double all = knot(count) - knot(1);
        for (int k = 1; k <= count; ++k)
            if (std::abs(knot(k) - bound) <= 1e-7 * all)
                return knot(k);
        return bound;
    };
    const auto knotU = [&](int k) { return spline->UKnot(k); };
    const auto knotV = [&](int k) { return spline->VKnot(k); };
    range.startU = snapToKnots(range.startU, knotU, spline->NbUKnots());
    range.endU = snapToKnots(range.endU, knotU, spline->NbUKnots());
    range.startV = snapToKnots(range.startV, knotV, spline->NbVKnots());
    range.endV = snapToKnots(range.endV, knotV, spline->NbVKnots());
    double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
    spline->Bounds(u1, u2, v1, v2);
    if (range.startU != u1 || range.endU != u2 || range.startV != v1 || range.endV != v2)
        spline->Segment(range.startU, range.endU, range.startV, range.endV);
    // Closed surfaces come as periodic ones, whose first and last rows of control points are one.
    if (spline->IsUPeriodic())
        spline->SetUNotPeriodic();
    if (spline->IsVPeriodic())
        spline->SetVNotPeriodic();
}

// `wasPeriodic`: OpenCASCADE makes closed surfaces periodic, which puts their outermost knots a span away.
// Where the next ones stand `degree` times, those have no part in the surface: clamped ends say the same.
Result<KnotVector> knotVector(int degree, const TColStd_Array1OfReal& knots,
                              const TColStd_Array1OfInteger& multiplicities, bool wasPeriodic)
{
    std::vector<double> values;
    for (int k = knots.Lower(); k <= knots.Upper(); ++k)
        values.insert(values.end(), static_cast<size_t>(multiplicities(k)), knots(k));
    const auto order = static_cast<size_t>(degree + 1);
    if (wasPeriodic && values.size() >= 2 * order) {
        if (values[1] == values[order - 1])
            values.front() = values[1];
        const size_t last = values.size() - 1;
        if (values[last - 1] == values[last - (order - 1)])
            values.back() = values[last - 1];
    }
    return KnotVector::create(degree, std::move(values));
}

Result<ConvertedSurface> fromSpline(const Handle(Geom_BSplineSurface) & original, ParameterRange range)
{
    auto spline = Handle(Geom_BSplineSurface)::DownCast(original->Copy());
    try {
        cutToRange(spline, range);
    } catch (const Standard_Failure&) {  // knots that are not clamped cannot be cut: the whole surface then
        spline = Handle(Geom_BSplineSurface)::DownCast(original->Copy());
        spline->Bounds(range.startU, range.endU, range.startV, range.endV);
        cutToRange(spline, range);
    }
    auto knotsU =
        knotVector(spline->UDegree(), spline->UKnots(), spline->UMultiplicities(), original->IsUPeriodic());
    if (!knotsU)
        return tl::unexpected(knotsU.error());
    auto knotsV =
        knotVector(spline->VDegree(), spline->VKnots(), spline->VMultiplicities(), original->IsVPeriodic());
    if (!knotsV)
        return tl::unexpected(knotsV.error());
    const ParameterMap u{ParameterMap::Kind::shift, range.startU, range.endU, knotsU->domainStart()};
    const ParameterMap v{ParameterMap::Kind::shift, range.startV, range.endV, knotsV->domainStart()};
    // Where there are no weights, OpenCASCADE may answer 0.
    const bool rational = spline->IsURational() || spline->IsVRational();
    std::vector<ControlPoint> points;
    for (int i = 1; i <= spline->NbUPoles(); ++i) {
        for (int j = 1; j <= spline->NbVPoles(); ++j) {
            const gp_Pnt pole = spline->Pole(i, j);
            points.push_back({{pole.X(), pole.Y(), pole.Z()}, rational ? spline->Weight(i, j) : 1.0});
        }
    }
    auto surface = NurbsSurface::create(std::move(*knotsU), std::move(*knotsV), std::move(points));
    if (!surface)
        return tl::unexpected(surface.error());
    return ConvertedSurface{std::move(*surface), u, v, {}};
}

// Cylinders, cones, spheres and tori are turned meridians; u of a left-handed one turns the other way.
Result<ConvertedSurface> fromRound(const Handle(Geom_ElementarySurface) & round, const ParameterRange& range)
{
    const gp_Ax3& place = round->Position();
    const gp_Ax1 axis = place.Direct() ? place.Axis() : place.Axis().Reversed();
    return revolved(toNurbs(round->UIso(0.0), range.startV, range.endV), axis, range.startU, range.endU);
}

Result<ConvertedSurface> fromPlane(const Handle(Geom_Plane) & plane, const ParameterRange& range)
{
    const gp_Vec along(plane->Position().YDirection());
    const ConvertedCurve line = toNurbs(plane->VIso(0.0), range.startU, range.endU);
    return extruded(line, along, range.startV, range.endV);
}

Result<ConvertedSurface> approximated(const Handle(Geom_Surface) & surface, const ParameterRange& range,
                                      double tolerance)
{
    const Handle(Geom_BSplineSurface) spline = ShapeConstruct::ConvertSurfaceToBSpline(
        surface, range.startU, range.endU, range.startV, range.endV, tolerance, GeomAbs_C1, 1000, 8);
    if (spline.IsNull())
        return failure("A surface could not be approximated by a B-spline surface");
    auto result = fromSpline(spline, range);
    if (result)
        result->approximated = true;
    return result;
}

Result<ConvertedSurface> convert(const Handle(Geom_Surface) & surface, const ParameterRange& range,
                                 double tolerance)
{
    if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface); !trimmed.IsNull())
        return convert(trimmed->BasisSurface(), range, tolerance);
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface); !spline.IsNull())
        return fromSpline(spline, range);
    if (surface->IsKind(STANDARD_TYPE(Geom_BezierSurface)))
        return fromSpline(GeomConvert::SurfaceToBSplineSurface(surface), range);
    if (const auto plane = Handle(Geom_Plane)::DownCast(surface); !plane.IsNull())
        return fromPlane(plane, range);
    if (const auto round = Handle(Geom_ElementarySurface)::DownCast(surface); !round.IsNull())
        return fromRound(round, range);
    if (const auto turned = Handle(Geom_SurfaceOfRevolution)::DownCast(surface); !turned.IsNull())
        return revolved(toNurbs(turned->BasisCurve(), range.startV, range.endV), turned->Axis(), range.startU,
                        range.endU);
    if (const auto swept = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface); !swept.IsNull())
        return extruded(toNurbs(swept->BasisCurve(), range.startU, range.endU), gp_Vec(swept->Direction()),
                        range.startV, range.endV);
    if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface);
        !offset.IsNull() && !offset->Surface().IsNull() &&
        !offset->Surface()->IsKind(STANDARD_TYPE(Geom_OffsetSurface)))
        return convert(offset->Surface(), range, tolerance);  // the offset of a cylinder is a cylinder
    return approximated(surface, range, tolerance);
}

// The largest distance between the two surfaces where the maps say that they are the same point.
double largestDifference(const Handle(Geom_Surface) & surface, const ConvertedSurface& converted)
{
    double largest = 0;
    const int steps = converted.approximated ? 24 : 6;
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; j <= steps; ++j) {
            const double u = converted.u.start + (converted.u.end - converted.u.start) * i / steps;
            const double v = converted.v.start + (converted.v.end - converted.v.start) * j / steps;
            const gp_Pnt theirs = surface->Value(u, v);
            const Vec3 ours = evaluate(converted.surface, converted.u(u), converted.v(v)).position;
            largest = std::max(largest, glm::length(ours - Vec3(theirs.X(), theirs.Y(), theirs.Z())));
        }
    }
    return largest;
}

// u runs the other way, so the normal turns over.
Result<NurbsSurface> withReversedU(const NurbsSurface& surface)
{
    const double sum = surface.knotsU().domainStart() + surface.knotsU().domainEnd();
    std::vector<double> knots = surface.knotsU().values();
    std::reverse(knots.begin(), knots.end());
    for (double& knot : knots)
        knot = knot == surface.knotsU().domainStart() ? surface.knotsU().domainEnd()
               : knot == surface.knotsU().domainEnd() ? surface.knotsU().domainStart()
                                                      : sum - knot;
    std::vector<ControlPoint> points;
    for (int i = surface.countU() - 1; i >= 0; --i)
        for (int j = 0; j < surface.countV(); ++j)
            points.push_back(surface.controlPoint(i, j));
    auto reversed = KnotVector::create(surface.degreeU(), std::move(knots));
    if (!reversed)
        return tl::unexpected(reversed.error());
    return NurbsSurface::create(std::move(*reversed), surface.knotsV(), std::move(points));
}

Result<ParameterRange> rangeOf(const TopoDS_Face& face, const Handle(Geom_Surface) & surface, Extent extent)
{
    ParameterRange range{};
    if (extent == Extent::whole && surface->IsKind(STANDARD_TYPE(Geom_BSplineSurface))) {
        surface->Bounds(range.startU, range.endU, range.startV, range.endV);
        return range;
    }
    BRepTools::UVBounds(face, range.startU, range.endU, range.startV, range.endV);
    double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
    surface->Bounds(u1, u2, v1, v2);
    range = {snapped(range.startU, u1, u2), snapped(range.endU, u1, u2), snapped(range.startV, v1, v2),
             snapped(range.endV, v1, v2)};
    // A whole turn is not a whole turn and a rounding error.
    if (surface->IsUPeriodic() && range.endU - range.startU > surface->UPeriod() * (1 - 1e-9))
        range.endU = range.startU + surface->UPeriod();
    if (surface->IsVPeriodic() && range.endV - range.startV > surface->VPeriod() * (1 - 1e-9))
        range.endV = range.startV + surface->VPeriod();
    for (const double bound : {range.startU, range.endU, range.startV, range.endV})
        if (!(std::abs(bound) < 1e50))
            return failure("The face has no boundary and its surface no end");
    if (!(range.startU < range.endU && range.startV < range.endV))
        return failure("The face has no area");
    return range;
}

// 1/10000 of the face's size.
double toleranceFor(const Handle(Geom_Surface) & surface, const ParameterRange& range)
{
    Box corners;
    for (const double u : {range.startU, range.endU}) {
        for (const double v : {range.startV, (range.startV + range.endV) / 2, range.endV}) {
            const gp_Pnt point = surface->Value(u, v);
            corners.add({point.X(), point.Y(), point.Z()});
        }
    }
    return std::max(1e-4 * corners.diagonal(), 1e-9);
}

}  // namespace

Result<ConvertedSurface> toNurbs(const Handle(Geom_Surface) & surface, const ParameterRange& range,
                                 double tolerance)
{
    auto converted = convert(surface, range, tolerance);
    if (!converted)
        return converted;
    const Box& box = converted->surface.bounds();
    const double rounding = 1e-12 * std::max(glm::length(box.low), glm::length(box.high));
    const double allowed = converted->approximated ? 2 * tolerance : 1e-7 * box.diagonal() + rounding;
    converted->original = surface;
    converted->difference = largestDifference(surface, *converted);
    converted->mapsHold = converted->difference <= allowed;
    return converted;
}

Result<ConvertedSurface> toNurbs(const TopoDS_Face& face, Extent extent)
{
    Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    if (surface.IsNull())
        return failure("The face has no surface");
    auto range = rangeOf(face, surface, extent);
    if (!range)
        return tl::unexpected(range.error());
    if (const auto plane = Handle(Geom_Plane)::DownCast(surface); !plane.IsNull()) {
        if (const auto aligned = alignedPlane(face, plane)) {
            surface = aligned->plane;
            range = aligned->range;
        }
    }
    auto converted = toNurbs(surface, *range, toleranceFor(surface, *range));
    if (!converted || face.Orientation() != TopAbs_REVERSED)
        return converted;
    auto reversed = withReversedU(converted->surface);
    if (!reversed)
        return tl::unexpected(reversed.error());
    converted->surface = std::move(*reversed);
    converted->u.backwards = true;
    return converted;
}

}  // namespace knotspan::occt
