// A line from the middle of each KSQuad to its front, as long on the screen wherever it is: an instance each, a strip.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/scene.glsl"

layout(location = 0) flat out vec3 outColour;
layout(location = 1) flat out float outHalfWidth;
layout(location = 2) noperspective out float outAcross;  // pixels from the middle

const float kLength = 18.0;  // pixels, where it does not point at the eye or away
const float kHalfWidth = 1.0;
const float kStart = 1.0;  // pixels: off the surface, through which it would show from behind

void main()
{
    uint ksquad = uint(gl_InstanceIndex);
    uint surface = ksquads[ksquad].surface;
    bool orthographic = (frame.flags & FRAME_ORTHOGRAPHIC) != 0u;
    SurfaceVertex middle = vertexOf(ksquads[ksquad], vec2(0.5));
    vec3 foot = toView(surface, middle.at.position);
    float unitsPerPixel = (orthographic ? 1.0 : -foot.z) / frame.pixelsPerUnit;
    vec3 front = normalToView(surface, middle.normal) * surfaceViews[surface].facing;
    vec3 pixel = unitsPerPixel * front;
    vec4 ends[2] = vec4[2](toClip(foot + kStart * pixel), toClip(foot + kLength * pixel));
    outColour = vec3(0.45, 0.87, 0.71);
    outHalfWidth = kHalfWidth;
    outAcross = (gl_VertexIndex % 2 == 0 ? -1.0 : 1.0) * (kHalfWidth + 1.0);
    if (!(min(ends[0].w, ends[1].w) > 0.0)) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // in no picture
        return;
    }
    vec2 along = (ends[1].xy / ends[1].w - ends[0].xy / ends[0].w) * frame.pixels;
    float len = length(along);
    vec2 across = len > 0.0 ? vec2(-along.y, along.x) / len : vec2(0.0, 1.0);
    gl_Position = ends[gl_VertexIndex / 2];
    gl_Position.xy += across * outAcross * 2.0 / frame.pixels * gl_Position.w;
}
