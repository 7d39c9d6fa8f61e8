// What the culling modes look at: a KSQuad as this frame's camera sees it. The same text for GLSL and for C++.
#ifndef KNOTSPAN_SEEN_KSQUAD_GLSL
#define KNOTSPAN_SEEN_KSQUAD_GLSL

#include "../shared/language.h"
#include "../shared/layouts.h"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

// Where all of a KSQuad is in the picture (hull_on_screen.glsl).
struct HullOnScreen {
    uint beyond;  // a bit for each clip plane beyond which all of it is
    bool front;   // all of it is in front of the near plane; otherwise low and high say nothing
    vec2 low;     // pixels from the picture's middle
    vec2 high;
    float nearest;  // depth; reversed, so the greatest
};

struct SeenKsQuad {
    SurfaceView view;   // of its surface
    float side;         // of it that is shown alone: 1 or -1; 0: both are
    HullOnScreen hull;  // made where a mode that is on asks for it (CULL_BY_HULL)
};

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
