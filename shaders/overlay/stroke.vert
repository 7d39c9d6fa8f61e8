// Straight lines and flat pieces in the picture, in front of everything: an instance each, a quadrilateral and
// the pixel around it.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/scene.glsl"

layout(set = 0, binding = BINDING_STROKES, scalar) readonly buffer StrokeBuffer { StrokeRecord strokes[]; };
layout(location = 0) flat out vec4 outColour;
layout(location = 1) flat out vec4 outCorners[2];  // pixels, in order around it

void main()
{
    const int kAround[4] = int[4](0, 1, 3, 2);  // as a strip has them
    StrokeRecord stroke = strokes[gl_InstanceIndex];
    outColour = unpackUnorm4x8(stroke.colour).bgra;
    outCorners[0] = vec4(stroke.corners[0], stroke.corners[1]);
    outCorners[1] = vec4(stroke.corners[2], stroke.corners[3]);
    int corner = kAround[gl_VertexIndex];
    vec2 here = stroke.corners[corner];
    vec2 place = here + normalize(here - stroke.corners[(corner + 1) % 4]) +
                 normalize(here - stroke.corners[(corner + 3) % 4]);
    gl_Position = vec4(2.0 * place / frame.pixels - 1.0, 0.5, 1.0);
}
