// The geometry stage of the path tessellation-adaptive (RPNS): looks at each triangle of a KSDie, here half of a base cell
// of up to 2 x 2 cells of the drawn grid, and splits it where it must be.
//
// By the bound: a base cell is drawn in all its cells, in two, or as it is, as adaptive_blocks.comp found enough. A side that
// two base cells share is split where either of them has a line there: both know that from the blocks alone. So nothing
// cracks. Triangles of the first kind are the drawn grid's own; others lie in their base cell or its half, which the bound
// was asked about, and more vertices on its sides make none of them larger.
// By lengths (area, edge): a side is split where it is too long on the screen (RPNS eq. 3) or its middle too far from the
// surface (eq. 4), which both triangles beside it find in the same numbers. Boundaries are oversampled (eq. 5) by
// drawnGrid() with SNAP_HALVES.
//
// The KSQuad's border is left to the edges' records: where those have as many vertices as the drawn grid, base cells
// split there; with half as many, they do not; beside all others they are drawn in all cells, as borders.glsl wants it.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/grid_scene.glsl"
#include "adaptive_grid.glsl"
#include "drawn_vertex.glsl"
#include "surface_io.glsl"

layout(triangles) in;
layout(triangle_strip, max_vertices = ADAPTIVE_VERTICES) out;

layout(set = 0, binding = BINDING_ADAPTIVE_BLOCKS, scalar) readonly buffer BlockBuffer { uint adaptiveBlocks[]; };

layout(location = 0) in vec3 inPosition[];
layout(location = 1) in vec3 inNormal[];
layout(location = 2) in vec2 inT[];
layout(location = 3) flat in uvec2 inPlace[];
layout(location = 4) in float inInverseWeight[];
SURFACE_OUT(ONE_VERTEX)

uint ksquad;
DrawnGrid grid;
uvec2 gridCells;
uint strict;   // a bit for each side beside which cells are drawn as they are
uvec2 cell;    // of the base grid
uvec2 size;    // in cells of the drawn grid
uint lines;    // drawn with: LINES_...
bool whole;    // drawn in all of its cells
bool lengths;  // a rule by lengths on screen

// The vertices of the base cell and between them, number x + 3 y.
DrawnVertex vertices[9];
uint made = 0u;
uint slotOf(uvec2 local) { return local.x + 3u * local.y; }

uint listed[ADAPTIVE_VERTICES];
uint count = 0u;

void list(uint a, uint b, uint c)
{
    listed[count] = a;
    listed[count + 1u] = b;
    listed[count + 2u] = c;
    count += 3u;
}

#define LINES_U 1u  // in the middle of u
#define LINES_V 2u
#define LINES_ALL 7u  // and in cells as borders.glsl has them

uint linesOf(uvec2 which)
{
    uvec2 first = 2u * which;
    uvec2 end = min(first + 2u, gridCells);
    uint beside = (first.x == 0u ? 1u << SIDE_START_U : 0u) | (end.x == gridCells.x ? 1u << SIDE_END_U : 0u) |
                  (first.y == 0u ? 1u << SIDE_START_V : 0u) | (end.y == gridCells.y ? 1u << SIDE_END_V : 0u);
    if ((beside & strict) != 0u || frame.samplingRule == RULE_FIXED)
        return LINES_ALL;
    if (lengths)
        return 0u;
    uvec2 block = min(2u * (first + end) / gridCells, uvec2(3u));
    return adaptiveBlocks[ksquad] >> 2u * (4u * block.x + block.y) & (LINES_U | LINES_V);
}

uint strictSides()
{
    uint sides = grid.divided;
    for (uint side = 0u; side < 4u; ++side) {
        uint cells = side < SIDE_START_V ? grid.v : grid.u;
        if (grid.edges[side] != cells && 2u * grid.edges[side] != cells)
            sides |= 1u << side;
    }
    return sides;
}

bool hasMiddle(uvec2 a, uvec2 b) { return ((a.x + b.x | a.y + b.y) & 1u) == 0u; }

#define SPLIT_NO 0u
#define SPLIT_YES 1u
#define SPLIT_ASK 2u  // by the lengths on screen

// Whether the side from a to b of the base cell or a part of it is split in its middle.
uint splitOf(uvec2 a, uvec2 b)
{
    if (!hasMiddle(a, b))
        return SPLIT_NO;
    if (a.x != b.x && a.y != b.y)
        return lengths ? SPLIT_ASK : SPLIT_NO;
    bool alongV = a.x == b.x;
    if (size == uvec2(2u) && (alongV ? a.x : a.y) == 1u)
        return SPLIT_NO;
    bool end = alongV ? a.x != 0u : a.y != 0u;
    uint at = 2u * (alongV ? cell.x : cell.y) + (end ? (alongV ? size.x : size.y) : 0u);
    uint across = alongV ? gridCells.x : gridCells.y;
    if (at == 0u || at == across) {
        uint side = (alongV ? 0u : 2u) + (end ? 1u : 0u);
        return grid.edges[side] == (alongV ? grid.v : grid.u) ? SPLIT_YES : SPLIT_NO;
    }
    uvec2 step = alongV ? uvec2(1u, 0u) : uvec2(0u, 1u);
    if (((lines | linesOf(end ? cell + step : cell - step)) & (alongV ? LINES_V : LINES_U)) != 0u)
        return SPLIT_YES;
    return lengths ? SPLIT_ASK : SPLIT_NO;
}

vec2 onScreen(vec4 clip) { return (0.5 * clip.xy / clip.w + 0.5) * frame.pixels; }

bool tooFar(uvec2 a, uvec2 b)
{
    vec4 from = vertices[slotOf(a)].clip;
    vec4 to = vertices[slotOf(b)].clip;
    vec4 exact = vertices[slotOf((a + b) / 2u)].clip;
    if (!(min(min(from.w, to.w), exact.w) > 0.0))
        return true;
    bool tooLong = (a.x == b.x || a.y == b.y) && distance(onScreen(from), onScreen(to)) > frame.diePx;
    return tooLong || distance(onScreen(from + to), onScreen(exact)) > frame.tolerancePx;
}

// The drawn grid's triangles in a part: cut from (1, 0) to (0, 1), as SNAP_FALLING asks. Where a base cell is one cell high,
// the first part takes both; where it is one cell alone, each part a triangle.
void listCells(uint part)
{
    if (size == uvec2(1u)) {
        if (part == 0u)
            list(slotOf(uvec2(0u)), slotOf(uvec2(1u, 0u)), slotOf(uvec2(0u, 1u)));
        else
            list(slotOf(uvec2(1u, 0u)), slotOf(uvec2(1u)), slotOf(uvec2(0u, 1u)));
        return;
    }
    if (part >= size.y)
        return;
    for (uint x = 0u; x < size.x; ++x) {
        uint slot = slotOf(uvec2(x, part));
        list(slot, slot + 1u, slot + 3u);
        list(slot + 1u, slot + 4u, slot + 3u);
    }
}

// A triangle or rectangle as it is, with the middles of those sides that are split: a fan from one of them, so that no
// triangle is flat.
struct Outline {
    uvec2 corners[4];
    uint count;
};

void listOutline(Outline outline, uint splits)
{
    uint around[7];
    uint points = 0u;
    uint from = 0u;
    for (uint k = outline.count; k-- > 0u;) {
        uvec2 a = outline.corners[k];
        uvec2 b = outline.corners[(k + 1u) % outline.count];
        if ((splits >> k & 1u) != 0u) {
            from = points;
            around[points++] = slotOf((a + b) / 2u);
        }
        around[points++] = slotOf(a);
    }
    for (uint k = 1u; k + 1u < points; ++k)
        list(around[from], around[(from + k + 1u) % points], around[(from + k) % points]);
}

void make(uint wanted)
{
    uint evaluated = 0u;
    for (uint slot = 0u; slot < 9u; ++slot) {
        if ((wanted & ~made & 1u << slot) == 0u)
            continue;
        uvec2 place = 2u * cell + uvec2(slot % 3u, slot / 3u);
        GridVertex at = gridVertex(ksquad, grid, place.x, place.y, frame.snap);
        vertices[slot] = drawnVertex(at, ksquad);
        ++evaluated;
    }
    made |= wanted;
    if (evaluated > 0u)
        KNOTSPAN_COUNT(counters.evaluations, evaluated)
}

void drawPart(uint part, Outline outline)
{
    count = 0u;
    uint wanted = 0u;
    uint splits = 0u;
    uint asked = 0u;
    if (whole) {
        listCells(part);
        for (uint k = 0u; k < count; ++k)
            wanted |= 1u << listed[k];
    } else {
        for (uint k = 0u; k < outline.count; ++k) {
            uvec2 a = outline.corners[k];
            uvec2 b = outline.corners[(k + 1u) % outline.count];
            uint split = splitOf(a, b);
            wanted |= 1u << slotOf(a) | (split != SPLIT_NO ? 1u << slotOf((a + b) / 2u) : 0u);
            splits |= split == SPLIT_YES ? 1u << k : 0u;
            asked |= split == SPLIT_ASK ? 1u << k : 0u;
        }
    }
    make(wanted);
    if (!whole) {
        for (uint k = 0u; k < outline.count; ++k)
            if ((asked >> k & 1u) != 0u && tooFar(outline.corners[k], outline.corners[(k + 1u) % outline.count]))
                splits |= 1u << k;
        listOutline(outline, splits);
    }
    for (uint k = 0u; k < count; ++k) {
        gl_Position = vertices[listed[k]].clip;
        gl_CullDistance[0] = vertices[listed[k]].shown;
        outPosition = vertices[listed[k]].view;
        outNormal = vertices[listed[k]].normal;
        outT = vertices[listed[k]].t;
        outWeightedT = vertices[listed[k]].inverseWeight * vertices[listed[k]].t;
        outInverseWeight = vertices[listed[k]].inverseWeight;
        outKsquad = ksquad;
        EmitVertex();
        if (k % 3u == 2u)
            EndPrimitive();
    }
    uint dice = whole ? size.x * size.y : (lines != 0u ? 2u : 1u);
    countDice(part == 0u ? dice : 0u, count / 3u, 0u);
}

void main()
{
    TileRecord tile = tiles[inPlace[0].x];
    BaseTile base = baseTile(tile);
    ksquad = tile.ksquad;
    grid = drawnGrid(ksquad, frame.snap);
    gridCells = uvec2(grid.u, grid.v);
    strict = strictSides();
    lengths = frame.samplingRule == RULE_AREA || frame.samplingRule == RULE_EDGE;
    bool row = isRow(base);

    // Of a row, the points on its first long side.
    uint counts = 0u;
    uvec2 least = uvec2(NO_PLACE);
    for (uint k = 0u; k < 3u; ++k) {
        uvec2 place = unpackedPlace(inPlace[k].y);
        bool along = base.cells.x == 1u ? place.x == 2u * base.first.x : place.y == 2u * base.first.y;
        if (inPlace[k].y == NO_PLACE || row && !along)
            continue;
        ++counts;
        least = min(least, place);
    }
    if (row && counts < 2u)
        return;
    cell = least / 2u;
    size = min(2u * cell + 2u, gridCells) - 2u * cell;
    lines = linesOf(cell);
    uint possible = (size.x == 2u ? LINES_U : 0u) | (size.y == 2u ? LINES_V : 0u);
    whole = lines == LINES_ALL || !lengths && (lines & possible) == possible;
    lines &= possible;
    bool halvesU = !whole && lines == LINES_U;
    bool halvesV = !whole && lines == LINES_V;

    Outline outline;
    outline.count = halvesU || halvesV ? 4u : 3u;
    uint low = 0u;
    for (uint k = 0u; k < 3u; ++k) {
        uvec2 corner = unpackedPlace(inPlace[k].y) - 2u * cell;
        outline.corners[k] = corner;
        low += (halvesU ? corner.x : corner.y) == 0u ? 1u : 0u;
        if (row || onBorder(corner + 2u * cell, grid))
            continue;
        uint slot = slotOf(corner);
        vertices[slot] = DrawnVertex(gl_in[k].gl_Position, inPosition[k], inNormal[k], inT[k],
                                     inInverseWeight[k],
                                     shownTowards(ksquads[ksquad].surface, inPosition[k], inNormal[k]));
        made |= 1u << slot;
    }
    // Of a triangle the part on whose outer side it lies: those corners have been evaluated.
    uint first = row || low == 2u ? 0u : 1u;
    uint last = row || low != 2u ? 1u : 0u;
    for (uint part = first; part <= last; ++part) {
        if (halvesU || halvesV) {
            uvec2 from = halvesU ? uvec2(part, 0u) : uvec2(0u, part);
            uvec2 to = from + (halvesU ? uvec2(1u, 2u) : uvec2(2u, 1u));
            outline.corners[0] = from;
            outline.corners[1] = uvec2(to.x, from.y);
            outline.corners[2] = to;
            outline.corners[3] = uvec2(from.x, to.y);
        } else if (row) {
            outline.corners[0] = part == 0u ? uvec2(0u) : size;
            outline.corners[1] = part == 0u ? uvec2(size.x, 0u) : uvec2(0u, size.y);
            outline.corners[2] = part == 0u ? uvec2(0u, size.y) : uvec2(size.x, 0u);
        }
        drawPart(part, outline);
    }
}
