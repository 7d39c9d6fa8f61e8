// How much of the pixel a quadrilateral covers: of its width between two opposite sides, times that between the
// other two.
#version 460

layout(location = 0) flat in vec4 inColour;
layout(location = 1) flat in vec4 inCorners[2];
layout(location = 0) out vec4 outColour;

// How far this pixel's centre is inside of the side from `from` to `to`.
float inside(vec2 from, vec2 to)
{
    vec2 along = normalize(to - from);
    vec2 here = gl_FragCoord.xy - from;
    return along.x * here.y - along.y * here.x;
}

// Of a pixel, the part between two sides that it is so far inside of.
float covered(float one, float other)
{
    return max(min(one, 0.5) + min(other, 0.5), 0.0);
}

void main()
{
    vec2 a = inCorners[0].xy;
    vec2 b = inCorners[0].zw;
    vec2 c = inCorners[1].xy;
    vec2 d = inCorners[1].zw;
    float opacity = covered(inside(a, b), inside(c, d)) * covered(inside(b, c), inside(d, a));
    outColour = vec4(inColour.rgb, inColour.a * opacity);
}
