// A normal of each KSQuad.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "normal_line.glsl"
