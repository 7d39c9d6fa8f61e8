// The second half of culling by occlusion. What the last frame saw has been drawn; of what passed the tests before, that
// which could still show in front of it is drawn now. And the next frame starts with all that could show. Tests of where a
// KSQuad is in the picture wait for this half, too: most that fail them were not seen by the last frame either.
#version 460
#extension GL_GOOGLE_include_directive : require

#define KNOTSPAN_VERDICT_ACCESS
#include "cull_chain.glsl"
#include "depth_pyramid.glsl"

layout(local_size_x = CULL_KSQUADS) in;

layout(set = 0, binding = BINDING_CULL_GROUPS, scalar) buffer GroupBuffer { CullGroup groups[]; };
layout(set = 0, binding = BINDING_CANDIDATES, scalar) readonly buffer CandidateBuffer { uint candidates[]; };
layout(set = 0, binding = BINDING_SEEN, scalar) readonly buffer SeenBuffer { uint seen[]; };
layout(set = 0, binding = BINDING_SEEN_NOW, scalar) buffer SeenNowBuffer { uint seenNow[]; };

// Whether everything that is drawn of a KSQuad would be behind what is there. At most 4 x 4 texels are looked at.
bool isOccluded(HullOnScreen hull)
{
    if (!hull.front)
        return false;
    vec2 edge = frame.pixels - vec2(1.0);
    uvec2 low = uvec2(clamp(floor(hull.low + 0.5 * frame.pixels), vec2(0.0), edge));
    uvec2 high = uvec2(clamp(floor(hull.high + 0.5 * frame.pixels), vec2(0.0), edge));
    uint level = 0u;
    while (any(greaterThan((high >> level) - (low >> level), uvec2(3u))))
        ++level;
    uint from = levelStart(level);
    uint row = levelSize(level).x;
    low >>= level;
    high >>= level;
    float farthest = 1.0;
    for (uint y = low.y; y <= high.y; ++y)
        for (uint x = low.x; x <= high.x; ++x)
            farthest = min(farthest, depths[from + y * row + x]);
    return hull.nearest < farthest;
}

void main()
{
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint lane = gl_LocalInvocationID.x;
    uint index = group * CULL_KSQUADS + lane;
    uint word = 2u * group + lane / 32u;
    uint bit = 1u << (lane % 32u);
    if (index >= frame.ksquadCount || (candidates[word] & bit) == 0u)
        return;
    bool drawn = (seen[word] & bit) != 0u;
    SeenKsQuad view = seenKsQuad(index);
    view.hull = hullOnScreen(index);
    int mode = culledByHull(index, view, frame.cullBits);
    if (mode == NOT_CULLED && isOccluded(view.hull))
        mode = CULL_OCCLUSION;
    if (mode == NOT_CULLED) {
        atomicOr(seenNow[word], bit);
        if (!drawn)
            atomicOr(groups[group].visible[lane / 32u], bit);
        return;
    }
    if (notesVerdicts())
        verdicts[index] = uint(mode + 1);
    if (!drawn)
        atomicAdd(counters.culled[mode], 1u);
}
