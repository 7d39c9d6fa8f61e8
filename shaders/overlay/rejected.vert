// The borders of the KSQuads that the culling camera drops, as lines along the exact surface: an instance each, a strip.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/verdicts.glsl"

layout(location = 0) flat out vec3 outColour;

uint colourOf(uint mode)
{
#define KNOTSPAN_COLOUR(bit, name, culls, conservative, byDefault, colour, sentence)                               \
    if (mode == bit)                                                                                               \
        return colour;
    KNOTSPAN_CULL_LIST(KNOTSPAN_COLOUR)
#undef KNOTSPAN_COLOUR
    return 0u;
}

void main()
{
    uint index = uint(gl_InstanceIndex);
    uint verdict = verdicts[index];
    outColour = vec3(0.0);
    if (verdict == 0u) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // in no picture
        return;
    }
    outColour = unpackUnorm4x8(colourOf(verdict - 1u)).bgr;
    // Once around it.
    uint turn = uint(gl_VertexIndex) / OUTLINE_SEGMENTS % 4u;
    float along = float(uint(gl_VertexIndex) % OUTLINE_SEGMENTS) / float(OUTLINE_SEGMENTS);
    vec2 t = turn % 2u == 0u ? vec2(along, 0.0) : vec2(1.0, along);
    if (turn >= 2u)
        t = 1.0 - t;
    gl_Position = toClip(toView(ksquads[index].surface, positionOf(ksquads[index], t)));
}
