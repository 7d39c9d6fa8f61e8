#include "model/geometry/facing_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/geometry/facing_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace knotspan::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<double, kFacingPadding>;

void SumMinors(const FacingTerm* terms, size_t termCount, size_t pitch, size_t count, double* minors)
{
    const Lanes d;
    for (size_t at = 0; at < count; at += hn::Lanes(d)) {
        auto xy = hn::Zero(d);
        auto xz = xy;
        auto xw = xy;
        auto yz = xy;
        auto yw = xy;
        auto zw = xy;
        for (const FacingTerm* term = terms; term != terms + termCount; ++term) {
            const double* const from = term->planes + at;
            const auto x = hn::LoadU(d, from);
            const auto y = hn::LoadU(d, from + pitch);
            const auto z = hn::LoadU(d, from + 2 * pitch);
            const auto w = hn::LoadU(d, from + 3 * pitch);
            const auto ax = hn::Set(d, term->x);
            const auto ay = hn::Set(d, term->y);
            const auto az = hn::Set(d, term->z);
            const auto aw = hn::Set(d, term->w);
            xy = hn::NegMulAdd(ay, x, hn::MulAdd(ax, y, xy));
            xz = hn::NegMulAdd(az, x, hn::MulAdd(ax, z, xz));
            xw = hn::NegMulAdd(aw, x, hn::MulAdd(ax, w, xw));
            yz = hn::NegMulAdd(az, y, hn::MulAdd(ay, z, yz));
            yw = hn::NegMulAdd(aw, y, hn::MulAdd(ay, w, yw));
            zw = hn::NegMulAdd(aw, z, hn::MulAdd(az, w, zw));
        }
        double* const to = minors + at;
        hn::StoreU(xy, d, to);
        hn::StoreU(xz, d, to + pitch);
        hn::StoreU(xw, d, to + 2 * pitch);
        hn::StoreU(yz, d, to + 3 * pitch);
        hn::StoreU(yw, d, to + 4 * pitch);
        hn::StoreU(zw, d, to + 5 * pitch);
    }
}

void SumProducts(const FacingTerm* terms, size_t termCount, size_t pitch, size_t count, const double* scales,
                 double* sums)
{
    const Lanes d;
    for (size_t at = 0; at < count; at += hn::Lanes(d)) {
        auto x = hn::Zero(d);
        auto y = x;
        auto z = x;
        auto w = x;
        for (const FacingTerm* term = terms; term != terms + termCount; ++term) {
            const double* const from = term->planes + at;
            const auto xy = hn::LoadU(d, from);
            const auto xz = hn::LoadU(d, from + pitch);
            const auto xw = hn::LoadU(d, from + 2 * pitch);
            const auto yz = hn::LoadU(d, from + 3 * pitch);
            const auto yw = hn::LoadU(d, from + 4 * pitch);
            const auto zw = hn::LoadU(d, from + 5 * pitch);
            const auto ax = hn::Set(d, term->x);
            const auto ay = hn::Set(d, term->y);
            const auto az = hn::Set(d, term->z);
            const auto aw = hn::Set(d, term->w);
            x = hn::MulAdd(aw, yz, hn::NegMulAdd(az, yw, hn::MulAdd(ay, zw, x)));
            y = hn::NegMulAdd(aw, xz, hn::NegMulAdd(ax, zw, hn::MulAdd(az, xw, y)));
            z = hn::MulAdd(aw, xy, hn::NegMulAdd(ay, xw, hn::MulAdd(ax, yw, z)));
            w = hn::NegMulAdd(az, xy, hn::NegMulAdd(ax, yz, hn::MulAdd(ay, xz, w)));
        }
        const auto scale = hn::LoadU(d, scales + at);
        double* const to = sums + at;
        hn::StoreU(hn::Mul(x, scale), d, to);
        hn::StoreU(hn::Mul(y, scale), d, to + pitch);
        hn::StoreU(hn::Mul(z, scale), d, to + 2 * pitch);
        hn::StoreU(hn::Mul(w, scale), d, to + 3 * pitch);
    }
}

}  // namespace
}  // namespace knotspan::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace knotspan::kernels {

namespace {

HWY_EXPORT(SumMinors);
HWY_EXPORT(SumProducts);

}  // namespace

void sumFacingMinors(const FacingTerm* terms, size_t termCount, size_t pitch, size_t count, double* minors)
{
    HWY_DYNAMIC_DISPATCH(SumMinors)(terms, termCount, pitch, count, minors);
}

void sumFacingProducts(const FacingTerm* terms, size_t termCount, size_t pitch, size_t count,
                       const double* scales, double* sums)
{
    HWY_DYNAMIC_DISPATCH(SumProducts)(terms, termCount, pitch, count, scales, sums);
}

}  // namespace knotspan::kernels
#endif
