#include "model/geometry/span_tables.h"

#include <algorithm>

#include "model/core/check.h"

namespace knotspan {

SpanTables::SpanTables(const KnotVector& knots)
    : degree_(knots.degree()),
      size_(static_cast<size_t>(degree_ * 2 + degree_ * (degree_ + 1) / 2)),
      tableOf_(knots.values().size(), -1)
{
    numbers_.reserve(knots.spans().size() * size_);
    for (const int span : knots.spans()) {
        tableOf_[static_cast<size_t>(span)] = static_cast<int>(numbers_.size());
        const size_t start = numbers_.size();
        const double length = knots[span + 1] - knots[span];
        for (int j = 1; j <= degree_; ++j)
            numbers_.push_back((knots[span] - knots[span + 1 - j]) / length);
        for (int j = 1; j <= degree_; ++j)
            numbers_.push_back((knots[span + j] - knots[span + 1]) / length);
        for (int d = 1; d <= degree_; ++d)
            for (int r = 0; r < d; ++r)
                numbers_.push_back(length / (knots[span + r + 1] - knots[span + r + 1 - d]));
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
