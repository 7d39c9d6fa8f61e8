// The chain of tests, made from the list: which mode, if any, drops a KSQuad.
#ifndef KNOTSPAN_CULL_CHAIN_GLSL
#define KNOTSPAN_CULL_CHAIN_GLSL

#include "../shared/counters.glsl"
#include "../shared/frame_map.glsl"
#include "../shared/verdicts.glsl"
#include "evs.glsl"
#include "frustum.glsl"
#include "hull_on_screen.glsl"
#include "lqc.glsl"
#include "occlusion.glsl"
#include "small.glsl"
#include "surface.glsl"

layout(set = 0, binding = BINDING_FACING_RAYS, scalar) readonly buffer RayBuffer { uint facingWords[]; };
#include "../shared/facing_forms.glsl"
layout(set = 0, binding = BINDING_FACING, scalar) readonly buffer FacingBuffer { FacingRecord facing[]; };
#include "sqc.glsl"

#include "../shared/trimming_words.glsl"
// From TRIM_RECORDS on it is another one for each point.
uint trimVerdict(uint ksquad) { return (frame.flags & FRAME_TRIMMED) == 0u ? TRIM_WHOLE : trimWords[ksquad]; }
#include "trimmed.glsl"

#define NOT_CULLED (-1)

// The bit of the first mode among these that says so, or NOT_CULLED.
int culledByHull(uint ksquad, SeenKsQuad seen, uint bits)
{
#define KNOTSPAN_TEST(bit, name, culls, conservative, byDefault, colour, sentence)                                 \
    if ((CULL_BY_HULL & (1u << bit)) != 0u && (bits & (1u << bit)) != 0u && culls(ksquad, seen))                   \
        return bit;
    KNOTSPAN_CULL_LIST(KNOTSPAN_TEST)
#undef KNOTSPAN_TEST
    return NOT_CULLED;
}

int culledBy(uint ksquad, uint bits)
{
    SeenKsQuad seen = seenKsQuad(ksquad);
#define KNOTSPAN_TEST(bit, name, culls, conservative, byDefault, colour, sentence)                                 \
    if ((CULL_LATE & (1u << bit)) == 0u && (bits & (1u << bit)) != 0u && culls(ksquad, seen))                      \
        return bit;
    KNOTSPAN_CULL_LIST(KNOTSPAN_TEST)
#undef KNOTSPAN_TEST
    if ((bits & CULL_BY_HULL) != 0u) {
        seen.hull = hullOnScreen(ksquad);
        int mode = culledByHull(ksquad, seen, bits);
        if (mode != NOT_CULLED)
            return mode;
    }
#define KNOTSPAN_TEST(bit, name, culls, conservative, byDefault, colour, sentence)                                 \
    if ((CULL_BY_RAYS & (1u << bit)) != 0u && (bits & (1u << bit)) != 0u && culls(ksquad, seen))                   \
        return bit;
    KNOTSPAN_CULL_LIST(KNOTSPAN_TEST)
#undef KNOTSPAN_TEST
    return NOT_CULLED;
}

// By all that are on; where a culling camera stands still as it was said from there. By occlusion, hulls are only made for
// the second half of the frame, which needs them anyway.
int verdictOn(uint ksquad)
{
    if (keepsVerdicts())
        return int(verdicts[ksquad]) - 1;
    bool byDepth = (frame.cullBits & CULL_BY_DEPTH) != 0u;
    return culledBy(ksquad, byDepth ? frame.cullBits & ~CULL_BY_HULL : frame.cullBits);
}

// Counts the verdict and says whether to draw.
bool survives(int mode)
{
    if (mode == NOT_CULLED)
        return true;
    atomicAdd(counters.culled[mode], 1u);
    return false;
}

#endif
