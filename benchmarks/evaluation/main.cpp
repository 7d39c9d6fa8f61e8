// Grids of points with both tangents: Knotspan's evaluation beside OpenCASCADE's and, where asked for,
// SISL's.
#include "benchmarks/evaluation/cases.h"
#include "benchmarks/evaluation/ratios.h"

int main(int argc, char** argv)
{
    using namespace knotspan::benchmarks;
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    addCeiling();
    // Peers of one case run one after another, so that what else the machine does strikes all of them.
    for (const Case& one : cases()) {
        addOurs(one);
#ifdef KNOTSPAN_SISL
        addSisl(one);
#endif
        addOcct(one);
    }
    RatioReporter reporter;
    return benchmark::RunSpecifiedBenchmarks(&reporter) > 0 ? 0 : 1;
}
