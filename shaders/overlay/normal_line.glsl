// A line from the middle of each KSQuad to its front, as long on the screen wherever it is: an instance each, a strip. Where
// trim loops leave the middle not, from a place that they do.
// Compiled with KNOTSPAN_TRIMMED where a surface is trimmed.
#include "../shared/scene.glsl"

layout(location = 0) flat out vec3 outColour;
layout(location = 1) flat out float outHalfWidth;
layout(location = 2) noperspective out float outAcross;  // pixels from the middle

const float kLength = 18.0;  // pixels, where it does not point at the eye or away
const float kHalfWidth = 1.0;
const float kStart = 1.0;  // pixels: off the surface, through which it would show from behind

#ifdef KNOTSPAN_TRIMMED
#include "../shared/trimming_words.glsl"

const int kPlaces = 128;

// Places spread evenly over the KSQuad, the middle first: the first one that is left.
bool findFoot(uint ksquad, out vec2 t)
{
    t = vec2(0.5);
    if (trimWords[ksquad] == TRIM_OUTSIDE)
        return false;
    for (int k = 0; k < kPlaces; ++k) {
        t = fract(vec2(0.5) + float(k) * vec2(0.7548776662466927, 0.5698402909980532));
        if (trimContains(ksquad, t))
            return true;
    }
    return false;
}
#else
bool findFoot(uint ksquad, out vec2 t)
{
    t = vec2(0.5);
    return true;
}
#endif

void main()
{
    uint ksquad = uint(gl_InstanceIndex);
    uint surface = ksquads[ksquad].surface;
    bool orthographic = (frame.flags & FRAME_ORTHOGRAPHIC) != 0u;
    vec2 place;
    bool isLeft = findFoot(ksquad, place);
    SurfaceVertex middle = vertexOf(ksquads[ksquad], place);
    vec3 foot = toView(surface, middle.at.position);
    float unitsPerPixel = (orthographic ? 1.0 : -foot.z) / frame.pixelsPerUnit;
    vec3 front = normalToView(surface, middle.normal) * surfaceViews[surface].facing;
    vec3 pixel = unitsPerPixel * front;
    vec4 ends[2] = vec4[2](toClip(foot + kStart * pixel), toClip(foot + kLength * pixel));
    outColour = vec3(0.45, 0.87, 0.71);
    outHalfWidth = kHalfWidth;
    outAcross = (gl_VertexIndex % 2 == 0 ? -1.0 : 1.0) * (kHalfWidth + 1.0);
    if (!isLeft || !(min(ends[0].w, ends[1].w) > 0.0)) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // in no picture
        return;
    }
    vec2 along = (ends[1].xy / ends[1].w - ends[0].xy / ends[0].w) * frame.pixels;
    float len = length(along);
    vec2 across = len > 0.0 ? vec2(-along.y, along.x) / len : vec2(0.0, 1.0);
    gl_Position = ends[gl_VertexIndex / 2];
    gl_Position.xy += across * outAcross * 2.0 / frame.pixels * gl_Position.w;
}
