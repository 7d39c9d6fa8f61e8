#include "surface_io.glsl"

// A vertex of a grid as a stage draws it.
struct DrawnVertex {
    vec4 clip;
    vec3 view;
    vec3 normal;  // view space
    vec2 t;
    float inverseWeight;
    float shown;  // its cull distance
};

DrawnVertex drawnVertex(GridVertex at, uint index)
{
    KsQuadRecord ksquad = ksquads[index];
    KsQuadRecord source = ksquads[at.source];
    SurfaceVertex vertex = placedVertex(ksquad, at.t, source, at.sourceT, at.source == index, at.sharesNormal);
    DrawnVertex drawn;
    drawn.view = toView(source.surface, vertex.at.position);
    drawn.clip = toClip(drawn.view);
    drawn.normal = normalToView(ksquad.surface, vertex.normal);
    drawn.t = at.t;
    drawn.inverseWeight = inverseWeight(vertex.weight);
    drawn.shown = shownTowards(ksquad.surface, drawn.view, drawn.normal);
    captureVertex(CapturedRecord(index, at.t, at.source, vertex.at.position, vertex.normal, drawn.clip));
    return drawn;
}
