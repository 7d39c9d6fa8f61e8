// The vertex stage of the path compute: vertices as they were made.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/scene.glsl"
#include "surface_io.glsl"

layout(set = 0, binding = BINDING_VERTICES, scalar) readonly buffer VertexBuffer { VertexRecord vertices[]; };

SURFACE_OUT(ONE_VERTEX)

void main()
{
    gl_Position = vertices[gl_VertexIndex].clip;
    outPosition = vertices[gl_VertexIndex].view;
    outNormal = vertices[gl_VertexIndex].normal;
    gl_CullDistance[0] =
        shownTowards(ksquads[vertices[gl_VertexIndex].ksquad].surface, vertices[gl_VertexIndex].view,
                     vertices[gl_VertexIndex].normal);
    outT = vertices[gl_VertexIndex].t;
    outWeightedT = vertices[gl_VertexIndex].inverseWeight * vertices[gl_VertexIndex].t;
    outInverseWeight = vertices[gl_VertexIndex].inverseWeight;
    outKsquad = vertices[gl_VertexIndex].ksquad;
}
