#include "renderer/scene/cell_indices.h"

#include <algorithm>

namespace knotspan {

namespace {

constexpr std::uint32_t kRowsAtOnce = 8;       // a grid that grows a little finds its rows there
constexpr size_t kMostKept = size_t{1} << 22;  // indices; beyond, those of grids that are gone go

}  // namespace

void CellIndices::provide(const std::vector<VertexGrid>& grids)
{
    if (indices_.size() > kMostKept)
        *this = {};
    std::map<std::uint32_t, std::uint32_t> wanted;
    for (const VertexGrid& grid : grids)
        if (grid.u > 0)
            wanted[grid.v] = std::max(wanted[grid.v], grid.u);
    for (const auto& [cells, rows] : wanted) {
        Rows& held = rows_[cells];
        if (held.count >= rows)
            continue;
        held = {static_cast<std::uint32_t>(indices_.size()),
                (rows + kRowsAtOnce - 1) / kRowsAtOnce * kRowsAtOnce};
        const std::uint32_t next = cells + 1;
        for (std::uint32_t i = 0; i < held.count; ++i)
            for (std::uint32_t j = 0; j < cells; ++j) {
                // Cut from (1, 0) to (0, 1), as SNAP_FALLING asks for.
                const std::uint32_t corner = i * next + j;
                indices_.insert(indices_.end(), {corner, corner + next, corner + 1, corner + next,
                                                 corner + next + 1, corner + 1});
            }
    }
}

std::uint32_t CellIndices::takeUnsent()
{
    const std::uint32_t first = sent_;
    sent_ = static_cast<std::uint32_t>(indices_.size());
    return first;
}

}  // namespace knotspan
