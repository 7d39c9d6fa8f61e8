// The control stage of the path tessellation-adaptive: the base cells of a tile.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/grid_scene.glsl"
#include "adaptive_grid.glsl"

layout(vertices = 1) out;

layout(location = 0) flat in uint inTile[];
layout(location = 0) flat out uint outTile[];

// How many lines of the base grid in a tile's direction lie inside the KSQuad.
uint innerLines(uint first, uint cells, uint gridCells)
{
    return cells + 1u - (first == 0u ? 1u : 0u) - (2u * (first + cells) >= gridCells ? 1u : 0u);
}

void main()
{
    uint index = inTile[0];
    outTile[gl_InvocationID] = index;
    BaseTile tile = baseTile(tiles[index]);
    vec2 cells = vec2(tile.cells);
    // In the tessellator's order: the sides u = 0, v = 0, u = 1, v = 1.
    gl_TessLevelOuter[0] = cells.y;
    gl_TessLevelOuter[1] = cells.x;
    gl_TessLevelOuter[2] = cells.y;
    gl_TessLevelOuter[3] = cells.x;
    gl_TessLevelInner[0] = cells.x;
    gl_TessLevelInner[1] = cells.y;

    DrawnGrid grid = drawnGrid(tiles[index].ksquad, frame.snap);
    uint evaluations = innerLines(tile.first.x, tile.cells.x, grid.u) * innerLines(tile.first.y, tile.cells.y, grid.v);
    if (evaluations > 0u)
        KNOTSPAN_COUNT(counters.evaluations, evaluations)
}
