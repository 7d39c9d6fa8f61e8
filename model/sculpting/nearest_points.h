// Points that stand still, asked often which of them is near a place: a k-d tree.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/core/space.h"

namespace knotspan {

class NearestPoints {
public:
    // Finite points.
    explicit NearestPoints(const std::vector<Vec3>& points);

    struct Found {
        size_t index = 0;     // in the list it was made from
        double distance = 0;  // in the points' unit
    };
    // The nearest no further than `reach` (0 or more); of those equally near the first of the list.
    [[nodiscard]] std::optional<Found> nearest(const Vec3& place, double reach) const;
    // All no further than `reach`, in the order of the list.
    [[nodiscard]] std::vector<size_t> within(const Vec3& place, double reach) const;

    [[nodiscard]] const Box& bounds() const { return bounds_; }

private:
    struct Entry {
        Vec3 position;
        size_t index;
    };
    void arrange(size_t first, size_t last);
    // What a search knows of the part that it looks at: how far, in each of x, y and z, the place lies
    // outside.
    struct Part {
        size_t first;
        size_t last;
        Vec3 outside;
    };
    // Calls visit(entry, squared distance) for whatever may be within the square root of `reachSquared`,
    // which it may lessen on the way.
    template <class Visit>
    void visitNear(const Vec3& place, const Part& part, const double& reachSquared, const Visit& visit) const;
    [[nodiscard]] Part whole(const Vec3& place) const;

    // The one in the middle of a part divides it: those before it lie no higher along its axis.
    std::vector<Entry> entries_;
    std::vector<std::uint8_t> axes_;
    Box bounds_;
};

}  // namespace knotspan
