// The parts of KSQuads' drawn grids with rings (SNAP_RING): what they are, their vertices and their triangles.
#ifndef KNOTSPAN_TILES_GLSL
#define KNOTSPAN_TILES_GLSL

#include "grid_scene.glsl"
#include "ring.glsl"

#define TILE_KINDS (TILE_RING | TILE_WHOLE)

RingPart ringOf(TileRecord tile, DrawnGrid grid)
{
    if ((tile.grid & TILE_WHOLE) != 0u)
        return wholeRing(grid);
    return RingPart(tile.first, tile.cells >> 16u, tile.cells & 0xffu, tile.cells >> 8u & 0xffu);
}

// What a tile is made of.
struct TileSize {
    uint vertices;
    uint triangles;
    uint insideTriangles;  // of those, the first ones: of the cells of a grid, two each
    uint row;              // vertices in a row of that grid, along v
    uint insideVertices;   // of it
};

TileSize sizeOf(TileRecord tile)
{
    TileSize size = TileSize(0u, 0u, 0u, 1u, 0u);
    if ((tile.grid & TILE_KINDS) == 0u) {
        size.row = (tile.cells >> 16u) + 1u;
        size.insideVertices = ((tile.cells & 0xffffu) + 1u) * size.row;
        size.insideTriangles = 2u * (tile.cells & 0xffffu) * (tile.cells >> 16u);
        size.vertices = size.insideVertices;
        size.triangles = size.insideTriangles;
        return size;
    }
    DrawnGrid grid = gridOf(tile);
    RingPart ring = ringOf(tile, grid);
    bool whole = (tile.grid & TILE_WHOLE) != 0u;
    if (whole && hasInside(grid)) {
        // The ring's inner vertices are the inside's, and its outer chain closes.
        size.row = grid.v - 1u;
        size.insideVertices = insideVertices(grid);
        size.insideTriangles = 2u * insideCells(grid);
        size.vertices = size.insideVertices + ring.outerSteps;
    } else {
        size.vertices = ring.outerSteps + 1u + ring.innerSteps + 1u;
    }
    size.triangles = size.insideTriangles + ring.outerSteps + ring.innerSteps;
    return size;
}

// Vertex number k of a tile. Of a grid: u outer. Of a ring: the outer chain's, then the inner one's, if it is not the grid's.
GridVertex tileVertex(TileRecord tile, uint k)
{
    DrawnGrid grid = gridOf(tile);
    bool isRing = (tile.grid & TILE_KINDS) != 0u;
    TileSize size = sizeOf(tile);
    if (k < size.insideVertices) {
        uvec2 first = isRing ? uvec2(1u) : uvec2(tile.first & 0xffffu, tile.first >> 16u);
        uint i = first.x + k / size.row;
        uint j = first.y + k % size.row;
        return insideVertex(tile.ksquad, grid, i, j);
    }
    RingPart ring = ringOf(tile, grid);
    k -= size.insideVertices;
    bool outer = k <= ring.outerSteps;
    return chainVertex(tile.ksquad, grid, outer, outer ? ring.outer + k : ring.inner + k - ring.outerSteps - 1u);
}

// Triangle number k of a tile, counterclockwise in the parameters: its vertices' numbers.
uvec3 tileTriangle(TileRecord tile, uint k)
{
    TileSize size = sizeOf(tile);
    if (k < size.insideTriangles) {
        uint cell = k / 2u;
        uint along = size.row - 1u;
        uint corner = cell / along * size.row + cell % along;
        return (k & 1u) == 0u ? uvec3(corner, corner + size.row, corner + 1u)
                              : uvec3(corner + size.row, corner + size.row + 1u, corner + 1u);
    }
    DrawnGrid grid = gridOf(tile);
    RingPart ring = ringOf(tile, grid);
    RingTriangle triangle = ringTriangle(tile.ksquad, grid, ring, k - size.insideTriangles);
    bool closes = size.insideVertices > 0u;
    uint outer = size.insideVertices + triangle.outer - ring.outer;
    uint nextOuter = outer + 1u;
    uint inner = size.insideVertices + ring.outerSteps + 1u + triangle.inner - ring.inner;
    uint nextInner = inner + 1u;
    if (closes) {
        nextOuter = triangle.outer + 1u == ring.outerSteps ? size.insideVertices : nextOuter;
        outer = triangle.outer == ring.outerSteps ? size.insideVertices : outer;
        uvec2 at = innerPlace(grid, triangle.inner) - 1u;
        inner = at.x * size.row + at.y;
        at = innerPlace(grid, triangle.inner + 1u) - 1u;
        nextInner = at.x * size.row + at.y;
    }
    uvec3 corners = triangle.stepsOuter ? uvec3(outer, nextOuter, inner) : uvec3(outer, nextInner, inner);
    return runsClockwise(grid) ? corners.xzy : corners;
}

#endif
