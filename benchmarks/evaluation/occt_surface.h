// Our surfaces as OpenCASCADE's, for what is measured beside ours.
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "model/geometry/nurbs_surface.h"

namespace knotspan::benchmarks {

struct OcctKnots {
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger multiplicities;
};

inline OcctKnots occtKnots(const KnotVector& knots)
{
    std::vector<double> values;
    std::vector<int> multiplicities;
    for (const double knot : knots.values())
        if (!values.empty() && values.back() == knot)
            ++multiplicities.back();
        else {
            values.push_back(knot);
            multiplicities.push_back(1);
        }
    const int count = static_cast<int>(values.size());
    OcctKnots result{TColStd_Array1OfReal(1, count), TColStd_Array1OfInteger(1, count)};
    for (int k = 0; k < count; ++k) {
        result.values.SetValue(k + 1, values[static_cast<size_t>(k)]);
        result.multiplicities.SetValue(k + 1, multiplicities[static_cast<size_t>(k)]);
    }
    return result;
}

inline Handle(Geom_BSplineSurface) occtSurface(const NurbsSurface& surface)
{
    TColgp_Array2OfPnt poles(1, surface.countU(), 1, surface.countV());
    TColStd_Array2OfReal weights(1, surface.countU(), 1, surface.countV());
    for (int i = 0; i < surface.countU(); ++i)
        for (int j = 0; j < surface.countV(); ++j) {
            const ControlPoint& point = surface.controlPoint(i, j);
            poles.SetValue(i + 1, j + 1, {point.position.x, point.position.y, point.position.z});
            weights.SetValue(i + 1, j + 1, point.weight);
        }
    const OcctKnots u = occtKnots(surface.knotsU());
    const OcctKnots v = occtKnots(surface.knotsV());
    return new Geom_BSplineSurface(poles, weights, u.values, v.values, u.multiplicities, v.multiplicities,
                                   surface.degreeU(), surface.degreeV());
}

}  // namespace knotspan::benchmarks
