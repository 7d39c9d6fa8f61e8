// Step 1 of the list of tiles: how many each visible KSQuad's grid is cut into, and their sum for each group of KSQuads.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "tile_cut.glsl"

layout(local_size_x = LIST_KSQUADS) in;

layout(set = 0, binding = BINDING_TILE_COUNTS, scalar) writeonly buffer CountBuffer { uint tileCounts[]; };
layout(set = 0, binding = BINDING_TILE_GROUPS, scalar) buffer GroupBuffer { uint groups[][2]; };

// Of the border sides of a drawn grid that have a friend, which without it would have twice as many cells.
uint samplesSaved(uint ksquad, DrawnGrid grid)
{
    SurfacePlace place = placeOf(ksquad);
    uint saved = 0u;
    for (uint side = 0u; side < 4u; ++side) {
        if (innerNeighbour(place, ksquad, side) != NO_SIDE)
            continue;
        uint flags = borderSides[borderSideIndex(place, side)].flags;
        if ((flags & BORDER_FRIEND) != 0u && (flags & BORDER_KIND) != BORDER_COLLAPSED)
            saved += grid.edges[side];
    }
    return saved;
}

void main()
{
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint index = group * LIST_KSQUADS + gl_LocalInvocationID.x;
    if (index >= counters.visible)
        return;
    uint ksquad = visible[index];
    uint count = 0u;
    if ((grids[ksquad].alongU | grids[ksquad].alongV) != 0u) {
        DrawnGrid grid = drawnGrid(ksquad, frame.snap);
        count = tileCount(tileCut(grid));
        KNOTSPAN_COUNT(counters.normalsShared, sharedNormals(ksquad, grid))
        if ((frame.flags & FRAME_OVERSAMPLE_STRANGERS) != 0u && (frame.flags & FRAME_OVERSAMPLE_FRIENDS) == 0u)
            KNOTSPAN_COUNT(counters.samplesSaved, samplesSaved(ksquad, grid))
    }
    tileCounts[index] = count;
    atomicAdd(groups[group][0], count);
}
