// Macri's (1999) uniform evaluation: every surface as one grid of n x n cells over the whole of its domain,
// whatever the view and its neighbours. Vertices carry parameters counted in spans (FRAME_SPANS).
#pragma once

#include "renderer/scene/packed_scene.h"
#include "renderer/scene/vertex_store.h"

namespace knotspan {

class UniformGrids {
public:
    // Evaluates the surfaces that are not as they were. Returns the number of vertices made.
    std::uint64_t update(const std::vector<Resident>& residents, std::uint32_t cells);
    void clear() { *this = {}; }

    [[nodiscard]] const std::vector<VertexGrid>& grids() const { return grids_; }  // by surface
    [[nodiscard]] VertexStore& store() { return store_; }
    [[nodiscard]] const VertexStore& store() const { return store_; }
    void closeGaps() { store_.compact(grids_, true); }

private:
    std::vector<Resident> made_;  // what the vertices are of
    std::vector<VertexGrid> grids_;
    VertexStore store_;
};

}  // namespace knotspan
