// The surface at given points, in the compute stage: for tests and measurements of evaluation by itself.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/scene.glsl"

layout(local_size_x = EVALUATE_THREADS) in;

layout(set = 0, binding = BINDING_CAPTURED, scalar) writeonly buffer CapturedBuffer { CapturedRecord captured[]; };
layout(set = 0, binding = BINDING_REQUESTS, scalar) readonly buffer RequestBuffer { RequestRecord requests[]; };

void main()
{
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint index = group * EVALUATE_THREADS + gl_LocalInvocationID.x;
    if (index >= frame.captureCapacity)
        return;
    RequestRecord request = requests[index];
    SurfaceVertex vertex = vertexOf(ksquads[request.ksquad], request.t);
    captured[index] = CapturedRecord(request.ksquad, request.t, vertex.position, vertex.normal);
}
