// What many values come to together, kept up while single ones change: the root of a binary tree of sums, of
// which a change makes only the way up anew.
#pragma once

#include <bit>
#include <cstddef>
#include <vector>

namespace knotspan {

// Value{} adds nothing; add(const Value&) is associative, up to rounding. The same values always give the
// same total, to the bit, however they came about.
template <class Value>
class Totals {
public:
    Totals() = default;
    explicit Totals(const std::vector<Value>& values)
        : leaves_(std::bit_ceil(values.size() > 0 ? values.size() : 1)),
          nodes_(2 * leaves_)
    {
        for (size_t k = 0; k < values.size(); ++k)
            nodes_[leaves_ + k] = values[k];
        for (size_t node = leaves_ - 1; node > 0; --node)
            sum(node);
    }

    void set(size_t index, const Value& value)
    {
        nodes_[leaves_ + index] = value;
        for (size_t node = (leaves_ + index) / 2; node > 0; node /= 2)
            sum(node);
    }

    [[nodiscard]] const Value& operator[](size_t index) const { return nodes_[leaves_ + index]; }
    [[nodiscard]] Value all() const { return nodes_.empty() ? Value{} : nodes_[1]; }

    // visit(index) of every value that, with all totals it is part of, satisfies the test; increasing.
    template <class Test, class Visit>
    void visitWhere(const Test& test, const Visit& visit) const
    {
        if (!nodes_.empty())
            visitBelow(1, test, visit);
    }

private:
    void sum(size_t node)
    {
        nodes_[node] = nodes_[2 * node];
        nodes_[node].add(nodes_[2 * node + 1]);
    }
    template <class Test, class Visit>
    void visitBelow(size_t node, const Test& test, const Visit& visit) const
    {
        if (!test(nodes_[node]))
            return;
        if (node >= leaves_) {
            visit(node - leaves_);
            return;
        }
        visitBelow(2 * node, test, visit);
        visitBelow(2 * node + 1, test, visit);
    }

    size_t leaves_ = 0;  // a power of two
    std::vector<Value> nodes_;
};

}  // namespace knotspan
