#include "model/geometry/span_tables.h"

#include <algorithm>

#include "model/core/check.h"
#include "model/geometry/evaluator_tables.h"

namespace knotspan {

SpanTables::SpanTables(const KnotVector& knots)
    : degree_(knots.degree()),
      size_(static_cast<size_t>(degree_ * 2 + degree_ * (degree_ + 1) / 2)),
      tableOf_(knots.values().size(), -1)
{
    numbers_.reserve(knots.spans().size() * size_);
    for (const int span : knots.spans()) {
        tableOf_[static_cast<size_t>(span)] = static_cast<std::int64_t>(numbers_.size());
        const size_t start = numbers_.size();
        // Beyond so many spans the share of a neighbour is less than double can tell from nothing.
        const auto differences = evaluator_tables::differences<double>(knots, span, 1e300);
        numbers_.insert(numbers_.end(), differences.begin(), differences.end());
        const double* left = differences.data();
        const double* right = left + degree_;
        for (int d = 1; d <= degree_; ++d)
            for (int r = 0; r < d; ++r)
                numbers_.push_back(1 / (1 + left[d - r - 1] + right[r]));
        check(numbers_.size() == start + size_, "a span's table has its size");
    }
}

void SpanTables::basis(std::span<const SpanParameter> at, int order, kernels::BasisLanes& lanes) const
{
    kernels::BasisRequest request;
    request.numbers = numbers_.data();
    request.degree = degree_;
    request.order = order;
    for (size_t l = 0; l < kernels::kBasisLanes; ++l) {
        const SpanParameter& one = at[std::min(l, at.size() - 1)];
        request.tables[l] = tableOf_[static_cast<size_t>(one.span)];
        request.t[l] = one.t;
    }
    kernels::basisFunctions(request, lanes);
}

}  // namespace knotspan
