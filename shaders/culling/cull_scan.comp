// Step 3 of the VisibleList: where each group's parts of the two lists start; and the totals.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/counters.glsl"

layout(set = 0, binding = BINDING_CULL_GROUPS, scalar) buffer GroupBuffer { CullGroup groups[]; };

layout(set = 0, binding = BINDING_LISTS, scalar) writeonly buffer ListBuffer { ListGroups lists; };

uvec2 countOf(uint group)
{
    return uvec2(bitCount(groups[group].visible[0]) + bitCount(groups[group].visible[1]),
                 bitCount(groups[group].asking[0]) + bitCount(groups[group].asking[1]));
}
void startAt(uint group, uvec2 start) { groups[group].start = start; }

#include "../shared/scan.glsl"

uvec3 groupsFor(uint ksquads)
{
    uint count = (ksquads + LIST_KSQUADS - 1u) / LIST_KSQUADS;
    uint x = clamp(count, 1u, 65535u);
    return uvec3(count == 0u ? 0u : x, (count + x - 1u) / x, 1u);
}

void main()
{
    uvec2 total = scanGroups((frame.ksquadCount + CULL_KSQUADS - 1u) / CULL_KSQUADS);
    if (gl_LocalInvocationID.x == 0u) {
        counters.visible = total.x;
        counters.drawn += total.x;
        counters.asking = total.y;
        lists = ListGroups(groupsFor(total.x), groupsFor(total.y));
    }
}
