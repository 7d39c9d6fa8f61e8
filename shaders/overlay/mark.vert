// Control points to mark, straight from the bound control points: only which ones, and how, was uploaded.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/scene.glsl"

layout(set = 0, binding = BINDING_MARKS, scalar) readonly buffer MarkBuffer { MarkRecord marks[]; };
layout(location = 0) flat out vec3 outColour;
layout(location = 1) flat out float outSize;

void main()
{
    MarkRecord mark = marks[gl_VertexIndex];
    vec4 homogeneous = controlPoint(surfaces[mark.surface].firstPoint + mark.point);
    outColour = unpackUnorm4x8(mark.colour).bgr;
    outSize = mark.size * frame.handPx;
    gl_Position = toClip(toView(mark.surface, homogeneous.xyz / homogeneous.w));
    gl_PointSize = outSize + 1.0;  // room for the rim that fades out
}
