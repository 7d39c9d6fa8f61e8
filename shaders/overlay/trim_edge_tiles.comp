// A group for each tile: whether borders of trimmed surfaces run in it or beside it, and so may reach into it.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "drawn_pixels.glsl"

layout(local_size_x = TRIM_TILE_THREADS) in;

void main()
{
    const uint kSide = uint(TRIM_TILE + 2);
    uint tile = gl_WorkGroupID.x + gl_NumWorkGroups.x * gl_WorkGroupID.y;
    ivec2 first = ivec2(tile % tilesAcross, tile / tilesAcross) * TRIM_TILE - 1;
    if (first.y >= size.y)
        return;
    uint all = 0xffu;
    for (uint k = gl_LocalInvocationID.x; k < kSide * kSide; k += uint(TRIM_TILE_THREADS)) {
        ivec2 pixel = clamp(first + ivec2(k % kSide, k / kSide), ivec2(0), size - 1);
        all &= colourAt(pixel) >> 24;
    }
    if (all != 0xffu)
        drawn[firstTile() + tile] = 1u;
}
