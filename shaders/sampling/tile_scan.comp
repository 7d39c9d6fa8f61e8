// Step 2 of the list of tiles: where each group's part starts, and the indirect draws that follow from the
// total.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/counters.glsl"

layout(set = 0, binding = BINDING_TILE_GROUPS, scalar) buffer GroupBuffer { uint groups[][2]; };
layout(set = 0, binding = BINDING_DRAWS, scalar) writeonly buffer DrawBuffer { DrawRecord draws[]; };

uvec2 countOf(uint group) { return uvec2(groups[group][0], 0u); }
void startAt(uint group, uvec2 start) { groups[group][1] = start.x; }

#include "../shared/scan.glsl"

void main()
{
    uint lane = gl_LocalInvocationID.x;
    uint total = scanGroups((counters.visible + LIST_KSQUADS - 1u) / LIST_KSQUADS).x;
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
    if (lane == 0u) {
        counters.tiles = total;
        counters.mostTiles = max(counters.mostTiles, total);
    }
}
