#include "model/cad/occt_spline.h"

#include <algorithm>
#include <cmath>

#include <Standard_Failure.hxx>

namespace knotspan::occt {
namespace {

// Beyond that OpenCASCADE takes a number for infinite, and its writers have no room for the digits.
constexpr double kLargest = 1e50;
constexpr double kSmallest = 1e-90;

// OpenCASCADE's way to say knots: each value once.
struct DistinctKnots {
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger multiplicities;
};

DistinctKnots distinct(const KnotVector& knots)
{
    std::vector<double> values;
    std::vector<int> multiplicities;
    for (const double knot : knots.values()) {
        if (!values.empty() && knot - values.back() <= Epsilon(std::abs(values.back()))) {
            ++multiplicities.back();
            continue;
        }
        values.push_back(knot);
        multiplicities.push_back(1);
    }
    const int count = static_cast<int>(values.size());
    DistinctKnots result{TColStd_Array1OfReal(1, count), TColStd_Array1OfInteger(1, count)};
    for (int k = 1; k <= count; ++k) {
        result.values(k) = values[static_cast<size_t>(k - 1)];
        result.multiplicities(k) = multiplicities[static_cast<size_t>(k - 1)];
    }
    return result;
}

bool isWritable(const KnotVector& knots)
{
    return std::all_of(knots.values().begin(), knots.values().end(), [](double knot) {
        return knot == 0 || (std::abs(knot) > kSmallest && std::abs(knot) < kLargest);
    });
}

bool isWritableWeight(double weight)
{
    return weight > kSmallest && weight < kLargest;
}

auto tooExtreme(const std::string& what)
{
    return failure(what + " has numbers that OpenCASCADE cannot hold", "Save it as .knotspan instead");
}

}  // namespace

double withoutDust(double coordinate)
{
    return std::abs(coordinate) < kSmallest ? 0.0 : coordinate;
}

Result<Handle(Geom_BSplineSurface)> splineOf(const SceneObject& object, double scale)
{
    const NurbsSurface& surface = object.surface;
    TColgp_Array2OfPnt poles(1, surface.countU(), 1, surface.countV());
    TColStd_Array2OfReal weights(1, surface.countU(), 1, surface.countV());
    bool writable = true;
    for (int i = 0; i < surface.countU(); ++i) {
        for (int j = 0; j < surface.countV(); ++j) {
            const ControlPoint& point = surface.controlPoint(i, j);
            const Vec3 place = transformed(point.position, object.transform) * scale;
            for (int axis = 0; axis < 3; ++axis)
                if (!(std::abs(place[axis]) < kLargest))
                    return failure("The control points of \"" + object.name +
                                       "\" are too far away to be written",
                                   "Move the object nearer to the origin");
            poles(i + 1, j + 1) = gp_Pnt(withoutDust(place.x), withoutDust(place.y), withoutDust(place.z));
            weights(i + 1, j + 1) = surface.isRational() ? point.weight : 1.0;
            writable = writable && isWritableWeight(weights(i + 1, j + 1));
        }
    }
    if (!isWritable(surface.knotsU()) || !isWritable(surface.knotsV()) || !writable)
        return tooExtreme('"' + object.name + '"');
    const DistinctKnots u = distinct(surface.knotsU());
    const DistinctKnots v = distinct(surface.knotsV());
    try {
        return Handle(Geom_BSplineSurface)(new Geom_BSplineSurface(poles, weights, u.values, v.values,
                                                                   u.multiplicities, v.multiplicities,
                                                                   surface.degreeU(), surface.degreeV()));
    } catch (const Standard_Failure&) {
        return tooExtreme('"' + object.name + '"');
    }
}

Result<Handle(Geom2d_BSplineCurve)> splineOf(const TrimCurve& curve)
{
    const int count = static_cast<int>(curve.points().size());
    TColgp_Array1OfPnt2d poles(1, count);
    TColStd_Array1OfReal weights(1, count);
    bool writable = true;
    for (int k = 1; k <= count; ++k) {
        const TrimPoint& point = curve.points()[static_cast<size_t>(k - 1)];
        poles(k) = gp_Pnt2d(withoutDust(point.position.x), withoutDust(point.position.y));
        weights(k) = point.weight;
        writable = writable && isWritableWeight(point.weight);
    }
    if (!isWritable(curve.knots()) || !writable)
        return tooExtreme("A trim curve");
    const DistinctKnots knots = distinct(curve.knots());
    try {
        return Handle(Geom2d_BSplineCurve)(new Geom2d_BSplineCurve(
            poles, weights, knots.values, knots.multiplicities, curve.knots().degree()));
    } catch (const Standard_Failure&) {
        return tooExtreme("A trim curve");
    }
}

}  // namespace knotspan::occt
