// Step 4 of the VisibleList: the index of each visible and of each asking KSQuad to its place, in order.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/scene.glsl"

layout(local_size_x = CULL_KSQUADS) in;

layout(set = 0, binding = BINDING_CULL_GROUPS, scalar) readonly buffer GroupBuffer { CullGroup groups[]; };
layout(set = 0, binding = BINDING_VISIBLE, scalar) writeonly buffer VisibleBuffer { uint visible[]; };
layout(set = 0, binding = BINDING_ASKING, scalar) writeonly buffer AskingBuffer { uint asking[]; };

void main()
{
    uint lane = gl_LocalInvocationID.x;
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint index = group * CULL_KSQUADS + lane;
    if (index >= frame.ksquadCount)
        return;
    uint bit = 1u << (lane % 32u);
    uint word = groups[group].asking[lane / 32u];
    if ((word & bit) != 0u) {
        uint before = bitCount(word & (bit - 1u)) + (lane < 32u ? 0u : bitCount(groups[group].asking[0]));
        asking[groups[group].start.y + before] = index;
    }
    word = groups[group].visible[lane / 32u];
    if ((word & bit) != 0u) {
        uint before = bitCount(word & (bit - 1u)) + (lane < 32u ? 0u : bitCount(groups[group].visible[0]));
        visible[groups[group].start.x + before] = index;
    }
}
