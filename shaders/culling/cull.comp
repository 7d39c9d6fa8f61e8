// Step 1 of the VisibleList: each group's visible KSQuads as two words of bits, which start as zero. No barrier: the
// software driver compiles a stage with long code before a barrier for most of a minute.
#version 460
#extension GL_GOOGLE_include_directive : require

#define KNOTSPAN_VERDICT_ACCESS
#include "cull_chain.glsl"

layout(local_size_x = CULL_KSQUADS) in;

layout(set = 0, binding = BINDING_CULL_GROUPS, scalar) buffer GroupBuffer { CullGroup groups[]; };
layout(set = 0, binding = BINDING_CANDIDATES, scalar) buffer CandidateBuffer { uint candidates[]; };
layout(set = 0, binding = BINDING_SEEN, scalar) readonly buffer SeenBuffer { uint seen[]; };

void main()
{
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint lane = gl_LocalInvocationID.x;
    uint index = group * CULL_KSQUADS + lane;
    if (index >= frame.ksquadCount)
        return;
    int mode = verdictOn(index);
    if (notesVerdicts())
        verdicts[index] = uint(mode + 1);
    if (!survives(mode))
        return;
    uint bit = 1u << (lane % 32u);
    if ((frame.cullBits & CULL_BY_DEPTH) != 0u) {
        // What the last frame saw is drawn first; occlusion.comp looks at the rest.
        uint word = 2u * group + lane / 32u;
        atomicOr(candidates[word], bit);
        if ((seen[word] & bit) == 0u)
            return;
    }
    atomicOr(groups[group].visible[lane / 32u], bit);
}
