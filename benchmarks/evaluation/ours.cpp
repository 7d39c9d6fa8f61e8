#include <algorithm>
#include <new>

#include "benchmarks/evaluation/cases.h"
#include "benchmarks/evaluation/ceiling.h"
#include "model/geometry/grid_evaluation.h"

namespace knotspan::benchmarks {

namespace {

// One thread, the surface made ready before: what a frame costs while the surface stays the same.
template <class Real>
void addGrid(const std::string& who, const Case& what, SampleFields fields)
{
    add(who, what, [&what, fields](benchmark::State& state) {
        const auto u = spanParameters(what.surfaces[0].knotsU(), what.parameters);
        const auto v = spanParameters(what.surfaces[0].knotsV(), what.parameters);
        std::vector<GridEvaluator<Real>> evaluators;
        for (const NurbsSurface& surface : what.surfaces)
            evaluators.emplace_back(surface, fields);
        std::vector<GridSamples<Real>> samples(what.surfaces.size());
        for ([[maybe_unused]] auto _ : state)
            for (size_t k = 0; k < evaluators.size(); ++k)
                evaluators[k].evaluate(u, v, samples[k], Threads::one);
        benchmark::DoNotOptimize(samples.data());
    });
}

// The same with everything that a new surface needs.
void addFromNothing(const Case& what)
{
    add("double, new surface", what, [&what](benchmark::State& state) {
        std::vector<GridSamples<double>> samples(what.surfaces.size());
        for ([[maybe_unused]] auto _ : state)
            for (size_t k = 0; k < samples.size(); ++k) {
                const GridEvaluator<double> evaluator(what.surfaces[k], {1, false});
                const auto u = spanParameters(what.surfaces[k].knotsU(), what.parameters);
                const auto v = spanParameters(what.surfaces[k].knotsV(), what.parameters);
                evaluator.evaluate(u, v, samples[k], Threads::one);
            }
        benchmark::DoNotOptimize(samples.data());
    });
}

// The same points, some rows at a time into the same memory: what the arithmetic allows.
void addInCache(const Case& what)
{
    add("double, kept in the cache", what, [&what](benchmark::State& state) {
        constexpr size_t kRows = 48;  // of 257 columns just below a megabyte
        const auto u = spanParameters(what.surfaces[0].knotsU(), what.parameters);
        const auto v = spanParameters(what.surfaces[0].knotsV(), what.parameters);
        const GridEvaluator<double> evaluator(what.surfaces[0], {1, false});
        GridSamples<double> samples;
        for ([[maybe_unused]] auto _ : state)
            for (size_t k = 0; k < what.surfaces.size(); ++k)
                for (size_t row = 0; row < u.size(); row += kRows)
                    evaluator.evaluate(std::span(u).subspan(row, std::min(kRows, u.size() - row)), v, samples,
                                       Threads::one);
    });
}

// As many numbers written without computing any: what the memory allows.
void addFill(const Case& what)
{
    add("fill, 9 doubles a point", what, [&what](benchmark::State& state) {
        constexpr std::align_val_t kLine{64};
        const auto count = static_cast<size_t>(what.points()) * 9;
        auto* memory = new (kLine) double[count];
        double value = 0;
        for ([[maybe_unused]] auto _ : state) {
            value += 1;
            fillPastTheCache(memory, count, value);
            benchmark::ClobberMemory();
        }
        ::operator delete[](memory, kLine);
    });
}

}  // namespace

void addCeiling()
{
    benchmark::RegisterBenchmark("multiply-adds in registers", [](benchmark::State& state) {
        double sum = 0;
        double done = 0;
        volatile double factor = 0.5;
        for ([[maybe_unused]] auto _ : state)
            done += multiplyAdds(10000, factor, 0.25, sum);
        benchmark::DoNotOptimize(sum);
        state.counters["multiply-adds"] = benchmark::Counter(done, benchmark::Counter::kIsRate);
    });
}

void addOurs(const Case& what)
{
    addGrid<double>("double", what, {1, false});
    addFromNothing(what);
    addInCache(what);
    addGrid<float>("float, tangents and unit normals", what, {1, true});
    addGrid<float>("float, unit normals", what, {0, true});
    addFill(what);
}

}  // namespace knotspan::benchmarks
