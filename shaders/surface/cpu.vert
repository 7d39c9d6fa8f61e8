// The vertex stage of the path cpu: vertices as the processor made them, seen by this frame's camera.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/scene.glsl"
#include "surface_io.glsl"

layout(set = 0, binding = BINDING_VERTICES, scalar) readonly buffer VertexBuffer { ObjectVertex vertices[]; };

SURFACE_OUT(ONE_VERTEX)

void main()
{
    ObjectVertex vertex = vertices[gl_VertexIndex];
    outPosition = toView(ksquads[vertex.source].surface, vertex.position);
    gl_Position = toClip(outPosition);
    outNormal = normalToView(ksquads[vertex.ksquad].surface, vertex.normal);
    gl_CullDistance[0] = shownTowards(ksquads[vertex.ksquad].surface, outPosition, outNormal);
    outT = vertex.t;
    outInverseWeight = inverseWeight(vertex.weight);
    outWeightedT = outInverseWeight * vertex.t;
    outKsquad = vertex.ksquad;
}
