// Step 2 of the buffers of the path compute: where each group's part starts; and the indirect draw that follows.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "mesh_starts.glsl"

layout(set = 0, binding = BINDING_DRAWS, scalar) writeonly buffer DrawBuffer { IndexedDrawRecord indexedDraw; };

uvec2 countOf(uint group) { return meshGroups[group][0]; }
void startAt(uint group, uvec2 start) { meshGroups[group][1] = start; }

#include "../shared/scan.glsl"

void main()
{
    uvec2 total = scanGroups((heldTiles() + MESH_TILES - 1u) / MESH_TILES);
    if (gl_LocalInvocationID.x == 0u) {
        counters.meshVertices = total.x;
        counters.meshTriangles = total.y;
        counters.mostVertices = max(counters.mostVertices, total.x);
        counters.mostTriangles = max(counters.mostTriangles, total.y);
        bool room = total.x <= frame.vertexCapacity && total.y <= frame.triangleCapacity;
        indexedDraw = IndexedDrawRecord(room ? 3u * total.y : 0u, 1u, 0u, 0, 0u);
        if (room)
            countDice((total.y + 1u) / 2u, total.y, total.x);
    }
}
