#include "model/geometry/basis_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/geometry/basis_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace knotspan::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// SpanTables::basis() with a lane for each parameter.
void BasisFunctions(const BasisRequest& request, BasisLanes& lanes)
{
    const hn::CappedTag<double, kBasisLanes> d;
    const hn::RebindToSigned<decltype(d)> whole;
    const size_t p = static_cast<size_t>(request.degree);
    const auto one = hn::Set(d, 1.0);
    for (size_t l = 0; l < kBasisLanes; l += hn::Lanes(d)) {
        const auto start = hn::LoadU(whole, request.tables + l);
        const auto t = hn::LoadU(d, request.t + l);
        const auto rest = hn::Sub(one, t);
        const auto number = [&](size_t index) { return hn::GatherIndex(d, request.numbers + index, start); };
        double(&row)[16][kBasisLanes] = lanes.rows[0];
        hn::Store(one, d, row[0] + l);
        size_t reciprocal = 2 * p;
        for (size_t degree = 1; degree <= p; ++degree) {
            // Before the row is raised to the degree, it is that of a derivative.
            if (const size_t lowered = p - degree + 1; lowered <= static_cast<size_t>(request.order))
                for (size_t k = 0; k < degree; ++k)
                    hn::Store(hn::Load(d, row[k] + l), d, lanes.rows[lowered][k] + l);
            auto carried = hn::Zero(d);
            for (size_t r = 0; r < degree; ++r) {
                const auto share = hn::Mul(hn::Load(d, row[r] + l), number(reciprocal++));
                hn::Store(hn::MulAdd(hn::Add(rest, number(p + r)), share, carried), d, row[r] + l);
                carried = hn::Mul(hn::Add(t, number(degree - r - 1)), share);
            }
            hn::Store(carried, d, row[degree] + l);
        }
    }
}

}  // namespace
}  // namespace knotspan::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace knotspan::kernels {

namespace {

HWY_EXPORT(BasisFunctions);

}  // namespace

void basisFunctions(const BasisRequest& request, BasisLanes& lanes)
{
    HWY_DYNAMIC_DISPATCH(BasisFunctions)(request, lanes);
}

}  // namespace knotspan::kernels
#endif
