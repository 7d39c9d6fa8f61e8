#include "model/geometry/bezier_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/geometry/bezier_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace knotspan::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// A point's four numbers, in as many vectors as the machine needs for them.
using Lanes = hn::CappedTag<double, 4>;

// `fixed`: the order, where it is known when compiling; else 0.
template <size_t fixed>
HWY_INLINE hn::Vec<Lanes> sumOf(const double* shares, const double* points, size_t stride, size_t order)
{
    const Lanes d;
    const size_t terms = fixed != 0 ? fixed : order;
    auto sum = hn::Mul(hn::Set(d, shares[0]), hn::LoadU(d, points));
    for (size_t k = 1; k < terms; ++k)
        sum = hn::MulAdd(hn::Set(d, shares[k]), hn::LoadU(d, points + k * stride), sum);
    return sum;
}

// Each row of points along v becomes the points of all spans, one behind the other.
template <size_t fixed>
void decomposeRows(const SpanSums& along, size_t rowCount, const double* points, double* to)
{
    const Lanes d;
    const size_t order = fixed != 0 ? fixed : along.order;
    for (size_t row = 0; row < rowCount; ++row)
        for (size_t span = 0; span < along.spans; ++span) {
            const double* const from = points + 4 * (row * along.points + along.firsts[span]);
            for (size_t l = 0; l < order; ++l) {
                const double* const shares = along.matrices + (span * order + l) * order;
                for (size_t c = 0; c < 4; c += hn::Lanes(d))
                    hn::StoreU(sumOf<fixed>(shares, from + c, 4, order), d, to + c);
                to += 4;
            }
        }
}

// And each column of those along u.
template <size_t fixed>
void decomposeColumns(const SpanSums& along, const double* rows, size_t spansV, size_t orderV, float* to)
{
    const Lanes d;
    const hn::Rebind<float, Lanes> rounded;
    const size_t order = fixed != 0 ? fixed : along.order;
    const size_t stride = 4 * spansV * orderV;
    for (size_t spanU = 0; spanU < along.spans; ++spanU)
        for (size_t spanV = 0; spanV < spansV; ++spanV) {
            const double* const from = rows + along.firsts[spanU] * stride + spanV * 4 * orderV;
            for (size_t k = 0; k < order; ++k) {
                const double* const shares = along.matrices + (spanU * order + k) * order;
                for (size_t c = 0; c < 4 * orderV; c += hn::Lanes(d))
                    hn::StoreU(hn::DemoteTo(rounded, sumOf<fixed>(shares, from + c, stride, order)), rounded,
                               to + c);
                to += 4 * orderV;
            }
        }
}

void Decompose(const SpanSums& alongU, const SpanSums& alongV, const double* points, double* rows,
               float* nets)
{
    if (alongV.order == 4)
        decomposeRows<4>(alongV, alongU.points, points, rows);
    else
        decomposeRows<0>(alongV, alongU.points, points, rows);
    if (alongU.order == 4)
        decomposeColumns<4>(alongU, rows, alongV.spans, alongV.order, nets);
    else
        decomposeColumns<0>(alongU, rows, alongV.spans, alongV.order, nets);
}

}  // namespace
}  // namespace knotspan::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace knotspan::kernels {

namespace {

HWY_EXPORT(Decompose);

}  // namespace

void decompose(const SpanSums& alongU, const SpanSums& alongV, const double* points, double* rows,
               float* nets)
{
    HWY_DYNAMIC_DISPATCH(Decompose)(alongU, alongV, points, rows, nets);
}

}  // namespace knotspan::kernels
#endif
