// A line's colour, fading out over its last pixel.
#version 460

layout(location = 0) flat in vec3 inColour;
layout(location = 1) flat in float inHalfWidth;
layout(location = 2) noperspective in float inAcross;
layout(location = 0) out vec4 outColour;

void main() { outColour = vec4(inColour, clamp(inHalfWidth + 0.5 - abs(inAcross), 0.0, 1.0)); }
