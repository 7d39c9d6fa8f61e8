#include "benchmarks/evaluation/cases.h"

#include <cmath>
#include <random>

namespace knotspan::benchmarks {

namespace {

NurbsSurface bumpySheet(int degree, int count, bool rational)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> jitter(-0.4, 0.4);
    const KnotVector knots = KnotVector::clampedUniform(degree, count - degree);
    std::vector<ControlPoint> points;
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j) {
            const Vec3 position(i + jitter(random), j + jitter(random), 2 * jitter(random));
            points.push_back({position, rational ? std::exp(jitter(random)) : 1.0});
        }
    return NurbsSurface::create(knots, knots, points).value();
}

std::vector<Case> makeCases()
{
    struct Kind {
        const char* name;
        int degree;
        int count;
        size_t surfaces;
    };
    constexpr Kind kKinds[]{{"10x10 degree 3", 3, 10, 1},
                            {"nine 4x4 Beziers", 3, 4, 9},
                            {"50x50 degree 3", 3, 50, 1},
                            {"20x20 degree 5", 5, 20, 1},
                            {"20x20 degree 9", 9, 20, 1}};
    std::vector<Case> all;
    for (const Kind& kind : kKinds)
        for (const bool rational : {false, true})
            for (const int side : {65, 257}) {
                Case one;
                one.name = std::string(kind.name) + (rational ? ", rational, " : ", polynomial, ") +
                           std::to_string(side) + "^2";
                one.surfaces.assign(kind.surfaces, bumpySheet(kind.degree, kind.count, rational));
                for (int k = 0; k < side; ++k)
                    one.parameters.push_back(static_cast<double>(k) / (side - 1));
                all.push_back(std::move(one));
            }
    return all;
}

}  // namespace

const std::vector<Case>& cases()
{
    static const std::vector<Case> all = makeCases();
    return all;
}

void add(const std::string& who, const Case& what, std::function<void(benchmark::State&)> body)
{
    benchmark::RegisterBenchmark(
        (who + ": " + what.name).c_str(), [body = std::move(body), &what](auto& state) {
            body(state);
            state.counters["points"] =
                benchmark::Counter(what.points(), benchmark::Counter::kIsIterationInvariantRate);
        });
}

}  // namespace knotspan::benchmarks
