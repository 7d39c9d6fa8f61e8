// The evaluation stage of the path tessellation: the exact surface at each vertex that the tessellator made.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/counters.glsl"
#include "surface_io.glsl"

layout(quads, equal_spacing, ccw) in;

layout(location = 0) flat in uint inKsquad[];
SURFACE_OUT(ONE_VERTEX)

void main()
{
    uint index = inKsquad[0];
    KsQuadRecord ksquad = ksquads[index];
    vec2 t = gl_TessCoord.xy;
    SurfaceVertex vertex = vertexOf(ksquad, t);
    vec3 viewPosition = toView(ksquad.surface, vertex.at.position);
    gl_Position = toClip(viewPosition);
    outPosition = viewPosition;
    outNormal = normalToView(ksquad.surface, vertex.normal);
    outT = t;
    outKsquad = index;
    captureVertex(index, t, vertex.at.position, vertex.normal);
}
