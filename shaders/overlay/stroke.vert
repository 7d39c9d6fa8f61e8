// Straight lines in the picture, in front of everything: an instance each, a rectangle around it.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/scene.glsl"

layout(set = 0, binding = BINDING_STROKES, scalar) readonly buffer StrokeBuffer { StrokeRecord strokes[]; };
layout(location = 0) flat out vec4 outColour;
layout(location = 1) flat out vec4 outEnds;        // from, to; pixels
layout(location = 2) flat out vec2 outHalfWidths;  // there

void main()
{
    StrokeRecord stroke = strokes[gl_InstanceIndex];
    outColour = unpackUnorm4x8(stroke.colour).bgra;
    outEnds = vec4(stroke.from, stroke.to);
    outHalfWidths = vec2(stroke.halfWidthFrom, stroke.halfWidthTo);
    vec2 along = normalize(stroke.to - stroke.from);
    vec2 across = vec2(-along.y, along.x) * (max(stroke.halfWidthFrom, stroke.halfWidthTo) + 1.0);
    bool end = gl_VertexIndex >= 2;
    vec2 place = (end ? stroke.to + along : stroke.from - along) + (gl_VertexIndex % 2 == 0 ? across : -across);
    gl_Position = vec4(2.0 * place / frame.pixels - 1.0, 0.5, 1.0);
}
