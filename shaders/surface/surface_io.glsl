// What every path hands to surface.frag, written once: the mesh stage says SURFACE_OUT([]), others
// SURFACE_OUT(ONE_VERTEX).
#define ONE_VERTEX
#define SURFACE_OUT(array)                                                                                         \
    layout(location = 0) out vec3 outPosition array; /* eye-relative view space */                                 \
    layout(location = 1) out vec3 outNormal array;   /* unit, view space */                                        \
    layout(location = 2) out vec2 outT array;        /* inside the KSQuad */                                       \
    layout(location = 3) flat out uint outKsquad array;
#define SURFACE_IN                                                                                                 \
    layout(location = 0) in vec3 inPosition;                                                                       \
    layout(location = 1) in vec3 inNormal;                                                                         \
    layout(location = 2) in vec2 inT;                                                                              \
    layout(location = 3) flat in uint inKsquad;
