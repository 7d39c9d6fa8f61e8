// What culling is worth in frames: path x culling x sample over an orbit, at rest and deforming, in one run.
#include <algorithm>
#include <cstdio>

#include "benchmarks/frames/arguments.h"
#include "benchmarks/frames/report.h"

using namespace knotspan;
using namespace knotspan::benchmarks;

namespace {

constexpr int kFailed = 1;

std::vector<OrbitRow> measureAll(OrbitBenchmark& benchmark)
{
    const OrbitRequest& request = benchmark.request();
    std::vector<OrbitRow> rows;
    for (const std::string& sample : request.samples)
        for (const Deformation motion : request.motions)
            for (const PathId path : request.paths) {
                std::fprintf(stderr, "%s by %s\n", sample.c_str(), pathInfo(path).name.c_str());
                for (OrbitRow& row : benchmark.measure(sample, path, motion))
                    rows.push_back(std::move(row));
            }
    return rows;
}

}  // namespace

int main(int argc, char** argv)
{
    int exitCode = 0;
    auto arguments = parseArguments(argc, argv, exitCode);
    if (!arguments)
        return exitCode;
    auto benchmark = OrbitBenchmark::open(std::move(arguments->orbit));
    if (!benchmark) {
        std::fprintf(stderr, "%s\n", benchmark.error().sentence().c_str());
        return kFailed;
    }
    const std::vector<OrbitRow> rows = measureAll(*benchmark);
    const auto report = arguments->json ? jsonOf : tableOf;
    std::fputs(report(benchmark->deviceName(), benchmark->request(), rows).c_str(), stdout);
    const auto failed = [](const OrbitRow& row) { return row.failed; };
    return std::any_of(rows.begin(), rows.end(), failed) ? kFailed : 0;
}
