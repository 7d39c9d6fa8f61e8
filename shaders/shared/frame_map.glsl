// The bound scene's pixel maps, by this frame's camera.
#ifndef KNOTSPAN_FRAME_MAP_GLSL
#define KNOTSPAN_FRAME_MAP_GLSL

#include "scene.glsl"
#include "pixel_map.glsl"

PixelMap pixelMap(uint surface)
{
    mat4x3 m = surfaceViews[surface].modelView;
    mat4 rows = transpose(frame.projection * mat4(vec4(m[0], 0.0), vec4(m[1], 0.0), vec4(m[2], 0.0), vec4(m[3], 1.0)));
    PixelMap map;
    map.middle = 0.5 * frame.pixels;
    map.x = map.middle.x * rows[0];
    map.y = map.middle.y * rows[1];
    map.z = rows[2];
    map.w = rows[3];
    return map;
}

#endif
