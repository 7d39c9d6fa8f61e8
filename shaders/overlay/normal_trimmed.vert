// normal.vert where surfaces are trimmed.
#version 460
#extension GL_GOOGLE_include_directive : require

#define KNOTSPAN_TRIMMED
#include "normal_line.glsl"
