#include "benchmarks/evaluation/ceiling.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "benchmarks/evaluation/ceiling.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace knotspan::benchmarks::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Twelve sums side by side hide the latency of each. The factors keep them finite and are not known to the
// compiler.
double MultiplyAdds(size_t rounds, double factor, double term, double& sum)
{
    const hn::ScalableTag<double> d;
    const auto by = hn::Set(d, factor);
    const auto plus = hn::Set(d, term);
    // Different from the start, or the compiler would see that one sum is enough.
    auto a = hn::Set(d, 1.0);
    auto b = hn::Set(d, 2.0);
    auto c = hn::Set(d, 3.0);
    auto e = hn::Set(d, 4.0);
    auto f = hn::Set(d, 5.0);
    auto g = hn::Set(d, 6.0);
    auto h = hn::Set(d, 7.0);
    auto i = hn::Set(d, 8.0);
    auto j = hn::Set(d, 9.0);
    auto k = hn::Set(d, 10.0);
    auto l = hn::Set(d, 11.0);
    auto m = hn::Set(d, 12.0);
    for (size_t round = 0; round < rounds; ++round) {
        a = hn::MulAdd(a, by, plus);
        b = hn::MulAdd(b, by, plus);
        c = hn::MulAdd(c, by, plus);
        e = hn::MulAdd(e, by, plus);
        f = hn::MulAdd(f, by, plus);
        g = hn::MulAdd(g, by, plus);
        h = hn::MulAdd(h, by, plus);
        i = hn::MulAdd(i, by, plus);
        j = hn::MulAdd(j, by, plus);
        k = hn::MulAdd(k, by, plus);
        l = hn::MulAdd(l, by, plus);
        m = hn::MulAdd(m, by, plus);
    }
    const auto all =
        hn::Add(hn::Add(hn::Add(a, b), hn::Add(c, e)),
                hn::Add(hn::Add(hn::Add(f, g), hn::Add(h, i)), hn::Add(hn::Add(j, k), hn::Add(l, m))));
    sum += hn::GetLane(hn::SumOfLanes(d, all));
    return 12.0 * static_cast<double>(rounds * hn::Lanes(d));
}

void FillPastTheCache(double* memory, size_t count, double value)
{
    const hn::ScalableTag<double> d;
    for (size_t k = 0; k + hn::Lanes(d) <= count; k += hn::Lanes(d))
        hn::Stream(hn::Set(d, value), d, memory + k);
    hwy::FlushStream();
}

}  // namespace
}  // namespace knotspan::benchmarks::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace knotspan::benchmarks {

namespace {

HWY_EXPORT(MultiplyAdds);
HWY_EXPORT(FillPastTheCache);

}  // namespace

double multiplyAdds(size_t rounds, double factor, double term, double& sum)
{
    return HWY_DYNAMIC_DISPATCH(MultiplyAdds)(rounds, factor, term, sum);
}

void fillPastTheCache(double* memory, size_t count, double value)
{
    HWY_DYNAMIC_DISPATCH(FillPastTheCache)(memory, count, value);
}

}  // namespace knotspan::benchmarks
#endif
