// What was drawn so far, of some rows of the picture: after a head (trim_tiles.h) of each pixel its colour, then of each its depth,
// then what it shows (pickedOf); then the list of pixels where trimmed surfaces may end, each x + 2^16 y.
#ifndef KNOTSPAN_DRAWN_PIXELS_GLSL
#define KNOTSPAN_DRAWN_PIXELS_GLSL

#include "../shared/scene.glsl"
#include "../shared/trim_tiles.h"
#include "../shared/pixel_place.glsl"

layout(set = 0, binding = BINDING_DRAWN, scalar) buffer DrawnBuffer { uint drawn[]; };

ivec2 size = ivec2(frame.pixels.x, drawn[TRIM_HEAD_ROWS]);

uint numberOf(ivec2 pixel) { return uint(pixel.y * size.x + pixel.x); }
uint pixels() { return uint(size.x * size.y); }
uint colourWord(ivec2 pixel) { return uint(TRIM_HEAD) + numberOf(pixel); }
uint shownWord(ivec2 pixel) { return uint(TRIM_HEAD) + 2u * (pixels() + numberOf(pixel)); }
uint colourAt(ivec2 pixel) { return drawn[colourWord(pixel)]; }
float depthAt(ivec2 pixel) { return uintBitsToFloat(drawn[uint(TRIM_HEAD) + pixels() + numberOf(pixel)]); }
uint pickedAt(ivec2 pixel) { return drawn[shownWord(pixel)]; }
uint placeAt(ivec2 pixel) { return drawn[shownWord(pixel) + 1u]; }
// In the picture.
vec2 centreOf(ivec2 pixel) { return vec2(pixel) + vec2(0.5, float(drawn[TRIM_HEAD_FIRST_ROW]) + 0.5); }
bool isInPicture(ivec2 pixel) { return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, size)); }

// Where trimmed surfaces end in listed pixels takes the place of where in the KSQuad they lie; a colour's opacity says whether
// that was found. Then nobody asks any more which KSQuad shows, and a pixel's result waits there.
void setCode(ivec2 pixel, uint code)
{
    drawn[shownWord(pixel) + 1u] = code;
    drawn[colourWord(pixel)] &= 0xffffffu;
}
bool hasCode(ivec2 pixel) { return colourAt(pixel) >> 24 == 0u; }
uint codeAt(ivec2 pixel) { return drawn[shownWord(pixel) + 1u]; }
void setResult(ivec2 pixel, uint colour) { drawn[shownWord(pixel)] = colour; }
uint resultAt(ivec2 pixel) { return drawn[shownWord(pixel)]; }

uint firstListed() { return uint(TRIM_HEAD) + 4u * pixels(); }
uint listedCount() { return drawn[TRIM_HEAD_COUNT]; }
ivec2 listedPixel(uint k)
{
    uint listed = drawn[firstListed() + k];
    return ivec2(listed & 0xffffu, listed >> 16u);
}

#endif
