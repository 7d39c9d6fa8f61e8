#include <algorithm>

#include "model/geometry/grid_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/geometry/scatter_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "model/geometry/kernel_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace knotspan::kernels::HWY_NAMESPACE {
namespace {

// The sums of up to a group of points, lane by lane, as a grid would have left them.
template <class Real, int C>
struct Sums {
    alignas(kGroupBytes) Real of[kMaxFields][C][kGroupLanes<Real>];
    alignas(kGroupBytes) Real shortestU[kGroupLanes<Real>];
    alignas(kGroupBytes) Real shortestV[kGroupLanes<Real>];
};

// One point: along v in vectors of at most `Most` lanes, then across them.
template <class Real, int C, size_t Most>
HWY_INLINE void sumPoint(const Block<Real>& block, const ScatteredPoints<Real>& scattered, int index,
                         Sums<Real, C>& sums)
{
    const hn::CappedTag<Real, Most> d;
    const ScatteredPoint<Real>& point = scattered.points[index];
    for (int n = 0; n < block.netCount; ++n) {
        const Net<Real>& net = block.nets[n];
        const size_t countV = static_cast<size_t>(net.countV);
        const Real* first = net.numbers + static_cast<size_t>(point.firstU * C) * countV + point.firstV;
        const Real* u = point.u[net.orderU];
        for (size_t c = 0; c < static_cast<size_t>(C); ++c) {
            auto total = hn::Zero(d);
            for (size_t j = 0; j < static_cast<size_t>(scattered.mostTermsV); j += hn::Lanes(d)) {
                auto column = hn::Zero(d);
                const Real* from = first + c * countV + j;
                for (int k = 0; k < scattered.termsU[n]; ++k, from += static_cast<size_t>(C) * countV)
                    column = hn::MulAdd(hn::Set(d, u[k]), hn::LoadU(d, from), column);
                total = hn::MulAdd(column, hn::LoadU(d, point.v[net.orderV] + j), total);
            }
            sums.of[n][c][index] = hn::GetLane(hn::SumOfLanes(d, total));
        }
    }
}

template <class Real, int C>
struct SummedPlace {
    const Sums<Real, C>& sums;
    size_t group;
    size_t lane;
};

template <class Real, int C>
HWY_INLINE void sum(const SummedPlace<Real, C>& place, int net, int /*orderU*/, int /*terms*/,
                    Homogeneous<Real> (&s)[1])
{
    const Lanes<Real> d;
    const auto& of = place.sums.of[net];
    s[0].xyz = {hn::Load(d, of[0] + place.lane), hn::Load(d, of[1] + place.lane),
                hn::Load(d, of[2] + place.lane)};
    s[0].w = C == 4 ? hn::Load(d, of[C - 1] + place.lane) : hn::Zero(d);
}

template <class Real, int C>
HWY_INLINE Vec<Real> shortestU(const SummedPlace<Real, C>& place, int /*row*/)
{
    return hn::Load(Lanes<Real>(), place.sums.shortestU + place.lane);
}

template <class Real, int C>
HWY_INLINE Vec<Real> shortestV(const SummedPlace<Real, C>& place)
{
    return hn::Load(Lanes<Real>(), place.sums.shortestV + place.lane);
}

template <class Real, int C, int Order>
void evaluatePoints(const Block<Real>& block, const ScatteredPoints<Real>& scattered)
{
    const Lanes<Real> d;
    Sums<Real, C> sums;
    // Spare lanes repeat the last point.
    for (int k = 0; k < scattered.count; ++k)
        scattered.mostTermsV <= 4 ? sumPoint<Real, C, 4>(block, scattered, k, sums)
                                  : sumPoint<Real, C, 16>(block, scattered, k, sums);
    for (int n = 0; n < block.netCount; ++n)
        for (auto& lanes : sums.of[n])
            for (int k = scattered.count; k < kGroupLanes<Real>; ++k)
                lanes[k] = lanes[scattered.count - 1];
    for (int k = 0; k < kGroupLanes<Real>; ++k) {
        const ScatteredPoint<Real>& point = scattered.points[std::min(k, scattered.count - 1)];
        sums.shortestU[k] = point.shortestU;
        sums.shortestV[k] = point.shortestV;
    }
    for (size_t lane = 0; lane < static_cast<size_t>(kGroupLanes<Real>); lane += hn::Lanes(d))
        evaluateLanes<Real, C, Order, 1>(block, SummedPlace<Real, C>{sums, 0, lane}, 0);
}

template <class Real, int C>
void evaluateOrder(const Block<Real>& block, const ScatteredPoints<Real>& scattered)
{
    if (block.netCount == 1)
        evaluatePoints<Real, C, 0>(block, scattered);
    else if (block.netCount == 3)
        evaluatePoints<Real, C, 1>(block, scattered);
    else
        evaluatePoints<Real, C, 2>(block, scattered);
}

void ScatterFloat(const Block<float>& block, const ScatteredPoints<float>& scattered)
{
    block.components == 3 ? evaluateOrder<float, 3>(block, scattered)
                          : evaluateOrder<float, 4>(block, scattered);
}

void ScatterDouble(const Block<double>& block, const ScatteredPoints<double>& scattered)
{
    block.components == 3 ? evaluateOrder<double, 3>(block, scattered)
                          : evaluateOrder<double, 4>(block, scattered);
}

}  // namespace
}  // namespace knotspan::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace knotspan::kernels {

namespace {

HWY_EXPORT(ScatterFloat);
HWY_EXPORT(ScatterDouble);

}  // namespace

void evaluate(const Block<float>& block, const ScatteredPoints<float>& points)
{
    HWY_DYNAMIC_DISPATCH(ScatterFloat)(block, points);
}

void evaluate(const Block<double>& block, const ScatteredPoints<double>& points)
{
    HWY_DYNAMIC_DISPATCH(ScatterDouble)(block, points);
}

}  // namespace knotspan::kernels
#endif
