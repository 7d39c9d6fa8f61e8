// The records that CPU and GPU share, in scalar layout on both sides.
#ifndef KNOTSPAN_LAYOUTS_H
#define KNOTSPAN_LAYOUTS_H

#include "cull_list.h"
#include "language.h"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

#define FRAME_KNOT_LINES 1u
#define FRAME_CAPTURE 2u
#define FRAME_ORTHOGRAPHIC 4u

// What all stages know of the picture. Lengths on screen are pixels.
struct FrameRecord {
    mat4 projection;      // eye-relative view space to clip space, reversed depth
    float pixelsPerUnit;  // of a unit at distance 1 (perspective) or anywhere (orthographic)
    float diePx;          // area rule: the longest edge of a KSDie
    uint fixedDice;       // fixed rule: KSDice along each side; 0: the area rule
    uint maxDice;         // what the device can do
    uint cullBits;
    uint ksquadCount;
    uint shading;
    uint flags;
    uint patchesPerDraw;   // what one draw of the tessellation path may hold
    uint captureCapacity;  // vertices; of the compute stage: requests
};

// A surface: what does not depend on the view.
struct SurfaceRecord {
    uint degreeU;
    uint degreeV;
    uint stride;      // control points in a row of the net (countV)
    uint firstPoint;  // of the whole net
    vec3 corners[4];  // S at (u,v) = (0,0), (1,0), (0,1), (1,1) of the domain, relative to its origin
    vec3 colour;      // linear
};

// A surface as this frame's camera sees it; made in double.
struct SurfaceView {
    mat4x3 modelView;  // from the surface's own coordinates to eye-relative view space
    vec4 eye;          // in the surface's own coordinates; w = 0: the direction towards an orthographic eye
    float facing;      // -1 where the transform mirrors, else 1
    float highlight;   // 1: drawn as selected
};

// The index of a KSQuad into its surface: never a copy.
struct KsQuadRecord {
    uint surface;
    uint firstPoint;  // B_{i-p,j-q}
    uint spanU;       // where the tables of its spans start (nurbs_basis.glsl)
    uint spanV;
};

// What the stages count. Cleared before each frame. Pairs are the low and high words of a number beyond 32
// bits.
struct Counters {
    uint culled[KNOTSPAN_CULL_MODE_COUNT];
    uint drawn;
    uint captured;
    uint ksdice[2];
    uint triangles[2];
    uint evaluations[2];
};

// A vertex as a stage computed it.
struct CapturedRecord {
    uint ksquad;
    vec2 t;
    vec3 position;
    vec3 normal;
};

// What the compute stage is to evaluate, and what it gives: in float and in double.
KNOTSPAN_TEMPLATE
struct RequestRecord {
    uint ksquad;
    KNOTSPAN_VEC2 t;
};
KNOTSPAN_TEMPLATE
struct EvaluatedRecord {
    KNOTSPAN_VEC3 position;
    KNOTSPAN_VEC3 du;  // by the span's t
    KNOTSPAN_VEC3 dv;
    KNOTSPAN_VEC3 normal;  // unit
};

// VkDrawIndirectCommand.
struct DrawRecord {
    uint vertexCount;
    uint instanceCount;
    uint firstVertex;
    uint firstInstance;
};

// Push constants of the overlays.
struct OverlayConstants {
    vec4 colour;
    uint surface;
    uint countU;
    uint countV;
    uint mark;        // the control point to mark, or NO_MARK for all
    float pointSize;  // pixels
};
#define NO_MARK 0xffffffffu

#ifdef __cplusplus
static_assert(sizeof(FrameRecord) == 104 && sizeof(SurfaceRecord) == 76 && sizeof(SurfaceView) == 72);
static_assert(sizeof(KsQuadRecord) == 16 && sizeof(CapturedRecord) == 36);
static_assert(sizeof(RequestRecord<float>) == 12 && sizeof(RequestRecord<double>) == 24);
static_assert(sizeof(EvaluatedRecord<float>) == 48 && sizeof(EvaluatedRecord<double>) == 96);
static_assert(sizeof(DrawRecord) == 16 && sizeof(OverlayConstants) == 36);
}  // namespace knotspan::gpu
#endif
#endif
