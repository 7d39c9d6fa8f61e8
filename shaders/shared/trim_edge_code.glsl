// Where in a pixel, or beside it, a trimmed surface ends.
//
// The pixel's centre is inside. From there the border is met along the picture's axes, after a part of the way to the next
// pixel (after Persson, Geometric Post-process Anti-Aliasing, 2011): eight bits for each of four sides.
#ifndef KNOTSPAN_TRIM_EDGE_CODE_GLSL
#define KNOTSPAN_TRIM_EDGE_CODE_GLSL

#define TRIM_EDGE_FAR 0xffffffffu  // not near
#define TRIM_EDGE_STEPS 254.0
#define TRIM_EDGE_REACH 1.05  // pixels: the next one's centre may be as good as on the border

const ivec2 kTrimSides[4] = ivec2[4](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));

// Pixels, along kTrimSides; above TRIM_EDGE_REACH nobody asks.
uint trimEdgeCode(vec4 distances)
{
    uvec4 steps = uvec4(round(clamp(distances / TRIM_EDGE_REACH, 0.0, 1.0) * TRIM_EDGE_STEPS));
    steps = mix(steps, uvec4(255u), greaterThan(distances, vec4(TRIM_EDGE_REACH)));
    return steps.x | steps.y << 8u | steps.z << 16u | steps.w << 24u;
}

// 2 where it is far.
vec4 trimEdgeOf(uint code)
{
    uvec4 steps = uvec4(code, code >> 8u, code >> 16u, code >> 24u) & 255u;
    return mix(vec4(steps) * (TRIM_EDGE_REACH / TRIM_EDGE_STEPS), vec4(2.0), equal(steps, uvec4(255u)));
}

// The nearest of the four sides. Where both axes are as good, all pixels along the border take the same.
int nearestTrimSide(vec4 distances)
{
    const float kAsGood = 0.05;  // pixels
    int across = distances.y < distances.x ? 1 : 0;
    int along = distances.w < distances.z ? 3 : 2;
    return distances[along] < distances[across] - kAsGood ? along : across;
}

#endif
