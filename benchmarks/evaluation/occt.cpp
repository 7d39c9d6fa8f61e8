#include <GeomAdaptor_Surface.hxx>

#include "benchmarks/evaluation/cases.h"
#include "benchmarks/evaluation/occt_surface.h"

namespace knotspan::benchmarks {

namespace {

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
            surfaces.push_back(occtSurface(surface));
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
