// The base grid of the path tessellation-adaptive: cells of up to 2 x 2 of the drawn grid's (borders.glsl). Its lines are
// the drawn grid's even ones and the last, whatever tile they are drawn in; tiles start at even ones.
//
// Who evaluates what: the evaluation stage all points of the base grid that are inside the KSQuad, the geometry stage
// those between them and all on the KSQuad's border. So no point is ever computed by two stages, whose bits need not agree.

// A tile of the base grid.
struct BaseTile {
    uvec2 first;  // base cell
    uvec2 cells;
};

BaseTile baseTile(TileRecord tile)
{
    uvec2 cells = uvec2(tile.cells & 0xffffu, tile.cells >> 16u);
    return BaseTile(uvec2(tile.first & 0xffffu, tile.first >> 16u) / 2u, (cells + 1u) / 2u);
}

// A row of one cell. The tessellator puts lines of its own into it (Vulkan, "Quad Tessellation"): of its triangles only
// those count that have a side on the row's first long side, one for each cell.
bool isRow(BaseTile tile) { return min(tile.cells.x, tile.cells.y) == 1u && max(tile.cells.x, tile.cells.y) > 1u; }

// A point of the tessellator's as a vertex (i, j) of the drawn grid; NO_PLACE between the lines.
#define NO_PLACE 0xffffffffu
uint packedPlace(uvec2 place) { return place.x | place.y << 16u; }
uvec2 unpackedPlace(uint place) { return uvec2(place & 0xffffu, place >> 16u); }

bool onBorder(uvec2 place, DrawnGrid grid)
{
    return place.x == 0u || place.y == 0u || place.x == grid.u || place.y == grid.v;
}
