// surface_error.frag where surfaces are trimmed.
#version 460
#extension GL_GOOGLE_include_directive : require

#define KNOTSPAN_TRIMMED
#include "error_surface.glsl"
