#include "benchmarks/evaluation/ratios.h"

#include <algorithm>
#include <cstdio>

#include "benchmarks/evaluation/cases.h"
#include "model/core/spread.h"

namespace knotspan::benchmarks {

namespace {

bool isPeer(const std::string& who)
{
    return who.rfind("SISL", 0) == 0 || who.rfind("OCCT", 0) == 0;
}

}  // namespace

void RatioReporter::ReportRuns(const std::vector<Run>& runs)
{
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
        const std::string name = run.benchmark_name();
        const size_t colon = name.find(": ");
        // With repetitions the best of them counts: what else ran on the machine only adds.
        if (colon == std::string::npos || run.run_type != Run::RT_Iteration || run.iterations == 0)
            continue;
        const double time = run.cpu_accumulated_time / static_cast<double>(run.iterations);
        const auto [at, isNew] = times_[name.substr(0, colon)].emplace(name.substr(colon + 2), time);
        at->second = std::min(at->second, time);
    }
}

void RatioReporter::Finalize()
{
    for (const auto& [ours, times] : times_) {
        if (isPeer(ours) || ours.rfind("fill", 0) == 0)
            continue;
        for (const auto& [peer, peerTimes] : times_) {
            if (!isPeer(peer))
                continue;
            std::vector<double> ratios;
            for (const auto& [name, time] : times)
                if (const auto found = peerTimes.find(name); found != peerTimes.end())
                    ratios.push_back(found->second / time);
            if (ratios.empty())
                continue;
            const size_t count = ratios.size();
            const Spread spread = spreadOf(std::move(ratios));
            std::printf(
                "%-34s against %-28s: least %5.1f, median %5.1f, most %5.1f times as fast (%zu cases)\n",
                ours.c_str(), peer.c_str(), spread.min, spread.median, spread.max, count);
        }
    }
    std::printf("\n%-36s", "million points a second");
    for (const auto& [who, times] : times_)
        std::printf(" | %s", who.c_str());
    std::printf("\n");
    for (const Case& one : cases()) {
        std::printf("%-36s", one.name.c_str());
        for (const auto& [who, times] : times_) {
            const auto found = times.find(one.name);
            std::printf(" | %*.1f", static_cast<int>(who.size()),
                        found == times.end() ? 0.0 : one.points() / found->second * 1e-6);
        }
        std::printf("\n");
    }
}

}  // namespace knotspan::benchmarks
