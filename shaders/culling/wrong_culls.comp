// Counts the KSQuads that a culling mode drops though they show: a stage of its own, run when asked, that asks the chain
// again and then looks at points all over the KSQuad. Whether something else hides it is not asked.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "cull_chain.glsl"

layout(local_size_x = CULL_KSQUADS) in;

// Points along each side.
#define SHOWN_POINTS 9u
// The least cosine of a normal towards the eye that counts: what float makes of a normal near a pole is no more exact.
#define SHOWN_COSINE 1e-3

bool isInPicture(PixelMap map, vec4 point)
{
    float z = dot(map.z, point);
    float w = dot(map.w, point);
    vec2 most = map.middle * w;
    return z >= 0.0 && z <= w && abs(dot(map.x, point)) <= most.x && abs(dot(map.y, point)) <= most.y;
}

bool isTurnedTowards(vec4 eye, float side, vec3 position, vec3 normal)
{
    vec3 towards = eye.xyz - eye.w * position;
    return side == 0.0 || side * dot(normal, towards) > SHOWN_COSINE * length(towards);
}

bool showsAnything(uint index)
{
    KsQuadRecord ksquad = ksquads[index];
    PixelMap map = pixelMap(ksquad.surface);
    vec4 eye = surfaceViews[ksquad.surface].eye;
    float side = shownSide(ksquad.surface);
    bool shows = false;
    for (uint k = 0u; k < SHOWN_POINTS * SHOWN_POINTS && !shows; ++k) {
        SurfaceVertex vertex = vertexOf(ksquad, vec2(k % SHOWN_POINTS, k / SHOWN_POINTS) / float(SHOWN_POINTS - 1u));
        shows = isInPicture(map, vec4(vertex.at.position, 1.0)) &&
                isTurnedTowards(eye, side, vertex.at.position, vertex.normal);
    }
    return shows;
}

void main()
{
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint index = group * CULL_KSQUADS + gl_LocalInvocationID.x;
    if (index >= frame.ksquadCount)
        return;
    int mode = culledBy(index, frame.cullBits);
    if (mode != NOT_CULLED && (frame.judgedBits & 1u << mode) != 0u && showsAnything(index))
        atomicAdd(counters.wronglyCulled[mode], 1u);
}
