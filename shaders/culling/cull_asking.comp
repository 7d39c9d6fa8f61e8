// Step 2 of the VisibleList: who chooses a grid though it is not drawn: the neighbours of those that are, whose edges are
// as fine as either side asks. So what is drawn is the same to the bit, whatever was culled beside it.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/grid_scene.glsl"

layout(local_size_x = CULL_KSQUADS) in;

layout(set = 0, binding = BINDING_CULL_GROUPS, scalar) buffer GroupBuffer { CullGroup groups[]; };

bool isVisible(uint index)
{
    uint lane = index % CULL_KSQUADS;
    return (groups[index / CULL_KSQUADS].visible[lane / 32u] & 1u << (lane % 32u)) != 0u;
}

#include "../shared/asking.glsl"

void main()
{
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint lane = gl_LocalInvocationID.x;
    uint index = group * CULL_KSQUADS + lane;
    uint bit = 1u << (lane % 32u);
    if (index < frame.ksquadCount && (groups[group].asked[lane / 32u] & bit) == 0u && asks(index))
        atomicOr(groups[group].asking[lane / 32u], bit);
}
