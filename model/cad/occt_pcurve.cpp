#include "model/cad/occt_pcurve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <BRep_Tool.hxx>
#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_Plane.hxx>
#include <TopLoc_Location.hxx>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace knotspan::occt {
namespace {

constexpr double kFitTolerance = 1e-8;  // of the domain's size
constexpr int kDeepestSplit = 14;

struct Point {
    double t;
    Vec2 position;
    Vec2 derivative;
};

// The curve as a function of its parameter, in our (u, v).
class MappedCurve {
public:
    MappedCurve(Handle(Geom2d_Curve) curve, const ConvertedSurface& converted)
        : curve_(std::move(curve)),
          converted_(converted),
          domain_(converted.u.end - converted.u.start, converted.v.end - converted.v.start)
    {
    }

    [[nodiscard]] Point at(double t) const
    {
        gp_Pnt2d point;
        gp_Vec2d derivative;
        curve_->D1(t, point, derivative);
        return {t,
                {converted_.u(point.X()), converted_.v(point.Y())},
                {derivative.X() * converted_.u.derivative(point.X()),
                 derivative.Y() * converted_.v.derivative(point.Y())}};
    }

    // The cubic between two points with their tangents: its four control points.
    static std::array<Vec2, 4> cubic(const Point& a, const Point& b)
    {
        const double third = (b.t - a.t) / 3;
        return {a.position, a.position + a.derivative * third, b.position - b.derivative * third, b.position};
    }

    // Cubics that follow the curve, joined to `points` and `knots` (each interior knot three times).
    void fit(const Point& a, const Point& b, int depth, std::vector<TrimPoint>& points,
             std::vector<double>& knots) const
    {
        const auto c = cubic(a, b);
        double error = 0;
        for (const double s : {0.25, 0.5, 0.75}) {
            const double r = 1 - s;
            const Vec2 fitted =
                c[0] * (r * r * r) + c[1] * (3 * r * r * s) + c[2] * (3 * r * s * s) + c[3] * (s * s * s);
            const Vec2 difference = (fitted - at(a.t + (b.t - a.t) * s).position) / domain_;
            error = std::max(error, glm::length(difference));
        }
        if (depth < kDeepestSplit && (depth < 1 || error > kFitTolerance)) {
            const Point middle = at((a.t + b.t) / 2);
            fit(a, middle, depth + 1, points, knots);
            fit(middle, b, depth + 1, points, knots);
            return;
        }
        for (size_t k = 1; k < 4; ++k)
            points.push_back({c[k]});
        knots.insert(knots.end(), 3, b.t);
    }

private:
    Handle(Geom2d_Curve) curve_;
    const ConvertedSurface& converted_;
    Vec2 domain_;
};

Result<TrimCurve> makeCurve(int degree, std::vector<double> knots, std::vector<TrimPoint> points,
                            const NurbsSurface& surface)
{
    const Vec2 low(surface.knotsU().domainStart(), surface.knotsV().domainStart());
    const Vec2 high(surface.knotsU().domainEnd(), surface.knotsV().domainEnd());
    // Rounding, and control points of curves that bulge over the rim by less than a boundary's tolerance.
    const Vec2 rim = (high - low) * 1e-6;
    for (TrimPoint& point : points)
        for (int axis = 0; axis < 2; ++axis)
            if (point.position[axis] > low[axis] - rim[axis] && point.position[axis] < high[axis] + rim[axis])
                point.position[axis] = std::clamp(point.position[axis], low[axis], high[axis]);
    auto knotVector = KnotVector::create(degree, std::move(knots));
    if (!knotVector)
        return tl::unexpected(knotVector.error());
    return TrimCurve::create(std::move(*knotVector), std::move(points));
}

bool onlyShifts(const ConvertedSurface& converted)
{
    return converted.u.kind == ParameterMap::Kind::shift && converted.v.kind == ParameterMap::Kind::shift;
}

// A line stays one if it runs along a parameter or neither parameter bends.
bool staysStraight(const Handle(Geom2d_Curve) & curve, double first, double last,
                   const ConvertedSurface& converted)
{
    if (!curve->IsKind(STANDARD_TYPE(Geom2d_Line)))
        return false;
    const gp_Pnt2d a = curve->Value(first);
    const gp_Pnt2d b = curve->Value(last);
    return onlyShifts(converted) || std::abs(a.X() - b.X()) < 1e-9 * (converted.u.end - converted.u.start) ||
           std::abs(a.Y() - b.Y()) < 1e-9 * (converted.v.end - converted.v.start);
}

// Affine maps take control points to control points; weights stay.
Result<TrimCurve> shifted(const Handle(Geom2d_BSplineCurve) & spline, const ConvertedSurface& converted)
{
    const auto shift = [](const ParameterMap& map, double theirs) {
        const double ours = map.ourStart + (theirs - map.start);
        return map.backwards ? 2 * map.ourStart + (map.end - map.start) - ours : ours;
    };
    std::vector<double> knots;
    for (int k = 1; k <= spline->NbKnots(); ++k)
        knots.insert(knots.end(), static_cast<size_t>(spline->Multiplicity(k)), spline->Knot(k));
    std::vector<TrimPoint> points;
    for (int k = 1; k <= spline->NbPoles(); ++k) {
        const gp_Pnt2d pole = spline->Pole(k);
        points.push_back({{shift(converted.u, pole.X()), shift(converted.v, pole.Y())}, spline->Weight(k)});
    }
    return makeCurve(spline->Degree(), std::move(knots), std::move(points), converted.surface);
}

}  // namespace

Result<TrimCurve> toTrimCurve(const TopoDS_Edge& edge, const TopoDS_Face& face,
                              const ConvertedSurface& converted)
{
    double first = 0, last = 0;
    Handle(Geom2d_Curve) curve =
        converted.original->IsKind(STANDARD_TYPE(Geom_Plane))
            ? BRep_Tool::CurveOnPlane(edge, converted.original, TopLoc_Location(), first, last)
            : BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (curve.IsNull() || !(first < last))
        return failure("An edge has no curve on its face");
    while (curve->IsKind(STANDARD_TYPE(Geom2d_TrimmedCurve)))
        curve = Handle(Geom2d_TrimmedCurve)::DownCast(curve)->BasisCurve();
    if (edge.Orientation() == TopAbs_REVERSED) {
        const double reversedFirst = curve->ReversedParameter(last);
        last = curve->ReversedParameter(first);
        first = reversedFirst;
        curve = curve->Reversed();
    }
    const MappedCurve mapped(curve, converted);
    if (staysStraight(curve, first, last, converted))
        return makeCurve(1, {0, 0, 1, 1}, {{mapped.at(first).position}, {mapped.at(last).position}},
                         converted.surface);
    if (onlyShifts(converted)) {
        const Handle(Geom2d_TrimmedCurve) part = new Geom2d_TrimmedCurve(curve, first, last);
        const Handle(Geom2d_BSplineCurve) spline = Geom2dConvert::CurveToBSplineCurve(part);
        spline->SetNotPeriodic();
        return shifted(spline, converted);
    }
    const Point start = mapped.at(first);
    std::vector<TrimPoint> points{{start.position}};
    std::vector<double> knots(4, first);
    mapped.fit(start, mapped.at(last), 0, points, knots);
    knots.push_back(last);
    return makeCurve(3, std::move(knots), std::move(points), converted.surface);
}

}  // namespace knotspan::occt
