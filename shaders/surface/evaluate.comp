// The surface at given points, in float.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "evaluate.glsl"
