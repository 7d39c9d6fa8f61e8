// A group for each tile: lists its pixels where a trimmed surface shows beside something else.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "drawn_pixels.glsl"
#include "../shared/trimming_words.glsl"

layout(local_size_x = TRIM_TILE_THREADS) in;

bool isTrimmed(uint picked) { return picked != 0u && trimWords[picked - 1u] != TRIM_WHOLE; }

bool meets(uint here, uint beside)
{
    if (here == beside || (here != 0u && beside != 0u && ksquads[beside - 1u].surface == ksquads[here - 1u].surface))
        return false;
    return isTrimmed(here) || isTrimmed(beside);
}

bool meetsAny(uint here, uvec3 beside)
{
    return any(notEqual(beside, uvec3(here))) &&
           (meets(here, beside.x) || meets(here, beside.y) || meets(here, beside.z));
}

// Three beside each other; the picture's own border is none of a surface.
uvec3 rowAt(ivec2 pixel)
{
    int y = clamp(pixel.y, 0, size.y - 1);
    return uvec3(pickedAt(ivec2(max(pixel.x - 1, 0), y)), pickedAt(ivec2(pixel.x, y)),
                 pickedAt(ivec2(min(pixel.x + 1, size.x - 1), y)));
}

void list(ivec2 pixel)
{
    uint head = firstListed();
    uint place = atomicAdd(drawn[head + 3u], 1u);
    drawn[head + uint(TRIM_LIST_HEAD) + place] = uint(pixel.x) | uint(pixel.y) << 16u;
    atomicMax(drawn[head], min(place / uint(TRIM_LIST_THREADS) + 1u, uint(TRIM_LIST_GROUPS)));
}

// Each thread looks at a part of a column.
void main()
{
    const int kRows = TRIM_TILE * TRIM_TILE / TRIM_TILE_THREADS;
    uint tilesAcross = uint(size.x + TRIM_TILE - 1) / uint(TRIM_TILE);
    uint tile = gl_WorkGroupID.x + gl_NumWorkGroups.x * gl_WorkGroupID.y;
    int thread = int(gl_LocalInvocationID.x);
    ivec2 at = ivec2(tile % tilesAcross, tile / tilesAcross) * TRIM_TILE + ivec2(thread % TRIM_TILE, thread / TRIM_TILE * kRows);
    int end = min(at.y + kRows, size.y);
    if (at.x >= size.x)
        return;
    uvec3 above = rowAt(at - ivec2(0, 1));
    uvec3 row = rowAt(at);
    for (; at.y < end; ++at.y) {
        uvec3 below = rowAt(at + ivec2(0, 1));
        if (meetsAny(row.y, above) || meetsAny(row.y, row) || meetsAny(row.y, below))
            list(at);
        above = row;
        row = below;
    }
}
