// Notes down the vertices of the path cpu, each once: its vertex stage sees them as often as triangles share them.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/counters.glsl"

layout(local_size_x = MESH_ITEMS) in;

layout(set = 0, binding = BINDING_VERTICES, scalar) readonly buffer VertexBuffer { ObjectVertex vertices[]; };

void main()
{
    uint index = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * MESH_ITEMS + gl_LocalInvocationID.x;
    if (index >= frame.vertexCapacity)
        return;
    ObjectVertex vertex = vertices[index];
    vec4 clip = toClip(toView(ksquads[vertex.source].surface, vertex.position));
    captureVertex(CapturedRecord(vertex.ksquad, vertex.t, vertex.source, vertex.position, vertex.normal, clip));
}
