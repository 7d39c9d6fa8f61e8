// The rules by lengths on screen, as the papers have them; and where the sampling pass finds a KSQuad's numbers.
#ifndef KNOTSPAN_SAMPLING_RULES_GLSL
#define KNOTSPAN_SAMPLING_RULES_GLSL

#include "../shared/frame_map.glsl"
#include "../shared/first_grid.glsl"

KsQuadPlace placeOfNumbers(KsQuadRecord ksquad)
{
    KsQuadPlace place;
    place.degreeU = int(surfaces[ksquad.surface].degreeU);
    place.degreeV = int(surfaces[ksquad.surface].degreeV);
    place.firstPoint = ksquad.firstPoint;
    place.stride = surfaces[ksquad.surface].stride;
    place.tableU = ksquad.spanU - uint((place.degreeU + 1) * (place.degreeU + 1));
    place.tableV = ksquad.spanV - uint((place.degreeV + 1) * (place.degreeV + 1));
    return place;
}

// Whether the whole KSQuad lies behind the eye: its control points do (weights are positive, so it lies in their hull).
bool isBehindTheEye(uint surface, KsQuadPlace place)
{
    if ((frame.flags & FRAME_ORTHOGRAPHIC) != 0u)
        return false;
    for (int i = 0; i <= place.degreeU; ++i)
        for (int j = 0; j <= place.degreeV; ++j) {
            vec4 point = controlPoint(place.firstPoint + uint(i) * place.stride + uint(j));
            if (toView(surface, point.xyz / point.w).z < 0.0)
                return false;
        }
    return true;
}

// Bezier point (k, l) of the KSQuad in view space.
vec3 bezierPoint(uint surface, KsQuadPlace place, int k, int l)
{
    vec4 sum = vec4(0.0);
    for (int i = 0; i <= place.degreeU; ++i) {
        float shareU = spanTable(place.tableU + uint(k * (place.degreeU + 1) + i));
        for (int j = 0; j <= place.degreeV; ++j)
            sum += shareU * spanTable(place.tableV + uint(l * (place.degreeV + 1) + j)) *
                   controlPoint(place.firstPoint + uint(i) * place.stride + uint(j));
    }
    return toView(surface, sum.xyz / sum.w);
}

// The length in pixels of what is `units` long and seen broadside from its nearest point. RPNS takes the projected
// length: an edge seen end on then gets one KSDie although it bulges, and the silhouette is off by pixels. The two agree
// where the segment lies across the view.
float pixelsOf(float units, float nearest)
{
    if ((frame.flags & FRAME_ORTHOGRAPHIC) != 0u)
        return units * frame.pixelsPerUnit;
    if (nearest <= 1e-6 * units)  // it begins behind the eye
        return units > 0.0 ? 1e9 : 0.0;
    return units / nearest * frame.pixelsPerUnit;
}

// RULE_AREA: the distance of the side's ends, from the depth of the nearer (RPNS, eq. 3). RULE_EDGE: its control
// polygon's length, C sum |B_{i+1} - B_i| / distance to the camera (CUDA, the white paper).
uint cellsAlongSide(uint surface, KsQuadPlace place, uint side)
{
    bool alongV = side < SIDE_START_V;
    int steps = alongV ? place.degreeV : place.degreeU;
    int across = (side & 1u) == 0u ? 0 : (alongV ? place.degreeU : place.degreeV);
    bool edge = frame.samplingRule == RULE_EDGE;
    float units = 0.0;
    float nearest = GRID_HUGE;
    vec3 before = vec3(0.0);
    for (int k = 0; k <= steps; k += edge ? 1 : steps) {
        vec3 at = bezierPoint(surface, place, alongV ? across : k, alongV ? k : across);
        nearest = min(nearest, edge ? length(at) : -at.z);
        units += k > 0 ? distance(before, at) : 0.0;
        before = at;
    }
    return uint(clamp(ceil(pixelsOf(units, nearest) / frame.diePx), 1.0, float(GRID_LARGEST)));
}

GridRecord gridByLength(KsQuadRecord ksquad)
{
    KsQuadPlace place = placeOfNumbers(ksquad);
    if (isBehindTheEye(ksquad.surface, place))
        return GridRecord(0u, 0u);
    uint cells[4];
    for (uint side = 0u; side < 4u; ++side)
        cells[side] = frame.samplingRule == RULE_FIXED ? clamp(frame.fixedDice, 1u, GRID_LARGEST)
                                                       : cellsAlongSide(ksquad.surface, place, side);
    return GridRecord(cells[0] | cells[1] << 16u, cells[2] | cells[3] << 16u);
}

#endif
