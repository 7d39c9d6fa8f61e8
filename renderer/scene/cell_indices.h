// The index buffer of grids: those of rows of cells, so that all grids with as many cells in a row share
// them, whatever the number of rows.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "renderer/scene/vertex_store.h"

namespace knotspan {

class CellIndices {
public:
    // Makes what these grids need and is not there.
    void provide(const std::vector<VertexGrid>& grids);

    // Where the indices of a grid start: 6 for each cell, counted from the grid's first vertex.
    [[nodiscard]] std::uint32_t firstOf(const VertexGrid& grid) const { return rows_.at(grid.v).first; }
    [[nodiscard]] const std::vector<std::uint32_t>& indices() const { return indices_; }

    // From this one on they have yet to travel; they then count as sent.
    [[nodiscard]] std::uint32_t takeUnsent();
    void allUnsent() { sent_ = 0; }

private:
    struct Rows {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };
    std::map<std::uint32_t, Rows> rows_;  // by cells in a row
    std::vector<std::uint32_t> indices_;
    std::uint32_t sent_ = 0;
};

}  // namespace knotspan
