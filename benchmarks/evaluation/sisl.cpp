#include <memory>

extern "C" {
#include <sisl.h>
}

#include "benchmarks/evaluation/cases.h"

namespace knotspan::benchmarks {

namespace {

struct Free {
    void operator()(SISLSurf* surface) const { freeSurf(surface); }
};
using Surface = std::unique_ptr<SISLSurf, Free>;

Surface surfaceOf(const NurbsSurface& of)
{
    std::vector<double> knotsU = of.knotsU().values();
    std::vector<double> knotsV = of.knotsV().values();
    std::vector<double> points;
    // SISL counts u first.
    for (int j = 0; j < of.countV(); ++j)
        for (int i = 0; i < of.countU(); ++i) {
            const Vec4 h = of.controlPoint(i, j).homogeneous();
            points.insert(points.end(), {h.x, h.y, h.z});
            if (of.isRational())
                points.push_back(h.w);
        }
    return Surface(newSurf(of.countU(), of.countV(), of.degreeU() + 1, of.degreeV() + 1, knotsU.data(),
                           knotsV.data(), points.data(), of.isRational() ? 2 : 1, 3, 1));
}

std::vector<Surface> surfacesOf(const Case& what)
{
    std::vector<Surface> surfaces;
    for (const NurbsSurface& surface : what.surfaces)
        surfaces.push_back(surfaceOf(surface));
    return surfaces;
}

}  // namespace

void addSisl(const Case& what)
{
    add("SISL s1506", what, [&what](benchmark::State& state) {
        const auto surfaces = surfacesOf(what);
        std::vector<double> parameters = what.parameters;
        const int side = static_cast<int>(parameters.size());
        std::vector<double> results(parameters.size() * parameters.size() * 9);
        std::vector<double> normals(parameters.size() * parameters.size() * 3);
        int status = 0;
        for ([[maybe_unused]] auto _ : state)
            for (const Surface& surface : surfaces)
                s1506(surface.get(), 1, side, parameters.data(), side, parameters.data(), results.data(),
                      normals.data(), &status);
        if (status < 0)
            state.SkipWithError("s1506 failed");
        benchmark::DoNotOptimize(results.data());
    });
    add("SISL s1421", what, [&what](benchmark::State& state) {
        const auto surfaces = surfacesOf(what);
        double result[9];
        double normal[3];
        int status = 0;
        for ([[maybe_unused]] auto _ : state)
            for (const Surface& surface : surfaces) {
                int left = 0;
                int right = 0;
                for (double u : what.parameters)
                    for (double v : what.parameters) {
                        double at[2]{u, v};
                        s1421(surface.get(), 1, at, &left, &right, result, normal, &status);
                    }
            }
        if (status < 0)
            state.SkipWithError("s1421 failed");
        benchmark::DoNotOptimize(result);
    });
}

}  // namespace knotspan::benchmarks
