// Whether all of a KSQuad faces away from the eye: the test of model/analysis/facing.h as the culling modes make it; the
// same text for GLSL and for C++.
//
// A ray is a coefficient of T. The KSQuad is dropped if the product of each of its rays with the eye is negative. Two forms
// of them, made by renderer/scene/facing_forms.h: a box around all, and all, rounded.
//
// Coordinates are relative to the KSQuad's own origin and in its own unit, a power of two: the eye is (e - o, unit), or
// (direction, 0). Seen from a frame whose first direction is the box's axis each ray is (1, x, y, z), in a box that
// `reach` gives. All that float may be off is on the safe side: for culled KSQuads T . E <= -FACING_MARGIN |T| |E| holds
// in exact arithmetic, for the eye and the origin that were rounded.
#ifndef KNOTSPAN_FACING_FORMS_GLSL
#define KNOTSPAN_FACING_FORMS_GLSL

#include "language.h"

#ifdef __cplusplus
#include <glm/common.hpp>
#include <glm/packing.hpp>

namespace knotspan::gpu {
using std::abs;
using glm::abs;
using glm::ldexp;
using glm::normalize;
using glm::unpackHalf2x16;
using glm::unpackSnorm2x16;
using glm::unpackSnorm4x8;
#endif

#define FACING_MARGIN 6.103515625e-5f    // 2^-14
#define FACING_ROUNDING 1.9073486328e-6f  // 2^-19: of what the test itself computes, for the eye's size
#define FACING_COORDINATE 2.384185791e-7f  // 2^-22: of the eye's and the origin's coordinates, for their size

struct FacingBox {
    vec4 axis;   // of length 1
    vec3 reach;  // of the rays across it; x < 0: nothing is known of them, and the KSQuad is never dropped
    float unit;
};

// A box in 16 bytes. Its reach is rounded up, and goes with the rounded axis.
struct FacingRecord {
    uint axis[2];   // a direction: its numbers as snorm16
    uint reach[2];  // as half floats; in the last 16 bits the exponent of the unit, 32768 more
};

KNOTSPAN_INLINE FacingBox facingBoxOf(FacingRecord record)
{
    vec2 xy = unpackSnorm2x16(record.axis[0]);
    vec2 zw = unpackSnorm2x16(record.axis[1]);
    vec2 reach = unpackHalf2x16(record.reach[0]);
    FacingBox box;
    box.axis = normalize(vec4(xy.x, xy.y, zw.x, zw.y));
    box.reach = vec3(reach.x, reach.y, unpackHalf2x16(record.reach[1] & 0xffffu).x);
    box.unit = ldexp(1.0f, int(record.reach[1] >> 16u) - 32768);
    return box;
}

// The eye in a box's frame.
struct FacingEye {
    float along;
    vec3 across;
    float slack;  // how far below zero a product must be
};

// The number of rays of a KSQuad.
KNOTSPAN_INLINE uint facingRayCount(uint degreeU, uint degreeV)
{
    return (3u * degreeU - 1u) * (3u * degreeV - 1u);
}

// Words that they take: four rays are three.
KNOTSPAN_INLINE uint facingWordCount(uint degreeU, uint degreeV)
{
    return (facingRayCount(degreeU, degreeV) + 3u) / 4u * 3u;
}

// `eye` as in SurfaceView. `origin`: the point of the KSQuad's control point (p / 2, q / 2), in the surface's coordinates.
KNOTSPAN_INLINE FacingEye facingEye(FacingBox box, vec3 origin, vec4 eye)
{
    vec3 from = vec3(eye) - eye.w * origin;
    float depth = eye.w * box.unit;
    FacingEye seen;
    seen.along = dot(box.axis, vec4(from, depth));
    // The reflection that takes the axis to the first direction, or to its opposite.
    float own = (seen.along + (box.axis.x < 0.0f ? -from.x : from.x)) / (1.0f + abs(box.axis.x));
    seen.across = vec3(from.y, from.z, depth) - own * vec3(box.axis.y, box.axis.z, box.axis.w);
    float size = abs(from.x) + abs(from.y) + abs(from.z) + depth;
    float far = abs(origin.x) + abs(origin.y) + abs(origin.z);
    float rounded = abs(eye.x) + abs(eye.y) + abs(eye.z) + eye.w * far;
    // No ray is longer than the sum; normals of what is small and far from the surface's origin are rounded, too.
    seen.slack = (1.0f + box.reach.x + box.reach.y + box.reach.z) *
                 ((FACING_MARGIN + FACING_ROUNDING + FACING_COORDINATE * far / box.unit) * size +
                  FACING_COORDINATE * rounded);
    return seen;
}

KNOTSPAN_INLINE bool boxFacesAway(FacingBox box, FacingEye eye)
{
    return box.reach.x >= 0.0f && eye.along + dot(box.reach, abs(eye.across)) + eye.slack < 0.0f;
}

// Each ray, for a KSQuad that boxFacesAway() does not tell; `words` from number `first` on, facingWordCount() of them.
KNOTSPAN_SCENE_TEMPLATE
bool raysFaceAway(KNOTSPAN_SOURCE FacingBox box, FacingEye eye, uint first, uint words)
{
    if (box.reach.x < 0.0f)
        return false;
    vec3 across = box.reach * eye.across;
    // Each number of a ray is off by half a step of 127.
    float most = -eye.along - eye.slack - 0.00394f * (abs(across.x) + abs(across.y) + abs(across.z));
    for (uint k = 0u; k < words; k += 3u) {
        vec4 a = unpackSnorm4x8(KNOTSPAN_FACING_WORD(first + k));
        vec4 b = unpackSnorm4x8(KNOTSPAN_FACING_WORD(first + k + 1u));
        vec4 c = unpackSnorm4x8(KNOTSPAN_FACING_WORD(first + k + 2u));
        float largest = max(max(dot(across, vec3(a.x, a.y, a.z)), dot(across, vec3(a.w, b.x, b.y))),
                            max(dot(across, vec3(b.z, b.w, c.x)), dot(across, vec3(c.y, c.z, c.w))));
        if (!(largest < most))
            return false;
    }
    return true;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
