// The geometry stage of the path geometry (RPNS' first variant): one point in, a whole tile out as triangle strips. A strip
// repeats the row it shares with the one before, so that a stage without shared memory evaluates it once and keeps it.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/grid_scene.glsl"
#include "drawn_vertex.glsl"
#include "surface_io.glsl"

layout(points) in;
layout(triangle_strip, max_vertices = GEOMETRY_VERTICES) out;

// Only what is written: all of it counts against the limit of components.
out gl_PerVertex { vec4 gl_Position; };

layout(location = 0) flat in uint inTile[];
SURFACE_OUT(ONE_VERTEX)

void emit(DrawnVertex vertex, uint ksquad)
{
    gl_Position = vertex.clip;
    outPosition = vertex.view;
    outNormal = vertex.normal;
    outT = vertex.t;
    outWeightedT = vertex.inverseWeight * vertex.t;
    outInverseWeight = vertex.inverseWeight;
    outKsquad = ksquad;
    EmitVertex();
}

void main()
{
    TileRecord tile = tiles[inTile[0]];
    uint cellsU = tile.cells & 0xffffu;
    uint cellsV = tile.cells >> 16u;
    DrawnVertex row[GEOMETRY_SIDE + 1u];
    for (uint i = 0u; i <= cellsU; ++i) {
        for (uint j = 0u; j <= cellsV; ++j) {
            GridVertex at = tileVertex(tile, i * (cellsV + 1u) + j);
            DrawnVertex vertex = drawnVertex(at, tile.ksquad);
            // From (i - 1, j) to (i, j): triangles are cut from (1, 0) to (0, 1), as SNAP_FALLING asks.
            if (i > 0u) {
                emit(row[j], tile.ksquad);
                emit(vertex, tile.ksquad);
            }
            row[j] = vertex;
        }
        EndPrimitive();
    }
    countDice(cellsU * cellsV, 2u * cellsU * cellsV, (cellsU + 1u) * (cellsV + 1u));
}
