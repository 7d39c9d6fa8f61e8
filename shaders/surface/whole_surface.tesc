// The control stage of the path surface: how finely a whole surface is cut, as one patch. Along each border and each knot
// line as the lengths between the corners of its KSQuads on the screen say (rule area) or those of its control polygon
// (rule edge); inside as the longest of a direction.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/counters.glsl"
#include "../culling/surface.glsl"
#include "../shared/verdicts.glsl"

layout(vertices = 1) out;

layout(location = 0) flat in uint inTile[];
layout(location = 0) flat out uint outSurface[];

const uint kSurfaceBit = 0u;  // of the culling mode in the list

// Point k along line `line` in view space; lines run along u or along v.
vec3 pointOfLine(uint surface, bool alongU, uint line, uint k)
{
    uint a = alongU ? k : line;
    uint b = alongU ? line : k;
    if (frame.samplingRule == RULE_EDGE) {
        vec4 point = controlPoint(surfaces[surface].firstPoint + a * surfaces[surface].stride + b);
        return toView(surface, point.xyz / point.w);
    }
    uvec2 inside = min(uvec2(a, b), uvec2(surfaces[surface].spansU, surfaces[surface].spansV) - 1u);
    uint ksquad = surfaces[surface].firstKsquad + inside.x * surfaces[surface].spansV + inside.y;
    return toView(surface, positionOf(ksquads[ksquad], vec2(uvec2(a, b) - inside)));
}

float pixelsOf(float units, float nearest)
{
    if ((frame.flags & FRAME_ORTHOGRAPHIC) != 0u)
        return units * frame.pixelsPerUnit;
    if (nearest <= 1e-6 * units)  // it begins behind the eye
        return units > 0.0 ? 1e9 : 0.0;
    return units / nearest * frame.pixelsPerUnit;
}

void main()
{
    uint surface = inTile[0];
    outSurface[gl_InvocationID] = surface;
    uvec2 spans = uvec2(surfaces[surface].spansU, surfaces[surface].spansV);
    uint ksquadCount = spans.x * spans.y;
    for (uint k = 0u; k < 4u; ++k)
        gl_TessLevelOuter[k] = 0.0;
    gl_TessLevelInner[0] = 0.0;
    gl_TessLevelInner[1] = 0.0;
    SeenKsQuad seen;
    seen.view = surfaceViews[surface];
    uint first = surfaces[surface].firstKsquad;
    bool culled = keepsVerdicts() ? verdicts[first] != 0u
                                  : (frame.cullBits & 1u << kSurfaceBit) != 0u && culledBySurface(first, seen);
    if (culled) {
        atomicAdd(counters.culled[kSurfaceBit], ksquadCount);
        return;
    }
    atomicAdd(counters.drawn, ksquadCount);

    // Levels: along v at u = 0 and at u = 1, along u at v = 0 and at v = 1, and the most along v and u.
    float wanted[4] = float[](1.0, 1.0, 1.0, 1.0);
    float most[2] = float[](1.0, 1.0);
    bool edge = frame.samplingRule == RULE_EDGE;
    uvec2 degrees = uvec2(surfaces[surface].degreeU, surfaces[surface].degreeV);
    uint stride = surfaces[surface].stride;
    KsQuadRecord last = ksquads[surfaces[surface].firstKsquad + ksquadCount - 1u];
    uint offset = last.firstPoint - surfaces[surface].firstPoint;
    // Of a surface whose knots are not clamped some control points lie outside; they count as well.
    uvec2 points = uvec2(offset / stride, offset % stride) + degrees + 1u;
    uvec2 lattice = edge ? points : spans + 1u;
    for (uint direction = 0u; direction < 2u; ++direction) {
        bool alongU = direction == 1u;
        uint lines = alongU ? lattice.y : lattice.x;
        uint steps = alongU ? lattice.x : lattice.y;
        for (uint line = 0u; line < lines; ++line) {
            float cells = 0.0;
            vec3 before = vec3(0.0);
            if (frame.samplingRule == RULE_FIXED) {
                cells = float(frame.fixedDice);
                line = line == 0u ? 0u : lines - 1u;
            } else {
                for (uint k = 0u; k < steps; ++k) {
                    vec3 at = pointOfLine(surface, alongU, line, k);
                    if (k > 0u)
                        cells += pixelsOf(distance(before, at), min(edge ? length(before) : -before.z,
                                                                    edge ? length(at) : -at.z)) / frame.diePx;
                    before = at;
                }
            }
            cells = max(ceil(cells), 1.0);
            most[direction] = max(most[direction], cells);
            if (line == 0u)
                wanted[2u * direction] = cells;
            if (line + 1u == lines)
                wanted[2u * direction + 1u] = cells;
        }
    }
    float limit = float(frame.tileSide);
    if (max(most[0], most[1]) > limit)
        atomicAdd(counters.tiles, 1u);
    // In the tessellator's order: the sides u = 0, v = 0, u = 1, v = 1.
    gl_TessLevelOuter[0] = min(wanted[0], limit);
    gl_TessLevelOuter[1] = min(wanted[2], limit);
    gl_TessLevelOuter[2] = min(wanted[1], limit);
    gl_TessLevelOuter[3] = min(wanted[3], limit);
    // The tessellator makes 2 of an inner 1 unless all six are 1: here always, so that what it makes is known.
    float u = max(min(most[1], limit), 2.0);
    float v = max(min(most[0], limit), 2.0);
    gl_TessLevelInner[0] = u;
    gl_TessLevelInner[1] = v;
    float border = min(wanted[0], limit) + min(wanted[1], limit) + min(wanted[2], limit) + min(wanted[3], limit);
    uint spent = frame.samplingRule == RULE_AREA ? 2u * lattice.x * lattice.y : 0u;
    countDice(uint(u * v), uint(2.0 * (u - 2.0) * (v - 2.0) + border + 2.0 * (u - 2.0) + 2.0 * (v - 2.0)),
              uint((u - 1.0) * (v - 1.0) + border) + spent);
}
