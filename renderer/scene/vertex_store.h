// Vertices that the CPU made, and what of them has yet to travel to the device. Each grid has a place of its
// own among them, so that one that changes moves no other.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "shaders/shared/layouts.h"

namespace knotspan {

// u x v cells; vertex (i, j) is number first + i (v + 1) + j.
struct VertexGrid {
    std::uint32_t first = 0;
    std::uint32_t u = 0;  // 0: there is none
    std::uint32_t v = 0;

    [[nodiscard]] std::uint32_t vertexCount() const { return u == 0 ? 0 : (u + 1) * (v + 1); }
    [[nodiscard]] std::uint64_t cells() const { return std::uint64_t{u} * v; }
};

class VertexStore {
public:
    // Gives the grid's place back and takes one for u x v cells.
    void place(VertexGrid& grid, std::uint32_t u, std::uint32_t v);
    void clear();
    // Closes the gaps, where there is more of them than of vertices, or in any case.
    void compact(std::vector<VertexGrid>& grids, bool always = false);

    [[nodiscard]] gpu::ObjectVertex* at(const VertexGrid& grid) { return vertices_.data() + grid.first; }
    [[nodiscard]] const std::vector<gpu::ObjectVertex>& vertices() const { return vertices_; }

    struct Range {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };
    void changed(const VertexGrid& grid) { changed_.push_back({grid.first, grid.vertexCount()}); }
    void allChanged() { changed_ = {{0, static_cast<std::uint32_t>(vertices_.size())}}; }
    // In order and few: ranges that lie close are sent as one. They then count as sent.
    [[nodiscard]] std::vector<Range> takeChanged();

private:
    std::vector<gpu::ObjectVertex> vertices_;
    std::map<std::uint32_t, std::vector<std::uint32_t>> gaps_;  // by size: where they start
    size_t inGaps_ = 0;
    std::vector<Range> changed_;
};

}  // namespace knotspan
