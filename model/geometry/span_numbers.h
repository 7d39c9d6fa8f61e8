// Numbers that belong to the spans of a knot vector, made once and found by span.
#pragma once

#include <cstdint>
#include <vector>

#include "model/core/check.h"
#include "model/geometry/knot_vector.h"

namespace knotspan {

template <class Number>
class SpanNumbers {
public:
    // make(span, numbers) appends those of a span, for each of knots.spans().
    template <class Make>
    SpanNumbers(const KnotVector& knots, const Make& make) : startOf_(knots.values().size(), -1)
    {
        for (const int span : knots.spans()) {
            startOf_[static_cast<size_t>(span)] = static_cast<std::int64_t>(numbers_.size());
            make(span, numbers_);
        }
    }

    [[nodiscard]] const Number* data() const { return numbers_.data(); }
    // Where those of the span start in data(). `span` is one of knots.spans().
    [[nodiscard]] std::int64_t startOf(int span) const
    {
        const std::int64_t start = startOf_[static_cast<size_t>(span)];
        check(start >= 0, "numbers are asked for on a span with a length");
        return start;
    }

private:
    std::vector<std::int64_t> startOf_;  // by span; -1 where it has no length
    std::vector<Number> numbers_;
};

}  // namespace knotspan
