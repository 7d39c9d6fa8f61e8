// The bound scene as the stages see it: buffers, and a KSQuad's points in the surface's own coordinates.
#ifndef KNOTSPAN_SCENE_GLSL
#define KNOTSPAN_SCENE_GLSL

#extension GL_EXT_scalar_block_layout : require

#include "bindings.h"
#include "layouts.h"

layout(set = 0, binding = BINDING_FRAME, scalar) readonly buffer FrameBuffer { FrameRecord frame; };
layout(set = 0, binding = BINDING_SURFACES, scalar) readonly buffer SurfaceBuffer { SurfaceRecord surfaces[]; };
layout(set = 0, binding = BINDING_SURFACE_VIEWS, scalar) readonly buffer ViewBuffer { SurfaceView surfaceViews[]; };
layout(set = 0, binding = BINDING_SHOWN_SHELLS, scalar) readonly buffer ShellBuffer { uint shownShells[]; };
layout(set = 0, binding = BINDING_KSQUADS, scalar) readonly buffer KsQuadBuffer { KsQuadRecord ksquads[]; };
layout(set = 0, binding = BINDING_SPAN_TABLES, scalar) readonly buffer TableBuffer { Real spanTables[]; };
layout(set = 0, binding = BINDING_CONTROL_POINTS, scalar) readonly buffer PointBuffer { KNOTSPAN_VEC4 controlPoints[]; };

Real spanTable(uint index) { return spanTables[index]; }
KNOTSPAN_VEC4 controlPoint(uint index) { return controlPoints[index]; }

#include "nurbs_surface.glsl"

// Buffers are read member by member where a stage needs it: a copy of a whole record is as many loads.
SurfaceSample sampleWithBasis(KsQuadRecord ksquad, Basis basisU, Basis basisV)
{
    return contractNet(ksquad.firstPoint, surfaces[ksquad.surface].stride, int(surfaces[ksquad.surface].degreeU),
                       int(surfaces[ksquad.surface].degreeV), basisU, basisV);
}

SurfaceSample sampleKsQuad(KsQuadRecord ksquad, KNOTSPAN_VEC2 t)
{
    return sampleWithBasis(ksquad, evaluateBasis(ksquad.spanU, int(surfaces[ksquad.surface].degreeU), t.x),
                           evaluateBasis(ksquad.spanV, int(surfaces[ksquad.surface].degreeV), t.y));
}

KNOTSPAN_VEC3 positionOf(KsQuadRecord ksquad, KNOTSPAN_VEC2 t)
{
    uint stride = surfaces[ksquad.surface].stride;
    int degreeU = int(surfaces[ksquad.surface].degreeU);
    int degreeV = int(surfaces[ksquad.surface].degreeV);
    BasisValues basisU = evaluateBasisValues(ksquad.spanU, degreeU, t.x);
    BasisValues basisV = evaluateBasisValues(ksquad.spanV, degreeV, t.y);
    KNOTSPAN_VEC4 sum = KNOTSPAN_VEC4(0.0);
    for (int i = 0; i <= degreeU; ++i)
        for (int j = 0; j <= degreeV; ++j)
            sum += basisU.value[i] * basisV.value[j] * controlPoint(ksquad.firstPoint + uint(i) * stride + uint(j));
    return sum.xyz / sum.w;
}

Real largest(KNOTSPAN_VEC3 v) { return max(max(abs(v.x), abs(v.y)), abs(v.z)); }

// The direction of v whatever its length: squares of very small or large numbers would leave float. Zero for zero.
KNOTSPAN_VEC3 directionOf(KNOTSPAN_VEC3 v)
{
    Real scale = largest(v);
    return scale > 0.0 ? normalize(v / scale) : KNOTSPAN_VEC3(0.0);
}

struct SurfaceVertex {
    SurfaceSample at;
    KNOTSPAN_VEC3 normal;  // unit
    Real weight;           // of the KSQuad itself at t
};

// A vertex at t of a KSQuad whose position is the point at sourceT of `source`: the KSQuad itself (`same`) or, along an
// edge, the edge's owner, whose normal and weight may be the KSQuad's own (`shares`): one evaluation for both.
//
// Where the tangents tell no normal (one is zero or all rounding error, as at a pole, or both point the same way), it
// is that of the nearest point a little further inside the KSQuad whose tangents do. One loop, so that the evaluation
// stands in a stage once: the software driver compiles it for seconds, and both sides of an edge get the same bits.
SurfaceVertex placedVertex(KsQuadRecord ksquad, KNOTSPAN_VEC2 t, KsQuadRecord source, KNOTSPAN_VEC2 sourceT, bool same,
                           bool shares)
{
    const Real kLeastSine = 32.0 * KNOTSPAN_ROUNDING;
    SurfaceVertex vertex;
    vertex.normal = KNOTSPAN_VEC3(0.0);
    Real inwards = 0.0;
    KsQuadRecord seen = source;
    KNOTSPAN_VEC2 place = sourceT;
    bool own = same;
    for (int attempt = 0; attempt < 6; ++attempt) {
        SurfaceSample at = sampleKsQuad(seen, place);
        if (attempt == 0)
            vertex.at = at;
        if (own || shares) {
            if (inwards == 0.0)
                vertex.weight = at.weight;
            KNOTSPAN_VEC3 n = cross(directionOf(at.du), directionOf(at.dv));
            Real rounding = KNOTSPAN_ROUNDING * largest(at.position);
            bool tells = min(largest(at.du), largest(at.dv)) > rounding && dot(n, n) > kLeastSine * kLeastSine;
            if (tells || (own && vertex.normal == KNOTSPAN_VEC3(0.0)))
                vertex.normal = directionOf(n);
            if (tells)
                break;
        }
        if (own) {
            inwards = max(8.0 * inwards, 0.0009765625);
            place = mix(t, KNOTSPAN_VEC2(0.5), inwards);
        } else {
            seen = ksquad;
            place = t;
            own = true;
        }
    }
    if (vertex.normal == KNOTSPAN_VEC3(0.0))
        vertex.normal = KNOTSPAN_VEC3(0.0, 0.0, 1.0);
    return vertex;
}

SurfaceVertex vertexOf(KsQuadRecord ksquad, KNOTSPAN_VEC2 t) { return placedVertex(ksquad, t, ksquad, t, true, true); }

vec3 toView(uint surface, vec3 position) { return surfaceViews[surface].modelView * vec4(position, 1.0); }

// Normals go with the cofactors of the matrix, so that shears and mirrors are right.
vec3 normalToView(uint surface, vec3 normal)
{
    mat4x3 m = surfaceViews[surface].modelView;
    mat3 cofactors = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
    return vec3(directionOf(cofactors * normal));
}

// 1: only the side that S_u x S_v points to is shown; -1: only the other one; 0: both.
float shownSide(uint surface) { return surfaceViews[surface].side * float(shownShells[surfaceViews[surface].shell]); }

// Less than 0 where a point of a surface of which one side is shown faces away: every vertex' cull distance. Triangles all of
// whose vertices do nobody can see, so that they are dropped whatever the culling mode, and no mode changes a pixel.
float shownTowards(uint surface, vec3 viewPosition, vec3 viewNormal)
{
    float side = shownSide(surface) * surfaceViews[surface].facing;
    if (side == 0.0)
        return 1.0;
    bool orthographic = (frame.flags & FRAME_ORTHOGRAPHIC) != 0u;
    return side * dot(viewNormal, orthographic ? vec3(0.0, 0.0, 1.0) : -viewPosition);
}

vec4 toClip(vec3 viewPosition) { return frame.projection * vec4(viewPosition, 1.0); }

#endif
