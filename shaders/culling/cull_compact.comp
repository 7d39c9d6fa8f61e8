// Step 3 of the VisibleList: each visible KSQuad's index to its place, in order.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/scene.glsl"

layout(local_size_x = CULL_KSQUADS) in;

layout(set = 0, binding = BINDING_CULL_GROUPS, scalar) readonly buffer GroupBuffer { uint groups[][3]; };
layout(set = 0, binding = BINDING_VISIBLE, scalar) writeonly buffer VisibleBuffer { uint visible[]; };

void main()
{
    uint lane = gl_LocalInvocationID.x;
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    if (group * CULL_KSQUADS + lane >= frame.ksquadCount)
        return;
    uint word = groups[group][lane / 32u];
    uint bit = 1u << (lane % 32u);
    if ((word & bit) == 0u)
        return;
    uint before = bitCount(word & (bit - 1u)) + (lane < 32u ? 0u : bitCount(groups[group][0]));
    visible[groups[group][2] + before] = group * CULL_KSQUADS + lane;
}
