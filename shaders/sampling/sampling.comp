// How many cells each asking KSQuad (cull_asking.comp) asks for along its sides, by the frame's sampling rule (sampling_rules.glsl). By
// the bound: first a thread a KSQuad, by one window for the whole; those that want more than two cells wait in a list, and
// GRID_LANES threads work on each. One loop, so that the making of windows stands in the stage once.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/counters.glsl"
#include "sampling_rules.glsl"

layout(local_size_x = LIST_KSQUADS) in;

layout(set = 0, binding = BINDING_ASKING, scalar) readonly buffer AskingBuffer { uint asking[]; };
layout(set = 0, binding = BINDING_GRIDS, scalar) writeonly buffer GridBuffer { GridRecord grids[]; };

// A ring: each entry that is taken comes back at most once for each turn.
#define WAITING (2 * LIST_KSQUADS)
#define AT_ONCE (LIST_KSQUADS / GRID_LANES)

shared WindowFigures windows[LIST_KSQUADS];
shared uint waiting;
shared uint waitingKsquads[WAITING];
shared FirstGrid firstGrids[WAITING];
shared uint best[WAITING];

#include "../shared/grid_search.glsl"

void choose(uint ksquad, uint u, uint v, float bound)
{
    grids[ksquad] = GridRecord(v | v << 16u, u | u << 16u);
    atomicMax(counters.errorBound, floatBitsToUint(bound));
}

// After the search for a KSQuad, by one of its threads: its grid, or another turn with closer windows.
void conclude(uint place, uint firstWindow)
{
    uint ksquad = waitingKsquads[place];
    uint key = best[place];
    bool shows = false;
    for (uint k = 0u; k < GRID_LANES; ++k)
        shows = shows || windows[firstWindow + k].visible;
    if (!shows) {
        grids[ksquad] = GridRecord(0u, 0u);
        return;
    }
    FirstGrid next = nextLevel(firstGrids[place], key);
    if (next.level == GRID_LEVELS) {
        choose(ksquad, keyU(key), keyV(key), key == GRID_NONE ? GRID_HUGE : frame.tolerancePx);
    } else {
        uint slot = atomicAdd(waiting, 1u);
        waitingKsquads[slot % WAITING] = ksquad;
        firstGrids[slot % WAITING] = next;
        best[slot % WAITING] = key;
    }
}

void main()
{
    uint thread = gl_LocalInvocationID.x;
    uint index = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * LIST_KSQUADS + thread;
    if (frame.samplingRule != RULE_BOUND) {
        if (index < counters.asking)
            grids[asking[index]] = gridByLength(ksquads[asking[index]]);
        return;
    }
    if (thread == 0u)
        waiting = 0u;
    barrier();
    // Turn 0: a KSQuad a thread. Then AT_ONCE of those that wait.
    bool works = index < counters.asking;
    uint ksquad = works ? asking[index] : 0u;
    uint place = 0u;
    uint lane = 0u;
    FirstGrid first = FirstGrid(1u, 1u, 1u, 1u, 0u);
    uint next = 0u;  // of those that wait
    for (bool whole = true;; whole = false) {
        uint held = waiting;
        if (!whole) {
            uint number = next + thread / GRID_LANES;
            place = number % WAITING;
            lane = thread % GRID_LANES;
            works = number < held;
            if (works) {
                ksquad = waitingKsquads[place];
                first = firstGrids[place];
            }
        }
        barrier();  // conclude() changes the list
        if (works) {
            KsQuadRecord record = ksquads[ksquad];
            uint count = whole ? 1u : windowsOfLane(first);
            WindowFigures sum;
            sum.visible = false;
            for (uint k = 0u; k < count; ++k) {
                uint number = lane * count + k;
                WindowFigures one = windowFigures(placeOfNumbers(record), pixelMap(record.surface),
                                                  stretchAlongU(first, number), stretchAlongV(first, number));
                sum = whole ? one : joined(sum, normalised(one));
            }
            windows[thread] = sum;
        }
        if (works && whole) {
            first = firstGrid(windows[thread], frame.tolerancePx);
            if (!windows[thread].visible) {
                grids[ksquad] = GridRecord(0u, 0u);
            } else if (first.level == GRID_LEVELS) {
                choose(ksquad, first.u, first.v, windowBound(windows[thread], 1.0 / float(first.u), 1.0 / float(first.v)));
            } else {
                uint slot = atomicAdd(waiting, 1u);
                waitingKsquads[slot] = ksquad;
                firstGrids[slot] = first;
                best[slot] = gridKey(first.u, first.v);
            }
        }
        barrier();
        if (!whole) {
            if (works)
                atomicMin(best[place], bestOfLane(thread - lane, first, lane, frame.tolerancePx));
            barrier();
            if (works && lane == 0u)
                conclude(place, thread);
        }
        barrier();
        // What came back behind the last one is to be looked at too.
        if (!whole)
            next = min(next + AT_ONCE, held);
        if (next >= waiting)
            break;
    }
}
