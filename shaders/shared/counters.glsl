// What the stages count and, when a test asks, which vertices they made.
#ifndef KNOTSPAN_COUNTERS_GLSL
#define KNOTSPAN_COUNTERS_GLSL

#include "scene.glsl"

layout(set = 0, binding = BINDING_COUNTERS, scalar) buffer CounterBuffer { Counters counters; };
layout(set = 0, binding = BINDING_CAPTURED, scalar) writeonly buffer CapturedBuffer { CapturedRecord captured[]; };

void countDice(uint dice, uint triangles, uint evaluations)
{
    atomicAdd(counters.ksdice, dice);
    atomicAdd(counters.triangles, triangles);
    atomicAdd(counters.evaluations, evaluations);
}

void captureVertex(uint ksquad, vec2 t, vec3 position, vec3 normal)
{
    if ((frame.flags & FRAME_CAPTURE) == 0u)
        return;
    uint slot = atomicAdd(counters.captured, 1u);
    if (slot < frame.captureCapacity)
        captured[slot] = CapturedRecord(ksquad, t, position, normal);
}

#endif
