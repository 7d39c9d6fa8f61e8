// The vertex stage of the path tessellation: a patch is one KSQuad of the VisibleList.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/scene.glsl"

layout(set = 0, binding = BINDING_VISIBLE, scalar) readonly buffer VisibleBuffer { uint visible[]; };

layout(location = 0) flat out uint outKsquad;

void main()
{
    outKsquad = visible[gl_VertexIndex];
}
