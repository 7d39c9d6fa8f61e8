// Where in a pixel, or beside it, a trimmed surface ends: in eight bits, which stand for the colour's opacity until they are
// drawn by.
//
// The pixel's centre is inside. From there the border is met along one of the picture's axes, after a part of the way to the
// next pixel (after Persson, Geometric Post-process Anti-Aliasing, 2011).
#ifndef KNOTSPAN_TRIM_EDGE_CODE_GLSL
#define KNOTSPAN_TRIM_EDGE_CODE_GLSL

#define TRIM_EDGE_FAR 255u  // not near
#define TRIM_EDGE_STEPS 62.0
#define TRIM_EDGE_REACH 1.05  // pixels: the next one's centre may be as good as on the border

const ivec2 kTrimSides[4] = ivec2[4](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));

// `side`: of kTrimSides; `distance`: 0 to TRIM_EDGE_REACH.
uint trimEdgeCode(int side, float distance)
{
    return uint(side) * 64u + uint(round(clamp(distance / TRIM_EDGE_REACH, 0.0, 1.0) * TRIM_EDGE_STEPS));
}

struct TrimEdge {
    bool isNear;
    ivec2 side;
    float distance;
};

TrimEdge trimEdgeOf(uint code)
{
    return TrimEdge(code != TRIM_EDGE_FAR, kTrimSides[code >> 6], float(code & 63u) * (TRIM_EDGE_REACH / TRIM_EDGE_STEPS));
}

#endif
