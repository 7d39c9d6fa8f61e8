// surface_exact.frag where surfaces are trimmed.
#version 460
#extension GL_GOOGLE_include_directive : require

#define KNOTSPAN_TRIMMED
#include "exact_surface.glsl"
