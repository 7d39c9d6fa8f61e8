// Corners of surfaces' borders that are one point: groups of those that a chain of neighbours within the
// tolerance joins.
#pragma once

#include <utility>

#include "model/analysis/box_hash.h"

namespace knotspan {

struct CornerPlace {
    Vec3 at{};
    double tolerance = 0;  // two corners are neighbours within the larger of theirs

    [[nodiscard]] bool operator==(const CornerPlace&) const = default;
};

class CornerGroups {
public:
    using Moves = std::vector<std::pair<std::uint32_t, CornerPlace>>;

    CornerGroups() = default;
    // No tolerance is above `widest`. names[k]: of corner k; the least one owns a group.
    CornerGroups(std::vector<std::uint32_t> names, const std::vector<CornerPlace>& corners, double widest);

    // Gives corners other places. Returns all whose group may be another now, the moved ones included,
    // increasing.
    std::vector<std::uint32_t> move(const Moves& moves);

    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(places_.size()); }
    [[nodiscard]] const CornerPlace& place(std::uint32_t corner) const { return places_[corner]; }
    // The corner that owns the group.
    [[nodiscard]] std::uint32_t ownerOf(std::uint32_t corner) const { return owner_[corner]; }
    [[nodiscard]] std::uint32_t nameOf(std::uint32_t corner) const { return names_[corner]; }

    // Of all corners of a group, in no particular order.
    template <class Visit>
    void forGroup(std::uint32_t corner, const Visit& visit) const
    {
        std::uint32_t member = corner;
        do {
            visit(member);
            member = next_[member];
        } while (member != corner);
    }

private:
    [[nodiscard]] Box around(std::uint32_t corner) const;
    void regroup(const std::vector<std::uint32_t>& seeds, std::vector<std::uint32_t>& touched);

    std::vector<std::uint32_t> names_;
    std::vector<CornerPlace> places_;
    std::vector<std::uint32_t> owner_;
    std::vector<std::uint32_t> next_;  // round the group
    std::vector<char> seen_;
    double widest_ = 0;
    BoxHash grid_;
};

}  // namespace knotspan
