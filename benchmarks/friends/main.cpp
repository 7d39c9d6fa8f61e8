// What it takes to find where surfaces meet and how smoothly, on one core: whole models, and after one
// control point of `knot` moved.
#include <benchmark/benchmark.h>

#include <cmath>

#include "model/friends/friends.h"
#include "model/samples/net.h"
#include "model/samples/sample_list.h"

namespace knotspan {
namespace {

std::vector<PlacedSurface> placed(const Scene& scene)
{
    std::vector<PlacedSurface> result;
    for (const auto& [id, object] : scene.objects())
        result.push_back({&object->surface, object->transform});
    return result;
}

void wholeKnot(benchmark::State& state)
{
    const Scene scene = findSample("knot")->make();
    const std::vector<PlacedSurface> surfaces = placed(scene);
    for (auto _ : state)
        benchmark::DoNotOptimize(Friends(surfaces).edges().data());
}
BENCHMARK(wholeKnot)->Unit(benchmark::kMillisecond);

// A corner of a surface, so that two of its edges and all that meets them are looked at again.
void onePointOfKnot(benchmark::State& state)
{
    const Scene scene = findSample("knot")->make();
    const std::vector<PlacedSurface> surfaces = placed(scene);
    Friends friends(surfaces);
    const NurbsSurface& surface = *surfaces[100].surface;
    std::vector<ControlPoint> points = surface.controlPoints();
    points[0].position += Vec3(0.05, 0.02, 0.03);
    const NurbsSurface moved = NurbsSurface::create(surface.knotsU(), surface.knotsV(), points).value();
    bool back = false;
    for (auto _ : state) {
        friends.update({{100, {back ? &surface : &moved, surfaces[100].transform}}});
        back = !back;
    }
}
BENCHMARK(onePointOfKnot)->Unit(benchmark::kMillisecond);

// count x count bicubic surfaces of 2 x 2 spans, 4 count^2 edges.
void field(benchmark::State& state)
{
    const auto count = static_cast<int>(state.range(0));
    const KnotVector knots = clampedIntegerKnots(3, 2);
    std::vector<NurbsSurface> surfaces;
    for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b)
            surfaces.push_back(surfaceOf(knots, knots, [&](int i, int j) -> ControlPoint {
                const double x = a + grevilleAbscissa(knots, i) / 2;
                const double y = b + grevilleAbscissa(knots, j) / 2;
                return {{x, y, std::sin(x) * std::cos(1.3 * y)}, 1};
            }));
    std::vector<PlacedSurface> all;
    for (const NurbsSurface& surface : surfaces)
        all.push_back({&surface});
    for (auto _ : state)
        benchmark::DoNotOptimize(Friends(all).edges().data());
}
BENCHMARK(field)->Arg(10)->Arg(50)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace knotspan

BENCHMARK_MAIN();
