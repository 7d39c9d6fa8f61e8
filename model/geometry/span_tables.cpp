#include "model/geometry/span_tables.h"

#include <algorithm>

#include "model/geometry/evaluator_tables.h"

namespace knotspan {

SpanTables::SpanTables(const KnotVector& knots)
    : degree_(knots.degree()),
      tables_(knots, [&knots](int span, std::vector<double>& numbers) {
          // Beyond so many spans the share of a neighbour is less than double can tell from nothing.
          const auto differences = evaluator_tables::differences<double>(knots, span, 1e300);
          numbers.insert(numbers.end(), differences.begin(), differences.end());
          const double* left = differences.data();
          const double* right = left + knots.degree();
          for (int d = 1; d <= knots.degree(); ++d)
              for (int r = 0; r < d; ++r)
                  numbers.push_back(1 / (1 + left[d - r - 1] + right[r]));
      })
{
}

void SpanTables::basis(std::span<const SpanParameter> at, int order, kernels::BasisLanes& lanes) const
{
    kernels::BasisRequest request;
    request.numbers = tables_.data();
    request.degree = degree_;
    request.order = order;
    for (size_t l = 0; l < kernels::kBasisLanes; ++l) {
        const SpanParameter& one = at[std::min(l, at.size() - 1)];
        request.tables[l] = tables_.startOf(one.span);
        request.t[l] = one.t;
    }
    kernels::basisFunctions(request, lanes);
}

}  // namespace knotspan
