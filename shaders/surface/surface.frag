// The fragment stage of all paths.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "lit_surface.glsl"
