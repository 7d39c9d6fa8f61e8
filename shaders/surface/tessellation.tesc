// The control stage of the path tessellation: a tile's cells as they are, the same along opposite sides, so that the
// tessellator makes the regular grid whose border vertices borders.glsl takes to those of the edges.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/grid_scene.glsl"

layout(vertices = 1) out;

layout(location = 0) flat in uint inTile[];
layout(location = 0) flat out uint outTile[];

void main()
{
    uint index = inTile[0];
    outTile[gl_InvocationID] = index;
    uint cells = tiles[index].cells;
    float u = float(cells & 0xffffu);
    float v = float(cells >> 16u);
    // In the tessellator's order: the sides u = 0, v = 0, u = 1, v = 1.
    gl_TessLevelOuter[0] = v;
    gl_TessLevelOuter[1] = u;
    gl_TessLevelOuter[2] = v;
    gl_TessLevelOuter[3] = u;
    gl_TessLevelInner[0] = u;
    gl_TessLevelInner[1] = v;

    // The tessellator makes 2 of an inner 1 unless all six are 1 (Vulkan, "Quad Tessellation"): a middle row, joined to
    // a border of u + v sides twice.
    float n = max(u, 2.0);
    float m = max(v, 2.0);
    float border = 2.0 * (u + v);
    bool single = u == 1.0 && v == 1.0;
    float triangles = single ? 2.0 : 2.0 * (n - 2.0) * (m - 2.0) + border + 2.0 * (n - 2.0) + 2.0 * (m - 2.0);
    countDice(uint(u * v), uint(triangles), single ? 4u : uint((n - 1.0) * (m - 1.0) + border));
}
