// What the stages count and, when a test asks, which vertices they made.
#ifndef KNOTSPAN_COUNTERS_GLSL
#define KNOTSPAN_COUNTERS_GLSL

#include "scene.glsl"

layout(set = 0, binding = BINDING_COUNTERS, scalar) buffer CounterBuffer { Counters counters; };
layout(set = 0, binding = BINDING_CAPTURED, scalar) writeonly buffer CapturedBuffer { CapturedRecord captured[]; };

#define KNOTSPAN_COUNT(counter, amount)                                                                             \
    {                                                                                                              \
        uint before = atomicAdd(counter[0], amount);                                                               \
        if (before + amount < before)                                                                              \
            atomicAdd(counter[1], 1u);                                                                             \
    }

void countDice(uint dice, uint triangles, uint evaluations)
{
    KNOTSPAN_COUNT(counters.ksdice, dice)
    KNOTSPAN_COUNT(counters.triangles, triangles)
    KNOTSPAN_COUNT(counters.evaluations, evaluations)
}

layout(constant_id = KNOTSPAN_CAPTURE_CONSTANT) const bool capturing = false;

void captureVertex(CapturedRecord vertex)
{
    if (!capturing)
        return;
    uint slot = atomicAdd(counters.captured, 1u);
    if (slot < frame.captureCapacity)
        captured[slot] = vertex;
}

#endif
