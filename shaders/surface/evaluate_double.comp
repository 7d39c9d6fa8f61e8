// The surface at given points, by the same text in double.
#version 460
#extension GL_GOOGLE_include_directive : require

#define KNOTSPAN_DOUBLE
#include "evaluate.glsl"
