#include "model/geometry/grid_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/geometry/grid_kernels.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "model/geometry/kernel_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace knotspan::kernels::HWY_NAMESPACE {
namespace {

// Each net's rows of control points, contracted along v for all lanes of the block and kept until rows of
// other u need their place. What one row leaves for one group of lanes stands together: net by net, component
// by component.
template <class Real, int C, int Order>
class Contracted {
public:
    static constexpr int kNets = (Order + 1) * (Order + 2) / 2;
    static constexpr size_t kLanes = static_cast<size_t>(kGroupLanes<Real>);
    static constexpr size_t kGroup = static_cast<size_t>(kNets * C) * kLanes;

    explicit Contracted(const Block<Real>& block)
        : block_(block),
          slot_(static_cast<size_t>(block.groupCount) * kGroup)
    {
        for (int& held : held_)
            held = -1;
    }

    // Makes the rows that shape samples with these basis functions.
    HWY_INLINE void provide(const RowBasis<Real>& row)
    {
        if (row.first == first_)
            return;
        first_ = row.first;
        for (int k = 0; k <= block_.degreeU; ++k) {
            const int i = row.first + k;
            const int place = i % (block_.degreeU + 1);
            rows_[k] = block_.scratch + static_cast<size_t>(place) * slot_;
            if (held_[place] != i)
                for (int g = 0; g < block_.groupCount; ++g)
                    make(i, block_.groups[g], rows_[k] + static_cast<size_t>(g) * kGroup);
            held_[place] = i;
        }
    }

    // The group's numbers in the row that is k-th of those provided.
    HWY_INLINE const Real* at(int k, size_t group) const { return rows_[k] + group * kGroup; }

    HWY_INLINE const Real* shortest(size_t group) const { return block_.groups[group].shortest; }

private:
    void make(int i, const LaneGroup<Real>& group, Real* to)
    {
        const Lanes<Real> d;
        for (int n = 0; n < kNets; ++n, to += static_cast<size_t>(C) * kLanes) {
            const Net<Real>& net = block_.nets[n];
            if (i >= net.countU)
                continue;  // nets of derivatives have fewer rows
            const size_t countV = static_cast<size_t>(net.countV);
            const Real* points = net.numbers + static_cast<size_t>(i * C) * countV + group.first;
            for (size_t l = 0; l < kLanes; l += hn::Lanes(d)) {
                const Real* from = points;
                const Real* weights = group.weights[net.orderV] + l;
                Vec<Real> x = hn::Zero(d);
                Vec<Real> y = x;
                Vec<Real> z = x;
                Vec<Real> w = x;
                for (int k = 0; k < group.terms[net.orderV]; ++k, ++from, weights += kLanes) {
                    const Vec<Real> weight = hn::Load(d, weights);
                    x = hn::MulAdd(weight, hn::Set(d, from[0]), x);
                    y = hn::MulAdd(weight, hn::Set(d, from[countV]), y);
                    z = hn::MulAdd(weight, hn::Set(d, from[2 * countV]), z);
                    if constexpr (C == 4)
                        w = hn::MulAdd(weight, hn::Set(d, from[3 * countV]), w);
                }
                hn::Store(x, d, to + l);
                hn::Store(y, d, to + kLanes + l);
                hn::Store(z, d, to + 2 * kLanes + l);
                if constexpr (C == 4)
                    hn::Store(w, d, to + 3 * kLanes + l);
            }
        }
    }

    const Block<Real>& block_;
    size_t slot_;
    int first_ = -1;
    int held_[16];
    Real* rows_[16] = {};
};

// A vector of lanes in R rows that are shaped by the same control points.
template <class Real, int C, int Order>
struct Place {
    const Contracted<Real, C, Order>& contracted;
    const RowBasis<Real>* rows;
    size_t group;
    size_t lane;  // in the group
};

template <class Real, int C, int Order>
HWY_INLINE Vec<Real> shortestU(const Place<Real, C, Order>& place, int row)
{
    return hn::Set(Lanes<Real>(), place.rows[row].shortest);
}

template <class Real, int C, int Order>
HWY_INLINE Vec<Real> shortestV(const Place<Real, C, Order>& place)
{
    return hn::Load(Lanes<Real>(), place.contracted.shortest(place.group) + place.lane);
}

// The net of order (a, b) there.
template <class Real, int C, int Order, int R>
HWY_INLINE void sum(const Place<Real, C, Order>& place, int net, int orderU, int terms,
                    Homogeneous<Real> (&s)[R])
{
    const Lanes<Real> d;
    constexpr size_t kLanes = static_cast<size_t>(kGroupLanes<Real>);
    for (Homogeneous<Real>& one : s)
        one = {{hn::Zero(d), hn::Zero(d), hn::Zero(d)}, hn::Zero(d)};
    const size_t offset = static_cast<size_t>(net * C) * kLanes + place.lane;
    for (int k = 0; k < terms; ++k) {
        const Real* at = place.contracted.at(k, place.group) + offset;
        const Vec<Real> x = hn::Load(d, at);
        const Vec<Real> y = hn::Load(d, at + kLanes);
        const Vec<Real> z = hn::Load(d, at + 2 * kLanes);
        for (int r = 0; r < R; ++r) {
            const Vec<Real> weight = hn::Set(d, place.rows[r].weights[orderU][k]);
            s[r].xyz.x = hn::MulAdd(weight, x, s[r].xyz.x);
            s[r].xyz.y = hn::MulAdd(weight, y, s[r].xyz.y);
            s[r].xyz.z = hn::MulAdd(weight, z, s[r].xyz.z);
            if constexpr (C == 4)
                s[r].w = hn::MulAdd(weight, hn::Load(d, at + 3 * kLanes), s[r].w);
        }
    }
}

template <class Real, int C, int Order, int R>
HWY_INLINE void evaluateRows(const Block<Real>& block, const Contracted<Real, C, Order>& contracted,
                             size_t row)
{
    const Lanes<Real> d;
    for (size_t group = 0; group < static_cast<size_t>(block.groupCount); ++group)
        for (size_t lane = 0; lane < static_cast<size_t>(kGroupLanes<Real>); lane += hn::Lanes(d))
            evaluateLanes<Real, C, Order, R>(
                block, Place<Real, C, Order>{contracted, block.rows + row, group, lane}, row);
}

template <class Real, int C, int Order>
void evaluateBlock(const Block<Real>& block)
{
    Contracted<Real, C, Order> contracted(block);
    const size_t rows = static_cast<size_t>(block.rowCount);
    for (size_t row = 0; row < rows;) {
        contracted.provide(block.rows[row]);
        // Two rows at a time load what they share once, and one's division waits beside the other's sums.
        if (row + 1 < rows && block.rows[row + 1].first == block.rows[row].first) {
            evaluateRows<Real, C, Order, 2>(block, contracted, row);
            row += 2;
        } else {
            evaluateRows<Real, C, Order, 1>(block, contracted, row);
            row += 1;
        }
    }
    if (block.pastTheCache)
        hwy::FlushStream();
}

template <class Real, int C>
void evaluateOrder(const Block<Real>& block)
{
    if (block.netCount == 1)
        evaluateBlock<Real, C, 0>(block);
    else if (block.netCount == 3)
        evaluateBlock<Real, C, 1>(block);
    else
        evaluateBlock<Real, C, 2>(block);
}

template <class Real>
void evaluateComponents(const Block<Real>& block)
{
    block.components == 3 ? evaluateOrder<Real, 3>(block) : evaluateOrder<Real, 4>(block);
}

void EvaluateFloat(const Block<float>& block)
{
    evaluateComponents(block);
}

void EvaluateDouble(const Block<double>& block)
{
    evaluateComponents(block);
}

}  // namespace
}  // namespace knotspan::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace knotspan::kernels {

namespace {

HWY_EXPORT(EvaluateFloat);
HWY_EXPORT(EvaluateDouble);

}  // namespace

void evaluate(const Block<float>& block)
{
    HWY_DYNAMIC_DISPATCH(EvaluateFloat)(block);
}

void evaluate(const Block<double>& block)
{
    HWY_DYNAMIC_DISPATCH(EvaluateDouble)(block);
}

}  // namespace knotspan::kernels
#endif
