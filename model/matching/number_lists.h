// A list of numbers for each of many owners, most of them short or empty, in two arrays.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace knotspan {

class NumberLists {
public:
    NumberLists() = default;

    // Of pairs (owner, number), in their order; owners are below `owners`.
    NumberLists(size_t owners, const std::vector<std::pair<int, int>>& pairs) : starts_(owners + 1, 0)
    {
        for (const auto& pair : pairs)
            ++starts_[static_cast<size_t>(pair.first) + 1];
        for (size_t owner = 0; owner < owners; ++owner)
            starts_[owner + 1] += starts_[owner];
        numbers_.resize(pairs.size());
        std::vector<size_t> next = starts_;
        for (const auto& pair : pairs)
            numbers_[next[static_cast<size_t>(pair.first)]++] = pair.second;
    }

    [[nodiscard]] std::span<const int> of(int owner) const
    {
        const size_t start = starts_[static_cast<size_t>(owner)];
        return {numbers_.data() + start, starts_[static_cast<size_t>(owner) + 1] - start};
    }

private:
    std::vector<size_t> starts_;
    std::vector<int> numbers_;
};

}  // namespace knotspan
