// Step 4 of the path compute: each vertex, the exact surface, into the vertex buffer.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "mesh_starts.glsl"
#include "drawn_vertex.glsl"
#include "mesh_item.glsl"

layout(local_size_x = MESH_ITEMS) in;

layout(set = 0, binding = BINDING_VERTICES, scalar) writeonly buffer VertexBuffer { VertexRecord vertices[]; };

void main()
{
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint item = group * MESH_ITEMS + gl_LocalInvocationID.x;
    if (item >= counters.meshVertices || counters.meshVertices > frame.vertexCapacity)
        return;
    uint index = tileOfItem(item, false);
    TileRecord tile = tiles[index];
    uint local = item - (index == 0u ? 0u : ends[index - 1u].x);
    GridVertex at = tileVertex(tile, local);
    DrawnVertex vertex = drawnVertex(at, tile.ksquad);
    vertices[item] = VertexRecord(vertex.clip, vertex.view, vertex.normal, vertex.t, tile.ksquad,
                                  vertex.inverseWeight);
}
