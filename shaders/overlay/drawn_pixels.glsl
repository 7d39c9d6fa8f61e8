// What was drawn so far: of each pixel its colour, then of each its depth, then what it shows (pickedOf); then the list of
// pixels where trimmed surfaces may end.
#ifndef KNOTSPAN_DRAWN_PIXELS_GLSL
#define KNOTSPAN_DRAWN_PIXELS_GLSL

#include "../shared/scene.glsl"
#include "../shared/trim_tiles.h"
#include "../surface/pixel_place.glsl"

layout(set = 0, binding = BINDING_DRAWN, scalar) buffer DrawnBuffer { uint drawn[]; };

ivec2 size = ivec2(frame.pixels);

uint numberOf(ivec2 pixel) { return uint(pixel.y * size.x + pixel.x); }
uint colourAt(ivec2 pixel) { return drawn[numberOf(pixel)]; }
uint pixels() { return uint(size.x * size.y); }
float depthAt(ivec2 pixel) { return uintBitsToFloat(drawn[pixels() + numberOf(pixel)]); }
uint pickedAt(ivec2 pixel) { return drawn[2u * (pixels() + numberOf(pixel))]; }
uint placeAt(ivec2 pixel) { return drawn[2u * (pixels() + numberOf(pixel)) + 1u]; }
bool isInPicture(ivec2 pixel) { return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, size)); }

// Where a pixel's result waits: nobody asks any more where in the KSQuad it lies.
void setResult(ivec2 pixel, uint colour) { drawn[2u * (pixels() + numberOf(pixel)) + 1u] = colour; }
uint resultAt(ivec2 pixel) { return placeAt(pixel); }

// The list: groups along x, y and z that work on it, how many there are, and then each pixel, x + 2^16 y.
uint firstListed() { return 4u * pixels(); }
uint listedCount() { return drawn[firstListed() + 3u]; }
ivec2 listedPixel(uint k)
{
    uint listed = drawn[firstListed() + uint(TRIM_LIST_HEAD) + k];
    return ivec2(listed & 0xffffu, listed >> 16u);
}

#endif
