// Boxes by place: which of very many lie around a point. Each box stands in the few cells that it touches of
// a grid as coarse as it is large, so large and small ones do not get into each other's way.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "model/core/space.h"

namespace knotspan {

class BoxHash {
public:
    // A box that is not finite is left out, and found by nobody.
    void insert(std::uint32_t id, const Box& box)
    {
        forEachCell(box, [&](std::uint64_t cell, int level) {
            cells_[cell].push_back(id);
            ++levels_[level];
        });
    }

    // `box` is the one it was inserted with.
    void erase(std::uint32_t id, const Box& box)
    {
        forEachCell(box, [&](std::uint64_t cell, int level) {
            auto& ids = cells_[cell];
            ids.erase(std::find(ids.begin(), ids.end(), id));
            if (ids.empty())
                cells_.erase(cell);
            if (--levels_[level] == 0)
                levels_.erase(level);
        });
    }

    // visit(id) for all boxes around the point, and for others that are near it.
    template <class Visit>
    void near(const Vec3& point, const Visit& visit) const
    {
        for (const auto& [level, count] : levels_) {
            const double size = std::ldexp(1.0, level);
            const auto found = cells_.find(cellOf(level, std::floor(point.x / size),
                                                  std::floor(point.y / size), std::floor(point.z / size)));
            if (found != cells_.end())
                for (const std::uint32_t id : found->second)
                    visit(id);
        }
    }

private:
    // Cells that get the same number share their boxes, which costs time only.
    static std::uint64_t cellOf(int level, double x, double y, double z)
    {
        auto hash = static_cast<std::uint64_t>(level + 4096);
        for (const double number : {x, y, z}) {
            hash = (hash ^ std::bit_cast<std::uint64_t>(number + 0.0)) * 0x9e3779b97f4a7c15U;
            hash ^= hash >> 29;
        }
        return hash;
    }

    template <class Visit>
    static void forEachCell(const Box& box, const Visit& visit)
    {
        double extent = 0;
        double farthest = 0;
        for (int axis = 0; axis < 3; ++axis) {
            extent = std::max(extent, box.high[axis] - box.low[axis]);
            farthest = std::max({farthest, std::abs(box.low[axis]), std::abs(box.high[axis])});
        }
        if (!(std::isfinite(extent) && std::isfinite(farthest)))
            return;
        // Cells that doubles can count.
        const int level = std::max(exponent(extent) + 1, exponent(farthest) - 48);
        const double size = std::ldexp(1.0, level);
        const auto cell = [&](double coordinate) { return std::floor(coordinate / size); };
        for (double x = cell(box.low.x); x <= cell(box.high.x); ++x)
            for (double y = cell(box.low.y); y <= cell(box.high.y); ++y)
                for (double z = cell(box.low.z); z <= cell(box.high.z); ++z)
                    visit(cellOf(level, x, y, z), level);
    }

    static int exponent(double x) { return x > 1e-200 ? std::ilogb(x) + 1 : -660; }

    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
    std::map<int, size_t> levels_;
};

}  // namespace knotspan
