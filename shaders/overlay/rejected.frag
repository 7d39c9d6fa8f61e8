// A mode's colour; dimmer where the surface hides it.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "../shared/bindings.h"
#include "../shared/layouts.h"

layout(push_constant, scalar) uniform Constants { OverlayConstants overlay; };
layout(location = 0) flat in vec3 inColour;
layout(location = 0) out vec4 outColour;

void main() { outColour = vec4(inColour, overlay.colour.a); }
