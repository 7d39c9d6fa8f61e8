// The geometry stages of the path geometry.
#include "../shared/tiles.glsl"
#include "drawn_vertex.glsl"
#include "surface_io.glsl"

layout(points) in;
layout(triangle_strip, max_vertices = GEOMETRY_VERTICES) out;

// Only what is written: all of it counts against the limit of components.
out gl_PerVertex
{
    vec4 gl_Position;
    float gl_CullDistance[1];
};

layout(location = 0) flat in uint inTile[];
SURFACE_OUT(ONE_VERTEX)

void emit(DrawnVertex vertex, uint ksquad)
{
    gl_Position = vertex.clip;
    gl_CullDistance[0] = vertex.shown;
    outPosition = vertex.view;
    outNormal = vertex.normal;
    outT = vertex.t;
    outWeightedT = vertex.inverseWeight * vertex.t;
    outInverseWeight = vertex.inverseWeight;
    outKsquad = ksquad;
    EmitVertex();
}

#ifdef KNOTSPAN_EVS
#include "../culling/evs.glsl"
uint beyondOf(DrawnVertex vertex) { return vertexBeyond(vertex.clip, vertex.shown); }
#else
uint beyondOf(DrawnVertex vertex) { return 0u; }
#endif

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
    DrawnVertex before[2];  // of cells: the pair of vertices that the strip goes on from
    uint beyondBefore = 0u;
    bool open = false;
    uint culled = 0u;
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
            // From (i - 1, j) to (i, j): triangles are cut from (1, 0) to (0, 1). A cell that is not shown ends the strip.
            uint j = k % size.row;
            if (k >= size.row) {
                uint beyond = beyondOf(held[j]) & beyondOf(vertex);
                bool shows = j > 0u && (beyond & beyondBefore) == 0u;
                if (shows && !open) {
                    emit(before[0], tile.ksquad);
                    emit(before[1], tile.ksquad);
                }
                if (shows) {
                    emit(held[j], tile.ksquad);
                    emit(vertex, tile.ksquad);
                } else if (j > 0u) {
                    culled += 2u;
                }
                if (open && !shows || shows && j + 1u == size.row)
                    EndPrimitive();
                open = shows && j + 1u < size.row;
                before[0] = held[j];
                before[1] = vertex;
                beyondBefore = beyond;
            }
            held[j] = vertex;
            continue;
        }
        bool shows = k > 1u && (beyondOf(held[0]) & beyondOf(held[1]) & beyondOf(vertex)) == 0u;
        culled += k > 1u && !shows ? 1u : 0u;
        if (shows) {
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
    if (culled > 0u)
        KNOTSPAN_COUNT(counters.trianglesCulled, culled)
}
