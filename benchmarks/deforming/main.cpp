// What the CPU does in a frame in which every control point of `knot` moved, part by part: what the path
// `bezier` takes over from the model, without the device.
#include <benchmark/benchmark.h>

#include "model/samples/sample_list.h"
#include "model/scene/deformation.h"
#include "renderer/scene/bezier_nets.h"
#include "renderer/scene/shared_edges.h"

namespace knotspan {
namespace {

std::vector<Resident> knotAt(int frame)
{
    return makeResidents(visibleObjects(deformed(findSample("knot")->make(), Deformation::all, frame)));
}

void decompose(benchmark::State& state)
{
    const std::vector<Resident> residents = knotAt(5);
    const BezierNets nets(residents);
    std::vector<glm::vec4> points(nets.pointCount());
    for (auto _ : state) {
        nets.make(residents, 0, residents.size(), points);
        benchmark::DoNotOptimize(points.data());
    }
}
BENCHMARK(decompose)->Unit(benchmark::kMillisecond)->UseRealTime();

// What any path sends where the control points travel and not the wave.
void packSurfaces(benchmark::State& state)
{
    const std::vector<Resident> residents = knotAt(5);
    for (auto _ : state)
        for (const Resident& resident : residents)
            benchmark::DoNotOptimize(
                packPoints<float>(resident.frame, resident.object->surface.controlPoints()));
}
BENCHMARK(packSurfaces)->Unit(benchmark::kMillisecond)->UseRealTime();

void makeSurfaceRecords(benchmark::State& state)
{
    const std::vector<Resident> residents = knotAt(5);
    for (auto _ : state)
        for (const Resident& resident : residents)
            benchmark::DoNotOptimize(surfaceRecordOf(resident));
}
BENCHMARK(makeSurfaceRecords)->Unit(benchmark::kMillisecond)->UseRealTime();

// Who lies along which border, anew.
void findSharedEdges(benchmark::State& state)
{
    const std::vector<Resident> frames[] = {knotAt(0), knotAt(5)};
    const std::vector<PlacedSurface> placed[] = {placedSurfaces(frames[0]), placedSurfaces(frames[1])};
    SharedEdges edges(placed[0]);
    size_t next = 1;
    for (auto _ : state) {
        std::vector<CoincidentEdges::Change> changes;
        for (std::uint32_t k = 0; k < placed[next].size(); ++k)
            changes.push_back({k, placed[next][k]});
        benchmark::DoNotOptimize(edges.update(changes));
        next = 1 - next;
    }
}
BENCHMARK(findSharedEdges)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace knotspan

BENCHMARK_MAIN();
