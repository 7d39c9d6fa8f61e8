#include "model/geometry/span_parameter.h"

#include "model/core/check.h"

namespace knotspan {

std::vector<SpanParameter> spanParameters(const KnotVector& knots, std::span<const double> values)
{
    std::vector<SpanParameter> result;
    result.reserve(values.size());
    for (double u : values) {
        u = knots.inDomain(u);
        const int span = knots.findSpan(u);
        result.push_back({span, (u - knots[span]) / (knots[span + 1] - knots[span])});
    }
    return result;
}

std::vector<SpanParameter> parametersPerSpan(const KnotVector& knots, int cells)
{
    check(cells >= 1, "a span has at least one cell");
    std::vector<SpanParameter> result;
    result.reserve(knots.spans().size() * static_cast<size_t>(cells + 1));
    for (const int span : knots.spans())
        for (int k = 0; k <= cells; ++k)
            result.push_back({span, static_cast<double>(k) / cells});
    return result;
}

}  // namespace knotspan
