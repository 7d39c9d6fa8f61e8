// Step 2 of the VisibleList: where each group's part starts, the exclusive sum of the groups' counts, by one group of
// threads in slices; and the total.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/counters.glsl"

layout(local_size_x = SCAN_THREADS) in;

layout(set = 0, binding = BINDING_CULL_GROUPS, scalar) buffer GroupBuffer { uint groups[][3]; };

shared uint sums[SCAN_THREADS];

uint countOf(uint group) { return bitCount(groups[group][0]) + bitCount(groups[group][1]); }

void main()
{
    uint lane = gl_LocalInvocationID.x;
    uint groupCount = (frame.ksquadCount + CULL_KSQUADS - 1u) / CULL_KSQUADS;
    uint slice = (groupCount + SCAN_THREADS - 1u) / SCAN_THREADS;
    uint begin = min(lane * slice, groupCount);
    uint end = min(begin + slice, groupCount);

    uint sum = 0u;
    for (uint group = begin; group < end; ++group)
        sum += countOf(group);
    sums[lane] = sum;
    barrier();
    uint start = 0u;
    uint total = 0u;
    for (uint other = 0u; other < SCAN_THREADS; ++other) {
        start += other < lane ? sums[other] : 0u;
        total += sums[other];
    }
    for (uint group = begin; group < end; ++group) {
        groups[group][2] = start;
        start += countOf(group);
    }

    if (lane == 0u)
        counters.drawn = total;
}
