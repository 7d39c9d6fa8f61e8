// A corner of a reference mesh's triangle.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "../shared/scene.glsl"

layout(set = 0, binding = BINDING_MESH_VERTICES, scalar) readonly buffer VertexBuffer { vec3 meshVertices[]; };
layout(set = 0, binding = BINDING_MESH_TRIANGLES, scalar) readonly buffer TriangleBuffer { uint meshCorners[]; };
layout(push_constant, scalar) uniform Constants { MeshConstants mesh; };

layout(location = 0) out vec3 outPosition;  // eye-relative view space

void main()
{
    outPosition = mesh.modelView * vec4(meshVertices[meshCorners[gl_VertexIndex]], 1.0);
    gl_Position = toClip(outPosition);
}
