// Straight lines in the model, of some pixels' width, slightly nearer to the eye than they are: an instance each, a
// strip.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "../shared/scene.glsl"

layout(set = 0, binding = BINDING_SPACE_LINES, scalar) readonly buffer LineBuffer { SpaceLineRecord lines[]; };
layout(push_constant, scalar) uniform Constants { SpaceLineConstants space; };
layout(location = 0) flat out vec3 outColour;
layout(location = 1) flat out float outHalfWidth;
layout(location = 2) noperspective out float outAcross;  // pixels from the middle

const float kNearer = 0.002;  // as lines on surfaces (edge_line.vert)

vec4 clipAt(vec3 place)
{
    vec3 view = space.modelView * vec4(place, 1.0);
    bool orthographic = (frame.flags & FRAME_ORTHOGRAPHIC) != 0u;
    return toClip(orthographic ? vec3(view.xy, view.z * (1.0 - kNearer)) : view * (1.0 - kNearer));
}

void main()
{
    SpaceLineRecord line = lines[gl_InstanceIndex];
    vec4 ends[2] = vec4[2](clipAt(line.from), clipAt(line.to));
    outColour = unpackUnorm4x8(line.colour).bgr;
    outHalfWidth = line.halfWidth * frame.handPx;
    outAcross = (gl_VertexIndex % 2 == 0 ? -1.0 : 1.0) * (outHalfWidth + 1.0);
    // The part in front of the near plane, where depth is w: what lies behind the eye has no place in the picture.
    float before[2] = float[2](ends[0].w - ends[0].z, ends[1].w - ends[1].z);
    if (before[0] <= 0.0 && before[1] <= 0.0) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // in no picture
        return;
    }
    vec4 cut = mix(ends[0], ends[1], before[0] / (before[0] - before[1]));
    if (before[0] <= 0.0)
        ends[0] = cut;
    else if (before[1] <= 0.0)
        ends[1] = cut;
    vec2 along = (ends[1].xy / ends[1].w - ends[0].xy / ends[0].w) * frame.pixels;
    float len = length(along);
    vec2 across = len > 0.0 ? vec2(-along.y, along.x) / len : vec2(0.0, 1.0);
    gl_Position = ends[gl_VertexIndex / 2];
    gl_Position.xy += across * outAcross * 2.0 / frame.pixels * gl_Position.w;
}
