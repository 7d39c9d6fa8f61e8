// The evaluation stage of the path tessellation-adaptive: the exact surface at the base grid's points inside a KSQuad. What
// lies on its border the geometry stage evaluates (adaptive_grid.glsl).
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/grid_scene.glsl"
#include "adaptive_grid.glsl"
#include "drawn_vertex.glsl"

layout(quads, equal_spacing, ccw) in;

layout(location = 0) flat in uint inTile[];
layout(location = 0) out vec3 outPosition;
layout(location = 1) out vec3 outNormal;
layout(location = 2) out vec2 outT;
layout(location = 4) out float outInverseWeight;
layout(location = 3) flat out uvec2 outPlace;  // the tile; the vertex of the drawn grid

void main()
{
    TileRecord tile = tiles[inTile[0]];
    DrawnGrid grid = drawnGrid(tile.ksquad, frame.snap);
    BaseTile base = baseTile(tile);
    vec2 line = gl_TessCoord.xy * vec2(base.cells);
    uvec2 place = min(2u * (base.first + uvec2(round(line))), uvec2(grid.u, grid.v));
    bool between = max(abs(line.x - round(line.x)), abs(line.y - round(line.y))) > 0.25;
    outPlace = uvec2(inTile[0], between ? NO_PLACE : packedPlace(place));
    gl_Position = vec4(0.0);
    outPosition = vec3(0.0);
    outNormal = vec3(0.0);
    outT = vec2(0.0);
    outInverseWeight = 0.0;
    if (between || onBorder(place, grid))
        return;
    GridVertex at = gridVertex(tile.ksquad, grid, place.x, place.y, frame.snap);
    DrawnVertex vertex = drawnVertex(at, tile.ksquad);
    gl_Position = vertex.clip;
    outPosition = vertex.view;
    outNormal = vertex.normal;
    outT = vertex.t;
    outInverseWeight = vertex.inverseWeight;
}
