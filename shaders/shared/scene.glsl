// The bound scene as the stages see it: buffers, and a KSQuad's points in the surface's own coordinates.
#ifndef KNOTSPAN_SCENE_GLSL
#define KNOTSPAN_SCENE_GLSL

#extension GL_EXT_scalar_block_layout : require

#include "bindings.h"
#include "layouts.h"

layout(set = 0, binding = BINDING_FRAME, scalar) readonly buffer FrameBuffer { FrameRecord frame; };
layout(set = 0, binding = BINDING_SURFACES, scalar) readonly buffer SurfaceBuffer { SurfaceRecord surfaces[]; };
layout(set = 0, binding = BINDING_SURFACE_VIEWS, scalar) readonly buffer ViewBuffer { SurfaceView surfaceViews[]; };
layout(set = 0, binding = BINDING_KSQUADS, scalar) readonly buffer KsQuadBuffer { KsQuadRecord ksquads[]; };
layout(set = 0, binding = BINDING_SPAN_KNOTS, scalar) readonly buffer KnotBuffer { float spanKnots[]; };
layout(set = 0, binding = BINDING_CONTROL_POINTS, scalar) readonly buffer PointBuffer { vec4 controlPoints[]; };

float spanKnot(uint index) { return spanKnots[index]; }
vec4 controlPoint(uint index) { return controlPoints[index]; }

#include "nurbs_surface.glsl"

// Buffers are read member by member where a stage needs it: a copy of a whole record is as many loads.
SurfaceSample sampleWithBasis(KsQuadRecord ksquad, Basis basisU, Basis basisV)
{
    return contractNet(ksquad.firstPoint, surfaces[ksquad.surface].stride, int(surfaces[ksquad.surface].degreeU),
                       int(surfaces[ksquad.surface].degreeV), basisU, basisV);
}

SurfaceSample sampleKsQuad(KsQuadRecord ksquad, vec2 t)
{
    return sampleWithBasis(ksquad, evaluateBasis(ksquad.spanU, int(surfaces[ksquad.surface].degreeU), t.x),
                           evaluateBasis(ksquad.spanV, int(surfaces[ksquad.surface].degreeV), t.y));
}

vec3 positionOf(KsQuadRecord ksquad, vec2 t)
{
    uint stride = surfaces[ksquad.surface].stride;
    int degreeU = int(surfaces[ksquad.surface].degreeU);
    int degreeV = int(surfaces[ksquad.surface].degreeV);
    BasisValues basisU = evaluateBasisValues(ksquad.spanU, degreeU, degreeU, t.x);
    BasisValues basisV = evaluateBasisValues(ksquad.spanV, degreeV, degreeV, t.y);
    vec4 sum = vec4(0.0);
    for (int i = 0; i <= degreeU; ++i)
        for (int j = 0; j <= degreeV; ++j)
            sum += basisU.value[i] * basisV.value[j] * controlPoint(ksquad.firstPoint + uint(i) * stride + uint(j));
    return sum.xyz / sum.w;
}

// A vertex: position and unit normal. Where the tangents say nothing, the normal is that of a point a little further
// inside the KSQuad. One loop, so that the evaluation stands in a stage once: drivers compile it for long.
struct SurfaceVertex {
    vec3 position;
    vec3 normal;
};

vec3 unitNormal(vec3 du, vec3 dv)
{
    vec3 n = cross(du, dv);
    float squared = dot(n, n);
    // Tangents of extreme length over- or underflow in the product: scale them first.
    if (!(squared > 1e-30 && squared < 1e30))
        n = cross(du / max(length(du), 1e-37), dv / max(length(dv), 1e-37));
    float len = length(n);
    return len > 0.0 ? n / len : vec3(0.0, 0.0, 1.0);
}

SurfaceVertex vertexOf(KsQuadRecord ksquad, vec2 t)
{
    SurfaceVertex vertex;
    float inwards = 0.0;
    for (int attempt = 0; attempt < 5; ++attempt) {
        SurfaceSample at = sampleKsQuad(ksquad, mix(t, vec2(0.5), inwards));
        if (attempt == 0)
            vertex.position = at.position;
        vertex.normal = unitNormal(at.du, at.dv);
        if (!isDegenerate(at.du, at.dv))
            break;
        inwards = max(8.0 * inwards, 0.0009765625);
    }
    return vertex;
}

vec3 toView(uint surface, vec3 position) { return surfaceViews[surface].modelView * vec4(position, 1.0); }

// Normals go with the cofactors of the matrix, so that shears and mirrors are right.
vec3 normalToView(uint surface, vec3 normal)
{
    mat4x3 m = surfaceViews[surface].modelView;
    mat3 cofactors = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
    vec3 n = cofactors * normal;
    return n / max(length(n), 1e-37);
}

vec4 toClip(vec3 viewPosition) { return frame.projection * vec4(viewPosition, 1.0); }

#endif
