// Which KSQuads choose a grid, where some are not drawn: the same text for GLSL, where the stage has declared isVisible(),
// and for C++.
#ifndef KNOTSPAN_ASKING_GLSL
#define KNOTSPAN_ASKING_GLSL

#include "edges.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

// Whether what runs along a side is drawn.
KNOTSPAN_SCENE_TEMPLATE
bool isVisibleAlong(KNOTSPAN_SOURCE SurfacePlace place, uint ksquad, uint side)
{
    uint inner = innerNeighbour(place, ksquad, side);
    if (inner != NO_SIDE)
        return KNOTSPAN_IS_VISIBLE(inner / 4u);
    BorderSide border = KNOTSPAN_BORDER_SIDE(borderSideIndex(place, side));
    uint kind = border.flags & BORDER_KIND;
    if (kind == BORDER_WHOLE)
        return KNOTSPAN_IS_VISIBLE(border.other / 4u);
    if (kind != BORDER_PIECES)
        return false;
    for (uint piece = 0u; piece < border.flags >> BORDER_COUNT_SHIFT; ++piece) {
        uint first = KNOTSPAN_BORDER_PIECE(border.other + piece).firstUse;
        uint count = KNOTSPAN_BORDER_PIECE(border.other + piece).useCount;
        for (uint k = 0u; k < count; ++k)
            if (KNOTSPAN_IS_VISIBLE(KNOTSPAN_BORDER_USE(first + k).side / 4u))
                return true;
    }
    return false;
}

KNOTSPAN_SCENE_TEMPLATE
bool asks(KNOTSPAN_SOURCE uint ksquad)
{
    if (KNOTSPAN_IS_VISIBLE(ksquad))
        return true;
    SurfacePlace place = placeOf KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad);
    for (uint side = 0u; side < 4u; ++side)
        if (isVisibleAlong KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE place, ksquad, side))
            return true;
    return false;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
