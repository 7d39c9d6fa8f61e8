// A strip for each tile of the picture, of no extent where borders of trimmed surfaces are far.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "drawn_pixels.glsl"

void main()
{
    uint tile = gl_InstanceIndex;
    ivec2 corner = ivec2(tile % tilesAcross, tile / tilesAcross);
    if (drawn[firstTile() + tile] != 0u)
        corner += ivec2(gl_VertexIndex & 1, gl_VertexIndex >> 1);
    vec2 pixel = min(vec2(corner * TRIM_TILE), frame.pixels);
    gl_Position = vec4(2.0 * pixel / frame.pixels - 1.0, 0.5, 1.0);
}
