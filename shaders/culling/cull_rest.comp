// Between the halves of culling by occlusion: both lists start anew; who has chosen a grid keeps it.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/scene.glsl"

layout(local_size_x = CULL_KSQUADS) in;

layout(set = 0, binding = BINDING_CULL_GROUPS, scalar) buffer GroupBuffer { CullGroup groups[]; };

void main()
{
    uint group = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * CULL_KSQUADS + gl_LocalInvocationID.x;
    if (group >= (frame.ksquadCount + CULL_KSQUADS - 1u) / CULL_KSQUADS)
        return;
    for (uint word = 0u; word < 2u; ++word) {
        groups[group].visible[word] = 0u;
        groups[group].asked[word] = groups[group].asking[word];
        groups[group].asking[word] = 0u;
    }
}
