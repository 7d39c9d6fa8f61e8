#include "model/cad/occt_revolution.h"

#include <cmath>

#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <glm/geometric.hpp>

namespace knotspan::occt {
namespace {

Vec3 toVec3(const gp_XYZ& xyz)
{
    return {xyz.X(), xyz.Y(), xyz.Z()};
}

// Degree 2 knots with `spans` equal steps, each interior one twice.
std::vector<double> arcKnots(double start, double end, int spans)
{
    std::vector<double> knots(3, start);
    for (int k = 1; k < spans; ++k)
        knots.insert(knots.end(), 2, start + (end - start) * k / spans);
    knots.insert(knots.end(), 3, end);
    return knots;
}

// The directions of an arc's 2 * spans + 1 control points: (cos, sin, weight), the first two divided by the
// weight. The NURBS Book, 7.3.
std::vector<Vec3> arcPoints(double start, double end, int spans)
{
    std::vector<Vec3> points;
    const double half = (end - start) / (2.0 * spans);
    for (int k = 0; k <= 2 * spans; ++k) {
        const double angle = start + half * k;
        const double weight = k % 2 == 0 ? 1.0 : std::cos(half);
        points.emplace_back(std::cos(angle) / weight, std::sin(angle) / weight, weight);
    }
    return points;
}

ConvertedCurve conic(const gp_Ax2& axes, double majorRadius, double minorRadius, double start, double end)
{
    const int spans = arcSpans(end - start);
    ConvertedCurve curve{2, arcKnots(start, end, spans), {}, {}, false};
    curve.map = {ParameterMap::Kind::angle, start, end, start, spans};
    const Vec3 centre = toVec3(axes.Location().XYZ());
    const Vec3 x = toVec3(axes.XDirection().XYZ()) * majorRadius;
    const Vec3 y = toVec3(axes.YDirection().XYZ()) * minorRadius;
    for (const Vec3& point : arcPoints(start, end, spans))
        curve.points.push_back({centre + x * point.x + y * point.y, point.z});
    return curve;
}

ConvertedCurve bspline(const Handle(Geom_Curve) & curve, double start, double end)
{
    const Handle(Geom_BSplineCurve) copy = Handle(Geom_BSplineCurve)::DownCast(curve->Copy());
    const double tolerance = 1e-9 * (copy->LastParameter() - copy->FirstParameter());
    if (std::abs(start - copy->FirstParameter()) > tolerance ||
        std::abs(end - copy->LastParameter()) > tolerance)
        copy->Segment(start, end);
    copy->SetNotPeriodic();
    ConvertedCurve result;
    result.degree = copy->Degree();
    for (int k = 1; k <= copy->NbKnots(); ++k)
        result.knots.insert(result.knots.end(), static_cast<size_t>(copy->Multiplicity(k)), copy->Knot(k));
    for (int k = 1; k <= copy->NbPoles(); ++k)
        result.points.push_back({toVec3(copy->Pole(k).XYZ()), copy->Weight(k)});
    result.map = {ParameterMap::Kind::shift, start, end, copy->FirstParameter()};
    return result;
}

Result<NurbsSurface> makeSurface(int degreeU, std::vector<double> knotsU, int degreeV,
                                 std::vector<double> knotsV, std::vector<ControlPoint> points)
{
    auto u = KnotVector::create(degreeU, std::move(knotsU));
    if (!u)
        return tl::unexpected(u.error());
    auto v = KnotVector::create(degreeV, std::move(knotsV));
    if (!v)
        return tl::unexpected(v.error());
    return NurbsSurface::create(std::move(*u), std::move(*v), std::move(points));
}

}  // namespace

int arcSpans(double angle)
{
    return static_cast<int>(1.2 * angle / M_PI) + 1;
}

ConvertedCurve toNurbs(const Handle(Geom_Curve) & curve, double start, double end)
{
    if (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve); !trimmed.IsNull())
        return toNurbs(trimmed->BasisCurve(), start, end);
    if (const auto line = Handle(Geom_Line)::DownCast(curve); !line.IsNull())
        return {1,
                {start, start, end, end},
                {{toVec3(line->Value(start).XYZ())}, {toVec3(line->Value(end).XYZ())}},
                {ParameterMap::Kind::shift, start, end, start},
                false};
    if (const auto circle = Handle(Geom_Circle)::DownCast(curve); !circle.IsNull())
        return conic(circle->Position(), circle->Radius(), circle->Radius(), start, end);
    if (const auto ellipse = Handle(Geom_Ellipse)::DownCast(curve); !ellipse.IsNull())
        return conic(ellipse->Position(), ellipse->MajorRadius(), ellipse->MinorRadius(), start, end);
    if (curve->IsKind(STANDARD_TYPE(Geom_BSplineCurve)))
        return bspline(curve, start, end);
    const Handle(Geom_TrimmedCurve) part = new Geom_TrimmedCurve(curve, start, end);
    ConvertedCurve result = bspline(GeomConvert::CurveToBSplineCurve(part), start, end);
    result.approximated = curve->IsKind(STANDARD_TYPE(Geom_OffsetCurve));
    return result;
}

Result<ConvertedSurface> revolved(const ConvertedCurve& meridian, const gp_Ax1& axis, double startAngle,
                                  double endAngle)
{
    const int spans = arcSpans(endAngle - startAngle);
    const Vec3 origin = toVec3(axis.Location().XYZ());
    const Vec3 z = toVec3(axis.Direction().XYZ());
    std::vector<ControlPoint> points;
    for (const Vec3& arc : arcPoints(startAngle, endAngle, spans)) {
        for (const ControlPoint& point : meridian.points) {
            const Vec3 offset = point.position - origin;
            const Vec3 foot = origin + z * glm::dot(offset, z);
            Vec3 x = point.position - foot;
            // A pole: rounding must not turn the point into a tiny circle.
            if (glm::length(x) < 1e-14 * (glm::length(offset) + glm::length(origin)))
                x = Vec3(0.0);
            points.push_back({foot + x * arc.x + glm::cross(z, x) * arc.y, point.weight * arc.z});
        }
    }
    auto surface = makeSurface(2, arcKnots(startAngle, endAngle, spans), meridian.degree, meridian.knots,
                               std::move(points));
    if (!surface)
        return tl::unexpected(surface.error());
    const ParameterMap u{ParameterMap::Kind::angle, startAngle, endAngle, startAngle, spans};
    return ConvertedSurface{std::move(*surface), u, meridian.map, {}, meridian.approximated};
}

Result<ConvertedSurface> extruded(const ConvertedCurve& curve, const gp_Vec& direction, double startV,
                                  double endV)
{
    const Vec3 along = toVec3(direction.XYZ());
    std::vector<ControlPoint> points;
    for (const ControlPoint& point : curve.points)
        for (const double v : {startV, endV})
            points.push_back({point.position + along * v, point.weight});
    auto surface = makeSurface(curve.degree, curve.knots, 1, {startV, startV, endV, endV}, std::move(points));
    if (!surface)
        return tl::unexpected(surface.error());
    const ParameterMap v{ParameterMap::Kind::shift, startV, endV, startV};
    return ConvertedSurface{std::move(*surface), curve.map, v, {}, curve.approximated};
}

}  // namespace knotspan::occt
