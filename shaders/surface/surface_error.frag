// The fragment stage of all paths where a picture shows errors.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "error_surface.glsl"
