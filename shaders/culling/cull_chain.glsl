// The chain of tests, made from the list: which mode, if any, drops a KSQuad.
#ifndef KNOTSPAN_CULL_CHAIN_GLSL
#define KNOTSPAN_CULL_CHAIN_GLSL

#include "../shared/counters.glsl"
#include "lqc.glsl"
#include "surface.glsl"

#define NOT_CULLED (-1)

// The bit of the first mode that is on and says so, or NOT_CULLED.
int culledBy(KsQuadRecord ksquad)
{
    SurfaceView view = surfaceViews[ksquad.surface];
#define KNOTSPAN_TEST(bit, name, culls, conservative, sentence)                                                    \
    if ((frame.cullBits & (1u << bit)) != 0u && culls(ksquad, view))                                               \
        return bit;
    KNOTSPAN_CULL_LIST(KNOTSPAN_TEST)
#undef KNOTSPAN_TEST
    return NOT_CULLED;
}

// Counts the verdict and says whether to draw.
bool survivesCulling(uint index)
{
    int mode = culledBy(ksquads[index]);
    if (mode == NOT_CULLED)
        return true;
    atomicAdd(counters.culled[mode], 1u);
    return false;
}

#endif
