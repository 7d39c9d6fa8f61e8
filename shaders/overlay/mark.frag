// A mark's colour, round.
#version 460

layout(location = 0) flat in vec3 inColour;
layout(location = 1) flat in float inSize;
layout(location = 0) out vec4 outColour;

void main()
{
    float opacity = clamp(0.5 * inSize - length(gl_PointCoord - 0.5) * (inSize + 1.0) + 0.5, 0.0, 1.0);
    if (opacity <= 0.0)
        discard;
    outColour = vec4(inColour, opacity);
}
