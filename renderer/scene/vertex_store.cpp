#include "renderer/scene/vertex_store.h"

#include <algorithm>

#include "model/core/check.h"

namespace knotspan {

namespace {

constexpr std::uint32_t kCloseVertices = 64;  // sending what lies between costs less than a copy of its own
constexpr size_t kMostRanges = 512;
constexpr size_t kToleratedGaps = 1U << 14U;  // vertices

}  // namespace

void VertexStore::place(VertexGrid& grid, std::uint32_t u, std::uint32_t v)
{
    if (const std::uint32_t held = grid.vertexCount(); held > 0) {
        gaps_[held].push_back(grid.first);
        inGaps_ += held;
    }
    grid = {0, u, v};
    const std::uint32_t count = grid.vertexCount();
    if (count == 0)
        return;
    if (const auto gap = gaps_.find(count); gap != gaps_.end()) {
        grid.first = gap->second.back();
        gap->second.pop_back();
        if (gap->second.empty())
            gaps_.erase(gap);
        inGaps_ -= count;
        return;
    }
    check(vertices_.size() + count <= 0xffffffffU, "vertices have numbers of 32 bits");
    grid.first = static_cast<std::uint32_t>(vertices_.size());
    vertices_.resize(vertices_.size() + count);
}

void VertexStore::clear()
{
    *this = {};
}

void VertexStore::compact(std::vector<VertexGrid>& grids, bool always)
{
    if (inGaps_ == 0 || (!always && (inGaps_ < kToleratedGaps || 2 * inGaps_ < vertices_.size())))
        return;
    std::vector<gpu::ObjectVertex> kept;
    kept.reserve(vertices_.size() - inGaps_);
    for (VertexGrid& grid : grids)
        if (grid.u > 0) {
            const auto from = vertices_.begin() + grid.first;
            grid.first = static_cast<std::uint32_t>(kept.size());
            kept.insert(kept.end(), from, from + grid.vertexCount());
        }
    vertices_ = std::move(kept);
    gaps_.clear();
    inGaps_ = 0;
    allChanged();
}

std::vector<VertexStore::Range> VertexStore::takeChanged()
{
    std::vector<Range> ranges = std::move(changed_);
    changed_.clear();
    std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) { return a.first < b.first; });
    std::vector<Range> joined;
    for (const Range& range : ranges) {
        if (joined.empty() || range.first > joined.back().first + joined.back().count + kCloseVertices) {
            joined.push_back(range);
            continue;
        }
        Range& last = joined.back();
        last.count = std::max(last.first + last.count, range.first + range.count) - last.first;
    }
    if (joined.size() > kMostRanges)
        return {{joined.front().first, joined.back().first + joined.back().count - joined.front().first}};
    return joined;
}

}  // namespace knotspan
