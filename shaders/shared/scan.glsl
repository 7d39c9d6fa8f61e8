// Exclusive sums over groups' counts, by one group of threads in slices. The stage declares before it includes this:
//     uvec2 countOf(uint group);
//     void startAt(uint group, uvec2 start);
layout(local_size_x = SCAN_THREADS) in;

shared uvec2 sums[SCAN_THREADS];

// Calls startAt() for each group; returns the total.
uvec2 scanGroups(uint groupCount)
{
    uint lane = gl_LocalInvocationID.x;
    uint slice = (groupCount + SCAN_THREADS - 1u) / SCAN_THREADS;
    uint begin = min(lane * slice, groupCount);
    uint end = min(begin + slice, groupCount);
    uvec2 sum = uvec2(0u);
    for (uint group = begin; group < end; ++group)
        sum += countOf(group);
    sums[lane] = sum;
    barrier();
    uvec2 start = uvec2(0u);
    uvec2 total = uvec2(0u);
    for (uint other = 0u; other < SCAN_THREADS; ++other) {
        start += other < lane ? sums[other] : uvec2(0u);
        total += sums[other];
    }
    for (uint group = begin; group < end; ++group) {
        startAt(group, start);
        start += countOf(group);
    }
    return total;
}
