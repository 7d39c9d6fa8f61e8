// Moves every control point by a wave along the model's z: what `--deform all` does without a byte sent.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "../shared/bindings.h"
#include "../shared/layouts.h"

layout(local_size_x = WAVE_POINTS) in;

layout(set = 0, binding = BINDING_FRAME, scalar) readonly buffer FrameBuffer { FrameRecord frame; };
layout(set = 0, binding = BINDING_SURFACES, scalar) readonly buffer SurfaceBuffer { SurfaceRecord surfaces[]; };
layout(set = 0, binding = BINDING_WAVES, scalar) readonly buffer WaveBuffer { WaveRecord waves[]; };
layout(set = 0, binding = BINDING_REST_POINTS, scalar) readonly buffer RestBuffer { vec4 rest[]; };
layout(set = 0, binding = BINDING_CONTROL_POINTS, scalar) writeonly buffer PointBuffer { vec4 points[]; };

void main()
{
    uint index = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * WAVE_POINTS + gl_LocalInvocationID.x;
    if (index >= frame.pointCount)
        return;
    // The last surface whose net starts no later.
    uint low = 0u;
    uint high = frame.surfaceCount - 1u;
    while (low < high) {
        uint middle = (low + high + 1u) / 2u;
        if (surfaces[middle].firstPoint <= index)
            low = middle;
        else
            high = middle - 1u;
    }
    WaveRecord wave = waves[low];
    vec4 point = rest[index];
    float phase = dot(wave.phase, point.xyz / point.w) + wave.phaseAtOrigin;
    point.xyz += point.w * (sin(phase + wave.time) - sin(phase)) * wave.move;
    points[index] = point;
}
