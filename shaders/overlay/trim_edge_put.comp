// Listed pixels get the colours that were found for them.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "drawn_pixels.glsl"

layout(local_size_x = TRIM_LIST_THREADS) in;

void main()
{
    uint count = listedCount();
    for (uint k = gl_GlobalInvocationID.x; k < count; k += gl_NumWorkGroups.x * uint(TRIM_LIST_THREADS)) {
        ivec2 pixel = listedPixel(k);
        drawn[colourWord(pixel)] = resultAt(pixel);
    }
}
