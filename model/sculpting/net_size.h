// How many control points a net has, and the order that lists of them are kept in.
#pragma once

#include "model/scene/control_point_editing.h"

namespace knotspan {

struct NetSize {
    int countU = 0;
    int countV = 0;

    [[nodiscard]] bool operator==(const NetSize&) const = default;

    [[nodiscard]] size_t count() const { return static_cast<size_t>(countU) * static_cast<size_t>(countV); }
    [[nodiscard]] bool contains(ControlPointIndex index) const
    {
        return index.i >= 0 && index.i < countU && index.j >= 0 && index.j < countV;
    }
    // Where the surface stores the point.
    [[nodiscard]] size_t place(ControlPointIndex index) const
    {
        return static_cast<size_t>(index.i) * static_cast<size_t>(countV) + static_cast<size_t>(index.j);
    }
    [[nodiscard]] ControlPointIndex indexAt(size_t place) const
    {
        const auto row = static_cast<size_t>(countV);
        return {static_cast<int>(place / row), static_cast<int>(place % row)};
    }
};

[[nodiscard]] inline NetSize netSizeOf(const NurbsSurface& surface)
{
    return {surface.countU(), surface.countV()};
}

// By i, then by j: the order in which a surface stores its points.
[[nodiscard]] inline bool comesBefore(ControlPointIndex a, ControlPointIndex b)
{
    return a.i != b.i ? a.i < b.i : a.j < b.j;
}

}  // namespace knotspan
