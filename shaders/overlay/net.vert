// The control net's lines and points, straight from the bound control points: nothing is uploaded for them.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "../shared/scene.glsl"

layout(push_constant, scalar) uniform Constants { OverlayConstants overlay; };
layout(location = 0) flat out float outSize;
layout(constant_id = KNOTSPAN_LINES_CONSTANT) const bool kLines = false;

// Lines: first those along v (countU rows of countV - 1), then those along u; two vertices each.
uint lineEnd(uint vertex)
{
    uint line = vertex / 2u;
    uint end = vertex % 2u;
    uint alongV = overlay.countU * (overlay.countV - 1u);
    if (line < alongV)
        return line / (overlay.countV - 1u) * overlay.countV + line % (overlay.countV - 1u) + end;
    line -= alongV;
    return line + end * overlay.countV;
}

void main()
{
    uint point = kLines ? lineEnd(uint(gl_VertexIndex)) : uint(gl_VertexIndex);
    vec4 homogeneous = controlPoint(surfaces[overlay.surface].firstPoint + point);
    gl_Position = toClip(toView(overlay.surface, homogeneous.xyz / homogeneous.w));
    outSize = overlay.pointSize * frame.handPx;
    gl_PointSize = outSize;
}
