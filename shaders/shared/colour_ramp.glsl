// Colours of numbers, for the fragment stage and for the legend beside the picture: the same text for GLSL and for C++.
#ifndef KNOTSPAN_COLOUR_RAMP_GLSL
#define KNOTSPAN_COLOUR_RAMP_GLSL

#include "language.h"

#ifdef __cplusplus
#include <glm/common.hpp>

namespace knotspan::gpu {
using glm::clamp;
using glm::mix;
#endif

// Blue below, orange above, pale between: people of any colour vision tell both ends apart. `place` from 0 to 1, and beyond
// either end like it; sRGB, encoded.
KNOTSPAN_INLINE vec3 rampColour(float place)
{
    float at = 4.0f * clamp(place, 0.0f, 1.0f);
    if (at < 1.0f)
        return mix(vec3(0.09f, 0.24f, 0.58f), vec3(0.44f, 0.65f, 0.87f), at);
    if (at < 2.0f)
        return mix(vec3(0.44f, 0.65f, 0.87f), vec3(0.94f, 0.94f, 0.91f), at - 1.0f);
    if (at < 3.0f)
        return mix(vec3(0.94f, 0.94f, 0.91f), vec3(0.96f, 0.68f, 0.36f), at - 2.0f);
    return mix(vec3(0.96f, 0.68f, 0.36f), vec3(0.70f, 0.25f, 0.01f), at - 3.0f);
}

// What has no number.
KNOTSPAN_INLINE vec3 noNumberColour() { return vec3(0.5f, 0.5f, 0.5f); }

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
