// The geometry stage of the path geometry (RPNS' first variant): one point in, a whole tile out as triangle strips. A strip
// of cells repeats the row it shares with the one before, a ring gives out each triangle by itself, so that a stage without
// shared memory evaluates every vertex once and keeps it.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/tiles.glsl"
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
    DrawnGrid grid = gridOf(tile);
    RingPart ring = ringOf(tile, grid);
    TileSize size = sizeOf(tile);
    bool isRing = size.insideVertices == 0u;
    bool clockwise = runsClockwise(grid);
    // Of cells: the row before. Of a ring: the latest vertices of its outer and its inner chain.
    DrawnVertex held[GEOMETRY_SIDE + 1u];
    RingTriangle triangle = RingTriangle(0u, 0u, false);
    for (uint k = 0u; k < size.vertices; ++k) {
        uint number = k;
        if (isRing) {
            // The chains' first vertices, then the one that each triangle steps to.
            if (k > 1u)
                triangle = ringTriangle(tile.ksquad, grid, ring, k - 2u);
            uint outer = k > 1u ? triangle.outer + 1u - ring.outer : 0u;
            uint inner = ring.outerSteps + 1u + (k > 1u ? triangle.inner + 1u - ring.inner : 0u);
            number = k == 0u || k > 1u && triangle.stepsOuter ? outer : inner;
        }
        DrawnVertex vertex = drawnVertex(tileVertex(tile, number), tile.ksquad);
        if (!isRing) {
            // From (i - 1, j) to (i, j): triangles are cut from (1, 0) to (0, 1).
            uint j = k % size.row;
            if (k >= size.row) {
                emit(held[j], tile.ksquad);
                emit(vertex, tile.ksquad);
                if (j + 1u == size.row)
                    EndPrimitive();
            }
            held[j] = vertex;
            continue;
        }
        if (k > 1u) {
            emit(held[0], tile.ksquad);
            if (clockwise)
                emit(held[1], tile.ksquad);
            emit(vertex, tile.ksquad);
            if (!clockwise)
                emit(held[1], tile.ksquad);
            EndPrimitive();
        }
        held[k == 0u || k > 1u && triangle.stepsOuter ? 0u : 1u] = vertex;
    }
    countDice((size.triangles + 1u) / 2u, size.triangles, size.vertices);
}
