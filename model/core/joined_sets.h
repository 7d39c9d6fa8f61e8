// Sets that only ever grow together (disjoint sets, after Tarjan), each named by the smallest number in it.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace knotspan {

class JoinedSets {
public:
    JoinedSets() = default;
    // Of one number each: 0 to count - 1.
    explicit JoinedSets(std::size_t count)
    {
        while (into_.size() < count)
            add();
    }

    std::uint32_t add()
    {
        into_.push_back(static_cast<std::uint32_t>(into_.size()));
        return into_.back();
    }
    [[nodiscard]] std::uint32_t find(std::uint32_t k) const
    {
        while (into_[k] != k)
            k = into_[k] = into_[into_[k]];
        return k;
    }
    struct Joined {
        std::uint32_t kept;
        std::uint32_t gone;
    };
    // Nothing where they were one already.
    std::optional<Joined> join(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        if (a == b)
            return std::nullopt;
        if (b < a)
            std::swap(a, b);
        into_[b] = a;
        return Joined{a, b};
    }

private:
    mutable std::vector<std::uint32_t> into_;  // ways are shortened as they are gone
};

}  // namespace knotspan
