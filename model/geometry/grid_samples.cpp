#include <algorithm>
#include <new>

#include "model/core/check.h"
#include "model/geometry/grid_evaluation.h"
#include "model/geometry/grid_kernels.h"

namespace knotspan {

namespace {

constexpr std::align_val_t kAlignment{kernels::kGroupBytes};

}  // namespace

template <class Real>
void GridSamples<Real>::Release::operator()(Real* memory) const
{
    ::operator delete[](memory, kAlignment);
}

template <class Real>
void GridSamples<Real>::resize(int rows, int columns, SampleFields fields, const Vec3& origin)
{
    check(rows >= 0 && columns >= 0 && fields.derivatives >= 0 && fields.derivatives <= 2,
          "samples have rows, columns and derivatives up to the second");
    constexpr size_t kLanes = static_cast<size_t>(kernels::kGroupLanes<Real>);
    rows_ = rows;
    columns_ = columns;
    stride_ = (static_cast<size_t>(columns) + kLanes - 1) / kLanes * kLanes;
    origin_ = origin;
    const auto wanted = [&](Field field) {
        return field == kPosition ||
               (field == kNormal ? fields.normals : fields.derivatives >= (field <= kDv ? 1 : 2));
    };
    planeCount_ = 0;
    for (int field = 0; field < kFieldCount; ++field) {
        planes_[field] = wanted(static_cast<Field>(field)) ? planeCount_ : -1;
        planeCount_ += planes_[field] >= 0 ? 3 : 0;
    }
    if (const size_t needed = planeSize() * static_cast<size_t>(planeCount_); needed > capacity_) {
        memory_.reset();
        capacity_ = 0;
        memory_.reset(new (kAlignment) Real[needed]);
        capacity_ = needed;
    }
}

template <class Real>
std::span<const Real> GridSamples<Real>::plane(Field field, int component) const
{
    check(has(field) && component >= 0 && component < 3, "the field was asked for");
    return {memory_.get() + static_cast<size_t>(planes_[field] + component) * planeSize(),
            static_cast<size_t>(rows_) * stride_};
}

template <class Real>
std::span<Real> GridSamples<Real>::plane(Field field, int component)
{
    const std::span<const Real> plane = std::as_const(*this).plane(field, component);
    return {const_cast<Real*>(plane.data()), plane.size()};
}

template class GridSamples<float>;
template class GridSamples<double>;

}  // namespace knotspan
