// The evaluation stage of the path surface: finds the KSQuad that a point of the whole surface lies in.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/counters.glsl"
#include "../shared/surface_spans.glsl"
#include "surface_io.glsl"

layout(quads, equal_spacing, ccw) in;

layout(location = 0) flat in uint inSurface[];
SURFACE_OUT(ONE_VERTEX)

void main()
{
    uint surface = inSurface[0];
    uint spansU = surfaces[surface].spansU;
    uint spansV = surfaces[surface].spansV;
    vec2 at = vec2(spanOf(surfaceSpans[2u * surface], spansU, gl_TessCoord.x),
                   spanOf(surfaceSpans[2u * surface + 1u], spansV, gl_TessCoord.y));
    uvec2 span = min(uvec2(at), uvec2(spansU, spansV) - 1u);
    uint ksquad = surfaces[surface].firstKsquad + span.x * spansV + span.y;
    vec2 t = at - vec2(span);
    SurfaceVertex vertex = vertexOf(ksquads[ksquad], t);
    outPosition = toView(surface, vertex.at.position);
    outNormal = normalToView(surface, vertex.normal);
    outT = at;  // counted in spans (FRAME_SPANS)
    outInverseWeight = inverseWeight(vertex.weight);
    outWeightedT = outInverseWeight * at;
    outKsquad = surfaces[surface].firstKsquad;
    gl_Position = toClip(outPosition);
    gl_CullDistance[0] = shownTowards(surface, outPosition, outNormal);
    captureVertex(CapturedRecord(ksquad, t, ksquad, vertex.at.position, vertex.normal, gl_Position));
}
