// Step 2 of the list of tiles: where each group's part starts, the exclusive sum of the groups' counts, by one group of
// threads in slices; and the indirect draws that follow from the total.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/counters.glsl"

layout(local_size_x = SCAN_THREADS) in;

layout(set = 0, binding = BINDING_TILE_GROUPS, scalar) buffer GroupBuffer { uint groups[][2]; };
layout(set = 0, binding = BINDING_DRAWS, scalar) writeonly buffer DrawBuffer { DrawRecord draws[]; };

shared uint sums[SCAN_THREADS];

void main()
{
    uint lane = gl_LocalInvocationID.x;
    uint groupCount = (counters.drawn + TILE_KSQUADS - 1u) / TILE_KSQUADS;
    uint slice = (groupCount + SCAN_THREADS - 1u) / SCAN_THREADS;
    uint begin = min(lane * slice, groupCount);
    uint end = min(begin + slice, groupCount);

    uint sum = 0u;
    for (uint group = begin; group < end; ++group)
        sum += groups[group][0];
    sums[lane] = sum;
    barrier();
    uint start = 0u;
    uint total = 0u;
    for (uint other = 0u; other < SCAN_THREADS; ++other) {
        start += other < lane ? sums[other] : 0u;
        total += sums[other];
    }
    for (uint group = begin; group < end; ++group) {
        groups[group][1] = start;
        start += groups[group][0];
    }

    uint held = min(total, frame.tileCapacity);
    if (frame.taskTiles != 0u) {
        // Groups of a task stage, in two dimensions, because one holds only 65,535.
        uint groupsOfTasks = (held + frame.taskTiles - 1u) / frame.taskTiles;
        uint x = clamp(groupsOfTasks, 1u, 65535u);
        if (lane == 0u)
            draws[0] = DrawRecord(groupsOfTasks == 0u ? 0u : x, (groupsOfTasks + x - 1u) / x, 1u, 0u);
    } else {
        uint drawCount = (frame.tileCapacity + frame.tilesPerDraw - 1u) / frame.tilesPerDraw;
        for (uint draw = lane; draw < drawCount; draw += SCAN_THREADS) {
            uint first = draw * frame.tilesPerDraw;
            draws[draw] = DrawRecord(min(frame.tilesPerDraw, held - min(first, held)), 1u, first, 0u);
        }
    }
    if (lane == 0u)
        counters.tiles = total;
}
