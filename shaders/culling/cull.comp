// Step 1 of the VisibleList: each group's visible KSQuads as two words of bits, which start as zero. No barrier: the
// software driver compiles a stage with long code before a barrier for most of a minute.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "cull_chain.glsl"

layout(local_size_x = CULL_KSQUADS) in;

layout(set = 0, binding = BINDING_CULL_GROUPS, scalar) buffer GroupBuffer { uint groups[][3]; };

void main()
{
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint lane = gl_LocalInvocationID.x;
    uint index = group * CULL_KSQUADS + lane;
    if (index < frame.ksquadCount && survivesCulling(index))
        atomicOr(groups[group][lane / 32u], 1u << (lane % 32u));
}
