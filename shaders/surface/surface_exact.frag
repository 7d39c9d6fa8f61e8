// The fragment stage of all paths where a picture judges surfaces.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "exact_surface.glsl"
