// What was drawn so far: of each pixel its colour, then of each its depth; and then for each tile of the picture whether
// borders of trimmed surfaces run in it.
#ifndef KNOTSPAN_DRAWN_PIXELS_GLSL
#define KNOTSPAN_DRAWN_PIXELS_GLSL

#include "../shared/scene.glsl"
#include "../shared/trim_tiles.h"

layout(set = 0, binding = BINDING_DRAWN, scalar) buffer DrawnBuffer { uint drawn[]; };

ivec2 size = ivec2(frame.pixels);
uint tilesAcross = uint(size.x + TRIM_TILE - 1) / uint(TRIM_TILE);

uint colourAt(ivec2 pixel) { return drawn[pixel.y * size.x + pixel.x]; }
float depthAt(ivec2 pixel) { return uintBitsToFloat(drawn[(size.y + pixel.y) * size.x + pixel.x]); }
uint firstTile() { return 2u * uint(size.x * size.y); }
bool isInPicture(ivec2 pixel) { return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, size)); }

#endif
