// What every path hands to the fragment stages, written once: the mesh stage says SURFACE_OUT([]), others
// SURFACE_OUT(ONE_VERTEX).
#ifndef KNOTSPAN_SURFACE_IO_GLSL
#define KNOTSPAN_SURFACE_IO_GLSL

#define ONE_VERTEX
#define SURFACE_OUT(array)                                                                                         \
    layout(location = 0) out vec3 outPosition array; /* eye-relative view space */                                 \
    layout(location = 1) out vec3 outNormal array;   /* unit, view space */                                        \
    layout(location = 2) out vec2 outT array;        /* inside the KSQuad */                                       \
    layout(location = 2, component = 2) out vec2 outWeightedT array;     /* outT outInverseWeight */               \
    layout(location = 1, component = 3) out float outInverseWeight array;                                          \
    layout(location = 3) flat out uint outKsquad array;
#define SURFACE_IN                                                                                                 \
    layout(location = 0) in vec3 inPosition;                                                                       \
    layout(location = 1) in vec3 inNormal;                                                                         \
    layout(location = 2) in vec2 inT;                                                                              \
    layout(location = 2, component = 2) in vec2 inWeightedT;                                                       \
    layout(location = 1, component = 3) in float inInverseWeight;                                                  \
    layout(location = 3) flat in uint inKsquad;

// A triangle's parameters run in two ways. As the rasterizer has it, with perspective, T is linear in space. The surface is
// linear, but for what the bound of grid_choice.glsl bounds, in homogeneous coordinates, weight included: on such a
// triangle, which covers the same pixels, T / weight and 1 / weight are linear in space.
float inverseWeight(float weight) { return 1.0 / clamp(weight, 1e-30, 1e30); }

#endif
