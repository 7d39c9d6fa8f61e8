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

uint nearestTo(ivec2 pixel) { return pickedAt(clamp(pixel, ivec2(0), size - 1)); }

bool meetsAnother(ivec2 pixel)
{
    uint here = pickedAt(pixel);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            if (meets(here, nearestTo(pixel + ivec2(x, y))))
                return true;
    return false;
}

// Of four pixels beside each other those with a bit.
void list(ivec2 first, uint bits)
{
    const uint kThreads = uint(TRIM_LIST_THREADS);
    uint count = uint(bitCount(bits));
    uint place = atomicAdd(drawn[TRIM_HEAD_COUNT], count);
    // Whose first pixel it is asks for a group.
    uint groups = (place + count + kThreads - 1u) / kThreads;
    if (groups != (place + kThreads - 1u) / kThreads)
        atomicMax(drawn[0], min(groups, uint(TRIM_LIST_GROUPS)));
    for (; bits != 0u; bits &= bits - 1u)
        drawn[firstListed() + place++] = uint(first.x + findLSB(bits)) | uint(first.y) << 16u;
}

// Four pixels beside each other, and the ones left and right of them.
struct Row {
    uint left;
    uvec4 four;
    uint right;
};

Row rowAt(ivec2 at)
{
    return Row(nearestTo(at - ivec2(1, 0)),
               uvec4(nearestTo(at), nearestTo(at + ivec2(1, 0)), nearestTo(at + ivec2(2, 0)),
                     nearestTo(at + ivec2(3, 0))),
               nearestTo(at + ivec2(4, 0)));
}

// Whether another KSQuad shows there, or beside it in that row.
bvec4 differ(uvec4 here, Row row)
{
    uvec4 other = (here ^ row.four) | (here ^ uvec4(row.left, row.four.xyz)) | (here ^ uvec4(row.four.yzw, row.right));
    return notEqual(other, uvec4(0u));
}

// Each thread goes down four columns: what it holds it needs not read again.
void main()
{
    uint tilesAcross = uint(size.x + TRIM_TILE_WIDTH - 1) / uint(TRIM_TILE_WIDTH);
    uint tile = gl_WorkGroupID.x + gl_NumWorkGroups.x * gl_WorkGroupID.y;
    const int kAcross = TRIM_TILE_WIDTH / 4;
    const int kRows = TRIM_TILE_HEIGHT * kAcross / TRIM_TILE_THREADS;
    int thread = int(gl_LocalInvocationID.x);
    ivec2 at = ivec2(tile % tilesAcross, tile / tilesAcross) * ivec2(TRIM_TILE_WIDTH, TRIM_TILE_HEIGHT) +
               ivec2(thread % kAcross * 4, thread / kAcross * kRows);
    int end = min(at.y + kRows, size.y);
    if (at.x >= size.x)
        return;
    Row above = rowAt(at - ivec2(0, 1));
    Row row = rowAt(at);
    for (; at.y < end; ++at.y) {
        Row below = rowAt(at + ivec2(0, 1));
        uvec4 differs = uvec4(differ(row.four, above)) | uvec4(differ(row.four, row)) | uvec4(differ(row.four, below));
        uint bits = 0u;
        if (differs != uvec4(0u))
            for (int k = 0; k < 4; ++k)
                if (differs[k] != 0u && at.x + k < size.x && meetsAnother(at + ivec2(k, 0)))
                    bits |= 1u << k;
        if (bits != 0u)
            list(at, bits);
        above = row;
        row = below;
    }
}
