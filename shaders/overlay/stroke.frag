// How much of the pixel a stroke covers, across and along it.
#version 460

layout(location = 0) flat in vec4 inColour;
layout(location = 1) flat in vec4 inEnds;
layout(location = 2) flat in vec2 inHalfWidths;
layout(location = 0) out vec4 outColour;

// Of a pixel around `place`, the part between `low` and `high`.
float covered(float place, float low, float high)
{
    return max(min(place + 0.5, high) - max(place - 0.5, low), 0.0);
}

void main()
{
    vec2 whole = inEnds.zw - inEnds.xy;
    float len = length(whole);
    vec2 along = whole / len;
    vec2 here = gl_FragCoord.xy - inEnds.xy;
    float place = dot(here, along);
    float halfWidth = mix(inHalfWidths.x, inHalfWidths.y, clamp(place / len, 0.0, 1.0));
    float opacity = covered(place, 0.0, len) * covered(dot(here, vec2(-along.y, along.x)), -halfWidth, halfWidth);
    outColour = vec4(inColour.rgb, inColour.a * opacity);
}
