// The control stage of the path tessellation: how many KSDice a KSQuad gets, by the local area test (RPNS eq. 3):
// an edge gets so many KSDice that none is longer than frame.diePx, measured between the edge's corners.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/counters.glsl"

layout(vertices = 1) out;

layout(location = 0) flat in uint inKsquad[];
layout(location = 0) flat out uint outKsquad[];

// The length in pixels of the segment between two points of view space, as if it were seen broadside from its nearer
// end. RPNS takes the projected length: an edge seen end on then gets one KSDie although it bulges, and the
// silhouette is off by pixels. The two agree where the segment lies across the view.
float pixelsBetween(vec3 a, vec3 b)
{
    float edge = distance(a, b);
    if ((frame.flags & FRAME_ORTHOGRAPHIC) != 0u)
        return edge * frame.pixelsPerUnit;
    float nearest = min(-a.z, -b.z);
    if (nearest <= 1e-6 * edge)  // it begins behind the eye
        return edge > 0.0 ? 1e9 : 0.0;
    return edge / nearest * frame.pixelsPerUnit;
}

// Whether the whole KSQuad lies behind the eye: its control points do (weights are positive, so it lies in their hull).
bool isBehindTheEye(KsQuadRecord ksquad)
{
    if ((frame.flags & FRAME_ORTHOGRAPHIC) != 0u)
        return false;
    uint columns = surfaces[ksquad.surface].degreeV + 1u;
    uint points = (surfaces[ksquad.surface].degreeU + 1u) * columns;
    for (uint k = 0u; k < points; ++k) {
        uint row = k / columns;
        vec4 point = controlPoint(ksquad.firstPoint + row * surfaces[ksquad.surface].stride + k % columns);
        if (toView(ksquad.surface, point.xyz / point.w).z < 0.0)
            return false;
    }
    return true;
}

float diceAlong(vec3 a, vec3 b)
{
    if (frame.fixedDice != 0u)
        return float(frame.fixedDice);
    return clamp(ceil(pixelsBetween(a, b) / frame.diePx), 1.0, float(frame.maxDice));
}

void main()
{
    uint index = inKsquad[0];
    outKsquad[gl_InvocationID] = index;
    KsQuadRecord ksquad = ksquads[index];
    if (isBehindTheEye(ksquad)) {
        gl_TessLevelOuter = float[4](0.0, 0.0, 0.0, 0.0);  // drops the patch
        gl_TessLevelInner = float[2](0.0, 0.0);
        return;
    }

    vec3 corners[4];  // (0,0), (1,0), (0,1), (1,1)
    for (int k = 0; k < 4; ++k)
        corners[k] = toView(ksquad.surface, positionOf(ksquad, vec2(k & 1, k >> 1)));

    // In the tessellator's order: the sides u = 0, v = 0, u = 1, v = 1.
    float outer[4] = {diceAlong(corners[0], corners[2]), diceAlong(corners[0], corners[1]),
                      diceAlong(corners[1], corners[3]), diceAlong(corners[2], corners[3])};
    float inner[2] = {max(outer[1], outer[3]), max(outer[0], outer[2])};
    // The tessellator makes 2 of an inner 1 unless all six are 1 (Vulkan, "Quad Tessellation").
    bool single = max(inner[0], inner[1]) == 1.0;
    if (!single)
        inner = float[2](max(inner[0], 2.0), max(inner[1], 2.0));

    gl_TessLevelOuter[0] = outer[0];
    gl_TessLevelOuter[1] = outer[1];
    gl_TessLevelOuter[2] = outer[2];
    gl_TessLevelOuter[3] = outer[3];
    gl_TessLevelInner[0] = inner[0];
    gl_TessLevelInner[1] = inner[1];

    // What equal spacing makes of it: an inner grid two cells smaller, and a ring between it and the border.
    float border = outer[0] + outer[1] + outer[2] + outer[3];
    float n = inner[0];
    float m = inner[1];
    float triangles = single ? 2.0 : 2.0 * (n - 2.0) * (m - 2.0) + border + 2.0 * (n - 2.0) + 2.0 * (m - 2.0);
    countDice(uint(n * m), uint(triangles), uint((n - 1.0) * (m - 1.0) + border));
}
