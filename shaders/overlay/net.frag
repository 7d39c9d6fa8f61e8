// One colour; points are round.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "../shared/bindings.h"
#include "../shared/layouts.h"

layout(push_constant, scalar) uniform Constants { OverlayConstants overlay; };
layout(constant_id = KNOTSPAN_LINES_CONSTANT) const bool kLines = false;
layout(location = 0) flat in float inSize;
layout(location = 0) out vec4 outColour;

void main()
{
    float opacity = overlay.colour.a;
    if (!kLines) {
        float radius = 0.5 * inSize;
        float distanceIn = radius - length((gl_PointCoord - 0.5) * inSize);
        opacity *= clamp(distanceIn + 0.5, 0.0, 1.0);
        if (opacity <= 0.0)
            discard;
    }
    outColour = vec4(overlay.colour.rgb, opacity);
}
