// What the kernels of one instruction set share: vectors of lanes, and what is made of the homogeneous sums.
//
// Included once for each instruction set, after Highway has said which.
#if defined(KNOTSPAN_KERNEL_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KNOTSPAN_KERNEL_LANES_H
#undef KNOTSPAN_KERNEL_LANES_H
#else
#define KNOTSPAN_KERNEL_LANES_H
#endif

#include <limits>

#include <hwy/highway.h>

#include "model/geometry/grid_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace knotspan::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// A group's lanes in as many vectors as the machine needs for them.
template <class Real>
using Lanes = hn::CappedTag<Real, static_cast<size_t>(kGroupLanes<Real>)>;
template <class Real>
using Vec = hn::Vec<Lanes<Real>>;

template <class Real>
struct Triple {
    Vec<Real> x;
    Vec<Real> y;
    Vec<Real> z;
};

template <class Real>
struct Homogeneous {
    Triple<Real> xyz;
    Vec<Real> w;
};

template <class Real>
HWY_INLINE Triple<Real> operator*(const Triple<Real>& a, Vec<Real> s)
{
    return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}

// a - b s
template <class Real>
HWY_INLINE Triple<Real> minus(const Triple<Real>& a, const Triple<Real>& b, Vec<Real> s)
{
    return {hn::NegMulAdd(b.x, s, a.x), hn::NegMulAdd(b.y, s, a.y), hn::NegMulAdd(b.z, s, a.z)};
}

// A quotient or a product of what is itself within the range may be beyond it: such a derivative becomes 0.
template <class Real>
HWY_INLINE Triple<Real> inRange(const Triple<Real>& a)
{
    const Lanes<Real> d;
    const Vec<Real> most = hn::Set(d, std::numeric_limits<Real>::max());
    const auto checked = [&](Vec<Real> v) { return hn::IfThenElseZero(hn::Le(hn::Abs(v), most), v); };
    return {checked(a.x), checked(a.y), checked(a.z)};
}

template <class Real>
HWY_INLINE Vec<Real> dot(const Triple<Real>& a, const Triple<Real>& b)
{
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

template <class Real>
HWY_INLINE Vec<Real> largest(const Triple<Real>& a)
{
    return hn::Max(hn::Max(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
}

// A power of two that brings numbers of this size to 1 .. 2, so that squares stay within the range.
template <class Real>
HWY_INLINE Vec<Real> scaleFor(Vec<Real> size)
{
    const Lanes<Real> d;
    const hn::RebindToUnsigned<Lanes<Real>> bits;
    using Bits = hn::TFromD<decltype(bits)>;
    constexpr int kMantissa = sizeof(Real) == 4 ? 23 : 52;
    constexpr Bits kExponent = sizeof(Real) == 4 ? Bits{0xff} : Bits{0x7ff};
    const auto exponent = hn::And(hn::BitCast(bits, size), hn::Set(bits, kExponent << kMantissa));
    return hn::BitCast(d, hn::Sub(hn::Set(bits, (kExponent - 1) << kMantissa), exponent));
}

template <class Real>
HWY_INLINE void store(const Block<Real>& block, int field, size_t at, const Triple<Real>& value)
{
    const Lanes<Real> d;
    Real* const* planes = block.planes + 3 * field;
    if (planes[0] == nullptr)
        return;
    if (block.pastTheCache) {
        hn::Stream(value.x, d, planes[0] + at);
        hn::Stream(value.y, d, planes[1] + at);
        hn::Stream(value.z, d, planes[2] + at);
    } else {
        hn::Store(value.x, d, planes[0] + at);
        hn::Store(value.y, d, planes[1] + at);
        hn::Store(value.z, d, planes[2] + at);
    }
}

// 1 / sqrt. In float a guess and one step of Newton's method: division and root would take longer than all
// the rest.
template <class Real>
HWY_INLINE Vec<Real> perLength(Vec<Real> squared)
{
    const Lanes<Real> d;
    // Where there is no such instruction the guess has too few digits for one step.
    if constexpr (sizeof(Real) == 4 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128) {
        const Vec<Real> guess = hn::ApproximateReciprocalSqrt(squared);
        const Vec<Real> half = hn::Mul(hn::Set(d, Real(0.5)), guess);
        return hn::MulAdd(half, hn::NegMulAdd(hn::Mul(squared, guess), guess, hn::Set(d, Real(1))), guess);
    } else {
        return hn::Div(hn::Set(d, Real(1)), hn::Sqrt(squared));
    }
}

// S_u x S_v normalised; the lanes of the mask have none that can be trusted.
template <class Real>
HWY_INLINE auto normal(const Triple<Real>& du, const Triple<Real>& dv, Vec<Real> shortestU,
                       Vec<Real> shortestV, Triple<Real>& result)
{
    const Lanes<Real> d;
    // The square of the sine of tangents that are too close to parallel.
    constexpr Real kParallel = sizeof(Real) == 4 ? Real(1e-4) : Real(1e-14);
    const Vec<Real> sizeU = largest(du);
    const Vec<Real> sizeV = largest(dv);
    const Triple<Real> a = du * scaleFor<Real>(sizeU);
    const Triple<Real> b = dv * scaleFor<Real>(sizeV);
    const Triple<Real> n{hn::NegMulAdd(a.z, b.y, hn::Mul(a.y, b.z)),
                         hn::NegMulAdd(a.x, b.z, hn::Mul(a.z, b.x)),
                         hn::NegMulAdd(a.y, b.x, hn::Mul(a.x, b.y))};
    const Vec<Real> squared = dot(n, n);
    result = n * perLength<Real>(squared);
    const auto small = hn::Or(hn::Lt(sizeU, shortestU), hn::Lt(sizeV, shortestV));
    return hn::Or(small, hn::Not(hn::Gt(squared, hn::Set(d, kParallel))));
}

// xyz / w; polynomial surfaces have no w.
template <class Real, int C>
HWY_INLINE Triple<Real> projected(const Triple<Real>& xyz, Vec<Real> perWeight)
{
    return C == 4 ? xyz * perWeight : xyz;
}

template <class Real, class Place>
HWY_INLINE void storeNormal(const Block<Real>& block, const Place& place, size_t firstRow, int r, size_t at,
                            const Triple<Real>& du, const Triple<Real>& dv, Vec<Real> perWeight)
{
    const Lanes<Real> d;
    Triple<Real> n;
    const auto unsure =
        normal(du, dv, hn::Mul(shortestU(place, r), perWeight), hn::Mul(shortestV(place), perWeight), n);
    store(block, 6, at, n);
    if (HWY_LIKELY(hn::AllFalse(d, unsure)))
        return;
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, unsure, bits);
    const std::uint32_t word = static_cast<std::uint32_t>(bits[0]) | static_cast<std::uint32_t>(bits[1]) << 8;
    const size_t row = firstRow + static_cast<size_t>(r);
    block.unsure[row * static_cast<size_t>(block.groupCount) + place.group] |= word << place.lane;
}

// What second derivatives of a quotient are made of beside their own sums.
template <class Real>
struct Firsts {
    Triple<Real> position;
    Triple<Real> du;
    Triple<Real> dv;
    Vec<Real> weightU;
    Vec<Real> weightV;
    Vec<Real> perWeight;
};

// The derivative by a and b of the quotient whose own sum is `sum`: The NURBS Book, A4.4, written out.
template <class Real>
HWY_INLINE Triple<Real> second(const Homogeneous<Real>& sum, const Firsts<Real>& f,
                               const Triple<Real>& alongA, Vec<Real> weightB, const Triple<Real>& alongB,
                               Vec<Real> weightA)
{
    return inRange(
        minus<Real>(minus<Real>(minus<Real>(sum.xyz, alongA, weightB), alongB, weightA), f.position, sum.w) *
        f.perWeight);
}

template <class Real, int C, int R, class Place, class At>
HWY_INLINE void evaluateSeconds(const Block<Real>& block, const Place& place, const Firsts<Real> (&firsts)[R],
                                const At& at)
{
    const int p = block.degreeU;
    Homogeneous<Real> a[R];
    sum(place, 3, 2, p - 1, a);
    for (int r = 0; r < R; ++r) {
        const Firsts<Real>& f = firsts[r];
        store(block, 3, at(r), C == 3 ? a[r].xyz : second(a[r], f, f.du, f.weightU, f.du, f.weightU));
    }
    sum(place, 4, 1, p, a);
    for (int r = 0; r < R; ++r) {
        const Firsts<Real>& f = firsts[r];
        store(block, 4, at(r), C == 3 ? a[r].xyz : second(a[r], f, f.dv, f.weightU, f.du, f.weightV));
    }
    sum(place, 5, 0, p + 1, a);
    for (int r = 0; r < R; ++r) {
        const Firsts<Real>& f = firsts[r];
        store(block, 5, at(r), C == 3 ? a[r].xyz : second(a[r], f, f.dv, f.weightV, f.dv, f.weightV));
    }
}

// All fields of one vector of lanes in R rows; sum(place, net, orderU, terms, sums) gives the net's sums
// there, shortestU(place, row) and shortestV(place) what Block::unsure asks for.
template <class Real, int C, int Order, int R, class Place>
HWY_INLINE void evaluateLanes(const Block<Real>& block, const Place& place, size_t firstRow)
{
    const Lanes<Real> d;
    const int p = block.degreeU;
    const size_t column = place.group * static_cast<size_t>(kGroupLanes<Real>) + place.lane;
    const auto at = [&](int r) { return (firstRow + static_cast<size_t>(r)) * block.stride + column; };
    Homogeneous<Real> s[R];
    sum(place, 0, 0, p + 1, s);
    Vec<Real> perWeight[R];
    Triple<Real> position[R];
    for (int r = 0; r < R; ++r) {
        perWeight[r] = C == 4 ? hn::Div(hn::Set(d, Real(1)), s[r].w) : hn::Set(d, Real(1));
        position[r] = projected<Real, C>(s[r].xyz, perWeight[r]);
        store(block, 0, at(r), position[r]);
    }
    if constexpr (Order >= 1) {
        Homogeneous<Real> su[R];
        Homogeneous<Real> sv[R];
        Triple<Real> du[R] = {};
        Triple<Real> dv[R] = {};
        [[maybe_unused]] Firsts<Real> firsts[R];
        sum(place, 1, 1, p, su);
        sum(place, 2, 0, p + 1, sv);
        for (int r = 0; r < R; ++r) {
            du[r] = C == 4 ? inRange(minus<Real>(su[r].xyz, position[r], su[r].w) * perWeight[r]) : su[r].xyz;
            dv[r] = C == 4 ? inRange(minus<Real>(sv[r].xyz, position[r], sv[r].w) * perWeight[r]) : sv[r].xyz;
            store(block, 1, at(r), du[r]);
            store(block, 2, at(r), dv[r]);
            if (block.planes[18] != nullptr)
                storeNormal(block, place, firstRow, r, at(r), du[r], dv[r], perWeight[r]);
        }
        if constexpr (Order >= 2) {
            for (int r = 0; r < R; ++r)
                firsts[r] = {position[r], du[r], dv[r], su[r].w, sv[r].w, perWeight[r]};
            evaluateSeconds<Real, C, R>(block, place, firsts, at);
        }
    }
}

}  // namespace
}  // namespace knotspan::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
