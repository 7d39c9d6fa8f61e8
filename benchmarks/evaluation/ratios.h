// After the benchmarks: how many times faster ours is than each peer, case by case and in the median.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace knotspan::benchmarks {

class RatioReporter : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override;
    void Finalize() override;

private:
    // Nanoseconds of processor time: who -> case -> time.
    std::map<std::string, std::map<std::string, double>> times_;
};

}  // namespace knotspan::benchmarks
