// Step 2 of the buffers of the path compute: where each group's part starts, by one group of threads in slices; and the
// indirect draw that follows.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "mesh_starts.glsl"

layout(local_size_x = SCAN_THREADS) in;

layout(set = 0, binding = BINDING_DRAWS, scalar) writeonly buffer DrawBuffer { IndexedDrawRecord indexedDraw; };

shared uvec2 sums[SCAN_THREADS];

void main()
{
    uint lane = gl_LocalInvocationID.x;
    uint groupCount = (heldTiles() + MESH_TILES - 1u) / MESH_TILES;
    uint slice = (groupCount + SCAN_THREADS - 1u) / SCAN_THREADS;
    uint begin = min(lane * slice, groupCount);
    uint end = min(begin + slice, groupCount);
    uvec2 sum = uvec2(0u);
    for (uint group = begin; group < end; ++group)
        sum += meshGroups[group][0];
    sums[lane] = sum;
    barrier();
    uvec2 start = uvec2(0u);
    uvec2 total = uvec2(0u);
    for (uint other = 0u; other < SCAN_THREADS; ++other) {
        start += other < lane ? sums[other] : uvec2(0u);
        total += sums[other];
    }
    for (uint group = begin; group < end; ++group) {
        meshGroups[group][1] = start;
        start += meshGroups[group][0];
    }
    if (lane == 0u) {
        counters.meshVertices = total.x;
        counters.meshTriangles = total.y;
        bool room = total.x <= frame.vertexCapacity && total.y <= frame.triangleCapacity;
        indexedDraw = IndexedDrawRecord(room ? 3u * total.y : 0u, 1u, 0u, 0, 0u);
        if (room)
            countDice((total.y + 1u) / 2u, total.y, total.x);
    }
}
