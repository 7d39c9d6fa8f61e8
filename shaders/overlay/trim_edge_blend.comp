// Smooths where trimmed surfaces end: of a pixel that the border runs through, what the surface covers, and of the rest the
// pixel beyond. Which pixels those are trim_edge_codes.comp found. The results become the pixels' colours once
// all are there (trim_edge_put.comp).
#version 460
#extension GL_GOOGLE_include_directive : require

#include "drawn_pixels.glsl"
#include "../shared/trim_edge_code.glsl"

layout(local_size_x = TRIM_LIST_THREADS) in;

vec3 rgbAt(ivec2 pixel) { return unpackUnorm4x8(colourAt(pixel)).rgb; }

// Whether a pixel shows what lies far behind its neighbours on both sides.
bool isBehind(ivec2 pixel, ivec2 side)
{
    if (!isInPicture(pixel - side) || !isInPicture(pixel + side))
        return false;
    float one = depthAt(pixel - side);
    float other = depthAt(pixel + side);
    return min(one, other) - depthAt(pixel) > 4.0 * abs(one - other) + 1e-3 * one;
}

// How many of the two say that they end near there.
int endings(ivec2 pixel, ivec2 side)
{
    return int(hasCode(pixel - side)) + int(hasCode(pixel + side));
}

// A trimmed surface ends exactly at its loop. Its neighbour's triangles end up to the tolerance before theirs, which goes
// further than the pixel and so says nothing of an end: that is no gap. Where both say so there is one.
bool isBetween(ivec2 pixel, ivec2 side) { return isBehind(pixel, side) && endings(pixel, side) == 1; }

// What a surface that ends before `pixel` ends beside.
vec3 besideAt(ivec2 pixel, ivec2 side) { return rgbAt(isBetween(pixel, side) ? pixel + side : pixel); }

vec3 blended(ivec2 here)
{
    vec3 colour = rgbAt(here);
    vec4 own = hasCode(here) ? trimEdgeOf(codeAt(here)) : vec4(2.0);
    int nearest = nearestTrimSide(own);
    if (own[nearest] < 0.5) {
        // Of a strip thinner than a pixel both sides are.
        vec3 sum = vec3(0.0);
        float beside = 0.0;
        for (int k = nearest & 2; k < (nearest & 2) + 2; ++k) {
            ivec2 beyond = here + kTrimSides[k];
            if (own[k] >= 0.5 || !isInPicture(beyond))
                continue;
            sum += (0.5 - own[k]) * besideAt(beyond, kTrimSides[k]);
            beside += 0.5 - own[k];
        }
        return (1.0 - beside) * colour + sum;
    }
    // What shows between two that meet: from each of four sides to the other one.
    const ivec2 kAcross[4] = ivec2[4](ivec2(1, 0), ivec2(0, 1), ivec2(1, 1), ivec2(1, -1));
    int between = 0;
    vec3 around = vec3(0.0);
    bool isBesideEdge = false;
    for (int k = 0; k < 4; ++k) {
        int ends = isBehind(here, kAcross[k]) ? endings(here, kAcross[k]) : 2;
        if (ends == 2)
            continue;
        ++between;
        around += 0.5 * (rgbAt(here - kAcross[k]) + rgbAt(here + kAcross[k]));
        isBesideEdge = isBesideEdge || ends == 1;
    }
    if (between > 1 || (between == 1 && isBesideEdge)) {
        return around / float(between);
    }
    // Neighbours in front of it may reach into it: of one axis both.
    float most = 0.0;
    vec3 other = vec3(0.0);
    for (int axis = 0; axis < 2; ++axis) {
        float covered = 0.0;
        vec3 sum = vec3(0.0);
        for (int k = 2 * axis; k < 2 * axis + 2; ++k) {
            ivec2 from = here - kTrimSides[k];
            if (!isInPicture(from) || depthAt(from) < depthAt(here))
                continue;
            float distance = hasCode(from) ? trimEdgeOf(codeAt(from))[k] : 2.0;
            float by = distance <= TRIM_EDGE_REACH ? max(distance - 0.5, 0.0) : 0.0;
            covered += by;
            sum += by * rgbAt(from);
        }
        if (covered > most) {
            most = covered;
            other = sum / covered;
        }
    }
    return mix(colour, other, min(most, 1.0));
}

void main()
{
    uint count = listedCount();
    for (uint k = gl_GlobalInvocationID.x; k < count; k += gl_NumWorkGroups.x * uint(TRIM_LIST_THREADS)) {
        ivec2 pixel = listedPixel(k);
        setResult(pixel, packUnorm4x8(vec4(blended(pixel), 1.0)));
    }
}
