// Lines of some pixels' width along the edges of surfaces, slightly in front of them: an instance for each line in a
// KSQuad's parameters, a strip.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/scene.glsl"

layout(set = 0, binding = BINDING_EDGE_LINES, scalar) readonly buffer LineBuffer { EdgeLineRecord lines[]; };
layout(location = 0) flat out vec3 outColour;
layout(location = 1) flat out float outHalfWidth;
layout(location = 2) noperspective out float outAcross;  // pixels from the middle

// How much nearer to the eye than they are: more than the surface is drawn off, and half a line's width on a slope.
const float kNearer = 0.002;

vec4 clipAt(EdgeLineRecord line, int step)
{
    vec2 place = mix(line.from, line.to, clamp(float(step) / float(EDGE_LINE_SEGMENTS), 0.0, 1.0));
    vec3 view = toView(ksquads[line.ksquad].surface, positionOf(ksquads[line.ksquad], place));
    bool orthographic = (frame.flags & FRAME_ORTHOGRAPHIC) != 0u;
    return toClip(orthographic ? vec3(view.xy, view.z * (1.0 - kNearer)) : view * (1.0 - kNearer));
}

void main()
{
    EdgeLineRecord line = lines[gl_InstanceIndex];
    int step = gl_VertexIndex / 2;
    vec4 places[3];
    // One loop, so that the evaluation stands in the stage once.
    for (int k = 0; k < 3; ++k)
        places[k] = clipAt(line, step + k - 1);
    vec4 here = places[1];
    // What lies behind the eye has no direction on the picture.
    vec4 before = places[0].w > 0.0 ? places[0] : here;
    vec4 after = places[2].w > 0.0 ? places[2] : here;
    vec2 along = (after.xy / after.w - before.xy / before.w) * frame.pixels;
    float len = length(along);
    vec2 across = len > 0.0 ? vec2(-along.y, along.x) / len : vec2(0.0, 1.0);
    outHalfWidth = line.halfWidth * frame.handPx;
    outAcross = (gl_VertexIndex % 2 == 0 ? -1.0 : 1.0) * (outHalfWidth + 1.0);
    outColour = unpackUnorm4x8(line.colour).bgr;
    here.xy += across * outAcross * 2.0 / frame.pixels * here.w;
    gl_Position = here;
}
