// Where a surface's points fall in the picture: the same text for GLSL and for C++.
#ifndef KNOTSPAN_PIXEL_MAP_GLSL
#define KNOTSPAN_PIXEL_MAP_GLSL

#include "language.h"
#include "layouts.h"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

// From a surface's own coordinates to homogeneous pixels, measured from the picture's middle: rows.
KNOTSPAN_TEMPLATE
struct PixelMap {
    KNOTSPAN_VEC4 x;
    KNOTSPAN_VEC4 y;
    KNOTSPAN_VEC4 z;   // of clip space: what shows has z <= w
    KNOTSPAN_VEC4 w;
    KNOTSPAN_VEC2 middle;  // half the picture's size
};

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
