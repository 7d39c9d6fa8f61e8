// The colour of a reference mesh's pixel: each triangle is flat, as it is.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "../shared/scene.glsl"
#include "lighting.glsl"

layout(push_constant, scalar) uniform Constants { MeshConstants mesh; };
layout(location = 0) in vec3 inPosition;
layout(location = 0) out vec4 outColour;
layout(location = 1) out uvec2 outPicked;  // no KSQuad

void main()
{
    bool orthographic = (frame.flags & FRAME_ORTHOGRAPHIC) != 0u;
    vec3 towardsEye = orthographic ? vec3(0, 0, 1) : -normalize(inPosition);
    vec3 n = directionOf(cross(dFdx(inPosition), dFdy(inPosition)));
    vec3 facing = dot(n, towardsEye) >= 0.0 ? n : -n;
    vec3 colour = lit(gl_FrontFacing ? mesh.colour : mesh.colour * kInside, facing, towardsEye);
    colour = mix(colour, vec3(1.0, 0.45, 0.08), 0.22 * mesh.highlight);
    outColour = vec4(encodedSrgb(colour), 1.0);
    outPicked = uvec2(0u);
}
