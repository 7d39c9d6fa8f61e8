// The surface at given points, in the compute stage: for tests and measurements of evaluation by itself.
#include "../shared/scene.glsl"

layout(local_size_x = EVALUATE_THREADS) in;

layout(set = 0, binding = BINDING_CAPTURED, scalar) writeonly buffer EvaluatedBuffer { EvaluatedRecord evaluated[]; };
layout(set = 0, binding = BINDING_REQUESTS, scalar) readonly buffer RequestBuffer { RequestRecord requests[]; };

void main()
{
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint index = group * EVALUATE_THREADS + gl_LocalInvocationID.x;
    if (index >= frame.captureCapacity)
        return;
    SurfaceVertex vertex = vertexOf(ksquads[requests[index].ksquad], requests[index].t);
    evaluated[index] = EvaluatedRecord(vertex.at.position, vertex.at.du, vertex.at.dv, vertex.normal);
}
