// Of each listed pixel: where in it, or beyond, the surface ends that it shows.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "drawn_pixels.glsl"
#include "trim_edge.glsl"

layout(local_size_x = TRIM_LIST_THREADS) in;

void main()
{
    uint count = listedCount();
    for (uint k = gl_GlobalInvocationID.x; k < count; k += gl_NumWorkGroups.x * uint(TRIM_LIST_THREADS)) {
        ivec2 pixel = listedPixel(k);
        uint picked = pickedAt(pixel);
        if (picked == 0u || trimWords[picked - 1u] == TRIM_WHOLE)
            continue;
        uint code = trimEdgeCodeAt(placeOf(uvec2(picked, placeAt(pixel))), centreOf(pixel));
        if (code != TRIM_EDGE_FAR)
            setCode(pixel, code);
    }
}
