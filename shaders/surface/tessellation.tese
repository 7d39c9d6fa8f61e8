// The evaluation stage of the path tessellation: the exact surface at each vertex that the tessellator made.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/grid_scene.glsl"
#include "drawn_vertex.glsl"
#include "surface_io.glsl"

layout(quads, equal_spacing, ccw) in;

layout(location = 0) flat in uint inTile[];
SURFACE_OUT(ONE_VERTEX)

void main()
{
    TileRecord tile = tiles[inTile[0]];
    DrawnGrid grid = gridOf(tile);
    vec2 cells = vec2(tile.cells & 0xffffu, tile.cells >> 16u);
    vec2 place = vec2(tile.first & 0xffffu, tile.first >> 16u) + gl_TessCoord.xy * cells;
    vec2 whole = round(place);
    GridVertex at;
    if (max(abs(place.x - whole.x), abs(place.y - whole.y)) > 0.25) {
        vec2 t = place / vec2(grid.u, grid.v);  // of the middle row that the tessellator made of a single one
        at = ownVertex(tile.ksquad, t);
    } else {
        at = gridVertex(tile.ksquad, grid, uint(whole.x), uint(whole.y), frame.snap);
    }
    DrawnVertex vertex = drawnVertex(at, tile.ksquad);
    gl_Position = vertex.clip;
    gl_CullDistance[0] = vertex.shown;
    outPosition = vertex.view;
    outNormal = vertex.normal;
    outT = vertex.t;
    outWeightedT = vertex.inverseWeight * vertex.t;
    outInverseWeight = vertex.inverseWeight;
    outKsquad = tile.ksquad;
}
