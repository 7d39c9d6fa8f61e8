#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "benchmarks/evaluation/cases.h"

namespace knotspan::benchmarks {

namespace {

struct Knots {
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger multiplicities;
};

Knots knotsOf(const KnotVector& knots)
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
    Knots result{TColStd_Array1OfReal(1, count), TColStd_Array1OfInteger(1, count)};
    for (int k = 0; k < count; ++k) {
        result.values.SetValue(k + 1, values[static_cast<size_t>(k)]);
        result.multiplicities.SetValue(k + 1, multiplicities[static_cast<size_t>(k)]);
    }
    return result;
}

Handle(Geom_BSplineSurface) surfaceOf(const NurbsSurface& surface)
{
    TColgp_Array2OfPnt poles(1, surface.countU(), 1, surface.countV());
    TColStd_Array2OfReal weights(1, surface.countU(), 1, surface.countV());
    for (int i = 0; i < surface.countU(); ++i)
        for (int j = 0; j < surface.countV(); ++j) {
            const ControlPoint& point = surface.controlPoint(i, j);
            poles.SetValue(i + 1, j + 1, {point.position.x, point.position.y, point.position.z});
            weights.SetValue(i + 1, j + 1, point.weight);
        }
    const Knots u = knotsOf(surface.knotsU());
    const Knots v = knotsOf(surface.knotsV());
    return new Geom_BSplineSurface(poles, weights, u.values, v.values, u.multiplicities, v.multiplicities,
                                   surface.degreeU(), surface.degreeV());
}

// Position and both tangents of every point of the grid, kept as SISL keeps them.
template <class Surface>
void evaluateGrid(const Surface& surface, const std::vector<double>& parameters, std::vector<double>& results)
{
    double* to = results.data();
    for (const double u : parameters)
        for (const double v : parameters) {
            gp_Pnt position;
            gp_Vec du;
            gp_Vec dv;
            surface.D1(u, v, position, du, dv);
            for (int c = 1; c <= 3; ++c) {
                to[c - 1] = position.Coord(c);
                to[c + 2] = du.Coord(c);
                to[c + 5] = dv.Coord(c);
            }
            to += 9;
        }
}

void addSurface(const std::string& who, const Case& what, bool adapted)
{
    add(who, what, [&what, adapted](benchmark::State& state) {
        std::vector<Handle(Geom_BSplineSurface)> surfaces;
        std::vector<GeomAdaptor_Surface> adaptors;
        for (const NurbsSurface& surface : what.surfaces) {
            surfaces.push_back(surfaceOf(surface));
            adaptors.emplace_back(surfaces.back());
        }
        std::vector<double> results(what.parameters.size() * what.parameters.size() * 9);
        for ([[maybe_unused]] auto _ : state)
            for (size_t k = 0; k < surfaces.size(); ++k)
                adapted ? evaluateGrid(adaptors[k], what.parameters, results)
                        : evaluateGrid(*surfaces[k], what.parameters, results);
        benchmark::DoNotOptimize(results.data());
    });
}

}  // namespace

void addOcct(const Case& what)
{
    addSurface("OCCT Geom_BSplineSurface::D1", what, false);
    addSurface("OCCT GeomAdaptor_Surface::D1", what, true);
}

}  // namespace knotspan::benchmarks
