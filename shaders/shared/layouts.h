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
#define FRAME_SPANS 16u         // t of a pixel counts the spans of its whole surface
#define FRAME_OVERSAMPLE_STRANGERS 32u  // borders without a friend get twice as many cells (BORDER_FRIEND)
#define FRAME_OVERSAMPLE_FRIENDS 64u    // and so do the others
#define FRAME_EVEN_TILES 128u        // tiles start at even cells
#define FRAME_WHOLE_TILES 256u       // a grid that fits is one tile, its ring included
#define FRAME_NOTE_VERDICTS 512u      // culling notes what it says of each KSQuad (verdicts.glsl)
#define FRAME_KEEP_VERDICTS 1024u     // and reads what it noted
#define FRAME_TRIMMED 2048u           // some surface is, and there are words of trimming
#define FRAME_MEASURE_ERROR 8u  // the fragment stage measures each pixel's distance from the surface

// How much of a measured error may be the rasterizer's: it rounds vertices to 1/256 pixel.
#define KNOTSPAN_ERROR_NOISE_PX 0.02f

// Sampling rules: how many cells a KSQuad asks for.
#define RULE_BOUND 0u
#define RULE_AREA 1u
#define RULE_EDGE 2u
#define RULE_FIXED 3u

// Shadings, as `Shading` of renderer/scene/render_lists.h counts them.
#define SHADING_SHADED 0u
#define SHADING_NORMALS 1u
#define SHADING_KSQUADS 2u
#define SHADING_ERROR 3u
#define SHADING_ZEBRA 4u
#define SHADING_REFLECTION 5u
#define SHADING_ISOPHOTES 6u
#define SHADING_MATCAP 7u
#define SHADING_CURVATURE 8u
#define SHADING_DRAFT 9u
#define SHADING_CHECKER 10u
#define SHADING_DEVIATION 11u

// Kinds of a shading: of a matcap, of curvature.
#define LOOK_CLAY 0u
#define LOOK_CHROME 1u
#define LOOK_PEARL 2u
#define LOOK_MEAN 0u
#define LOOK_GAUSS 1u
#define LOOK_LARGEST 2u
#define LOOK_SMALLEST 3u

// What all stages know of the picture. Lengths on screen are pixels.
struct FrameRecord {
    mat4 projection;      // eye-relative view space to clip space, reversed depth
    float pixelsPerUnit;  // of a unit at distance 1 (perspective) or anywhere (orthographic)
    vec2 pixels;          // width and height of the picture
    float tolerancePx;
    uint samplingRule;    // RULE_...
    float diePx;          // area and edge rules: the longest edge of a KSDie
    uint fixedDice;       // fixed rule: KSDice along each side
    uint snap;            // how the path takes border vertices to edges (borders.glsl)
    uint tileSide;        // the most cells of a tile along one side
    uint tileVertices;    // and the most vertices
    uint tileTriangles;   // and triangles
    uint ringTriangles;   // the most triangles of a part of a ring (ring.glsl), at most 255
    uint tileCapacity;    // what the list of tiles holds
    uint tilesPerDraw;    // what one draw may hold, where tiles are drawn as vertices
    uint vertexCapacity;  // what the buffers of the path compute hold
    uint triangleCapacity;
    uint taskTiles;       // tiles a task group takes, where a task stage draws them; else 0
    uint cullBits;
    uint judgedBits;  // of the modes whose wrong decisions are counted
    uint ksquadCount;
    uint surfaceCount;
    uint pointCount;  // control points of all surfaces
    uint shading;
    uint flags;
    uint isoCurves;        // parts that lines on surfaces cut a KSQuad into, each way; below 2: none
    uint captureCapacity;  // vertices; of the compute stage: requests
    uint lookKind;         // LOOK_...
    float lookCount;       // stripes from one end of the axis to the other; squares along a unit of a place
    vec3 lookAxis;         // unit, view space: of stripes; in which a mould is pulled
    vec2 lookRange;        // numbers at the ends of the ramp
    float handPx;          // pixels in one of the hand's: in those, widths of lines and points are said
};

// A surface: what does not depend on the view.
struct SurfaceRecord {
    uint degreeU;
    uint degreeV;
    uint stride;      // control points in a row of the net (countV)
    uint firstPoint;  // of the whole net
    vec3 corners[4];  // S at (u,v) = (0,0), (1,0), (0,1), (1,1) of the domain, relative to its origin
    vec3 colour;      // linear
    uint firstKsquad;  // KSQuad (a, b), a < spansU, b < spansV, is number firstKsquad + a spansV + b
    uint spansU;
    uint spansV;
    uint firstBorder;  // of its 2 (spansU + spansV) border sides, and of as many border corners (borders.glsl)
    uint firstFacingWord;  // of its KSQuads' rays (facing_forms.glsl)
};

// The sides of a KSQuad, and its corners by bits: 1 for u = 1, 2 for v = 1. A side or a corner of KSQuad k is named
// by 4 k + its number.
#define SIDE_START_U 0u  // u = 0, along v
#define SIDE_END_U 1u    // u = 1, along v
#define SIDE_START_V 2u  // v = 0, along u
#define SIDE_END_V 3u    // v = 1, along u

// A KSQuad side that is its surface's border. Sides inside a surface need no record: their neighbour is the next
// KSQuad, and the one before owns the edge.
struct BorderSide {
    uint other;  // BORDER_WHOLE: the side along the whole of which it lies; BORDER_PIECES: the first piece
    uint flags;
};
#define BORDER_OPEN 0u       // nobody else lies along it
#define BORDER_WHOLE 1u      // one other side does, from end to end
#define BORDER_PIECES 2u     // it is divided; how many pieces: flags >> BORDER_COUNT_SHIFT
#define BORDER_COLLAPSED 3u  // all its points are one, that of its corners (a pole)
#define BORDER_KIND 3u       // the bits of those
#define BORDER_REVERSED 4u   // BORDER_WHOLE: the other one runs the other way
#define BORDER_OWNER 8u      // BORDER_WHOLE: the edge's vertices are this side's
#define BORDER_FRIEND 16u    // all that lies along the edge meets smoothly there; the same for all its sides
#define BORDER_COUNT_SHIFT 8u

// A piece of a divided side, in the order of the side's t.
struct BorderPiece {
    float start;  // the side's t
    float end;
    uint owner;  // the side whose points are its vertices
    float ownerStart;  // that one's t at start and end
    float ownerEnd;
    uint corner;  // the corner that is the vertex at start; NO_CORNER: the side's own at that t
    uint firstUse;
    uint useCount;
};
#define NO_CORNER 0xffffffffu

// A side that lies along a piece, the piece's own side included: every side of an edge reads the same uses.
struct BorderUse {
    uint side;
    float share;  // how much of that side the piece is, 0 .. 1
};

// How many cells a KSQuad asks for along each of its sides, before its neighbours are heard. 0: it is not drawn.
struct GridRecord {
    uint alongV;  // sides START_U (low 16 bits) and END_U
    uint alongU;  // sides START_V (low 16 bits) and END_V
};

// A part of a KSQuad's drawn grid: a rectangle of cells, a part of the ring around them, or all (tiles.glsl).
struct TileRecord {
    uint ksquad;
    uint first;  // cell: i (low 16 bits) and j. TILE_RING: the first vertex of the outer chain
    uint cells;  // along u (low 16 bits) and v. TILE_RING: steps of the outer chain (8 bits), of the inner one (8 bits),
                 // and its first vertex
    uint grid;   // cells of the whole grid, along u (low 15 bits) and v (from bit 16 on); with TILE_RING or TILE_WHOLE
    uint edges[2];  // cells of the edges at START_U (low 16 bits) and END_U, at START_V and END_V; with TILE_DIVIDED
};
#define TILE_RING 0x8000u
#define TILE_WHOLE 0x80000000u
#define TILE_DIVIDED 0x8000u  // the edge's vertices are not evenly spaced (borders.glsl)

// A surface as this frame's camera sees it; made in double.
struct SurfaceView {
    mat4x3 modelView;  // from the surface's own coordinates to eye-relative view space
    vec4 eye;          // in the surface's own coordinates; w = 0: the direction towards an orthographic eye
    float facing;      // -1 where the transform mirrors, else 1
    float side;        // 1: S_u x S_v points out of the body; -1: into it; 0: there is none
    uint shell;        // the body: the number of its first surface
    float highlight;   // 1: drawn as selected; 0.5: as what a click would take
};

// A group of CULL_KSQUADS KSQuads. Bits by KSQuad; counts of visible and of asking ones before the group.
struct CullGroup {
    uint visible[2];
    uint asking[2];
    uint asked[2];  // in the frame's first half
    uvec2 start;
};

// For indirect dispatches: groups of LIST_KSQUADS.
struct ListGroups {
    uvec3 visible;
    uvec3 asking;
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
    // Of the half of the frame that is drawn now; culling by occlusion draws in two.
    uint visible;   // KSQuads in the VisibleList
    uint asking;    // KSQuads that choose a grid
    uint pyramidLevel;  // of the depth pyramid, that is made now
    uint captured;
    uint tiles;         // wanted
    uint meshVertices;  // wanted by the path compute
    uint meshTriangles;
    // The most that a half wanted: beyond frame.tileCapacity and the like the frame is drawn again with more room.
    uint mostTiles;
    uint mostVertices;
    uint mostTriangles;
    uint meshGroups;  // of the path mesh
    uint errorBound;  // float bits: the largest bound of a KSQuad's grid, pixels
    uint errorMax;    // float bits: the largest error measured, pixels
    uint errorPixels;  // how many pixels were measured
    uint errorLost;    // of those, how many float tells too little of
    uint errorSum[2];  // in 1/4096 pixel
    uint laneSlots[2];  // threads of the path mesh times their rounds over vertices
    uint ksdice[2];
    uint triangles[2];
    uint evaluations[2];
    uint samplesSaved[2];  // along borders that have a friend, and so are not oversampled
    uint normalsShared[2];  // of edges' points, with the owner's position (sharedNormals)
    uint trianglesCulled[2];  // of `triangles`, by evs
    uint wronglyCulled[KNOTSPAN_CULL_MODE_COUNT];  // of culled: what shows (wrong_culls.comp)
};

// A vertex as a stage computed it.
struct CapturedRecord {
    uint ksquad;
    vec2 t;
    uint source;    // the KSQuad that its position comes from
    vec3 position;  // in the coordinates of the source's surface
    vec3 normal;
    vec4 clip;  // where it is drawn
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

// How a wave moves a surface's control points (model/scene/deformation.h).
struct WaveRecord {
    vec3 phase;  // per unit of the surface's own coordinates
    float phaseAtOrigin;
    vec3 move;  // in those coordinates, by the whole amplitude
    float time;
};

// VkDrawIndexedIndirectCommand.
struct IndexedDrawRecord {
    uint indexCount;
    uint instanceCount;
    uint firstIndex;
    int vertexOffset;
    uint firstInstance;
};

// A vertex as the path compute makes it.
struct VertexRecord {
    vec4 clip;
    vec3 view;
    vec3 normal;
    vec2 t;
    uint ksquad;
    float inverseWeight;  // of the KSQuad at t
};

// A vertex as the path cpu makes it: whatever the view.
struct ObjectVertex {
    vec3 position;  // in the coordinates of the source's surface
    vec3 normal;    // in those of the KSQuad's
    vec2 t;
    uint ksquad;
    uint source;
    float weight;  // of the KSQuad at t
};

// A straight part of a KSQuad's (t_u, t_v) that is drawn as a line on the surface.
struct EdgeLineRecord {
    uint ksquad;
    vec2 from;
    vec2 to;
    uint colour;      // 0xRRGGBB
    float halfWidth;  // pixels
};

// Push constants of the overlays.
struct OverlayConstants {
    vec4 colour;
    uint surface;
    uint countU;
    uint countV;
    float pointSize;  // of the hand's pixels
};

// Push constants of the reference meshes.
struct MeshConstants {
    mat4x3 modelView;  // from the mesh's own origin to eye-relative view space
    vec3 colour;       // linear
    float highlight;   // 0 to 1
};

// A control point to mark.
struct MarkRecord {
    uint surface;
    uint point;   // in its net
    uint colour;  // 0xRRGGBB
    float size;   // pixels
};

// A straight line in the picture.
struct StrokeRecord {
    vec2 corners[4];  // pixels, around it; convex
    uint colour;      // 0xRRGGBB, opacity in the upper byte
};

// A straight line in the model, from the overlay's own origin on.
struct SpaceLineRecord {
    vec3 from;
    vec3 to;
    uint colour;      // 0xRRGGBB
    float halfWidth;  // pixels
};

// Push constants of those.
struct SpaceLineConstants {
    mat4x3 modelView;  // from that origin to eye-relative view space
};

#ifdef __cplusplus
static_assert(sizeof(FrameRecord) == 200 && sizeof(SurfaceRecord) == 96 && sizeof(SurfaceView) == 80);
static_assert(sizeof(BorderSide) == 8 && sizeof(BorderPiece) == 32 && sizeof(BorderUse) == 8);
static_assert(sizeof(GridRecord) == 8 && sizeof(TileRecord) == 24);
static_assert(sizeof(KsQuadRecord) == 16 && sizeof(CapturedRecord) == 56);
static_assert(sizeof(RequestRecord<float>) == 12 && sizeof(RequestRecord<double>) == 24);
static_assert(sizeof(EvaluatedRecord<float>) == 48 && sizeof(EvaluatedRecord<double>) == 96);
static_assert(sizeof(WaveRecord) == 32 && sizeof(EdgeLineRecord) == 28);
static_assert(sizeof(IndexedDrawRecord) == 20 && sizeof(VertexRecord) == 56 && sizeof(ObjectVertex) == 44);
static_assert(sizeof(DrawRecord) == 16 && sizeof(OverlayConstants) == 32);
static_assert(sizeof(MeshConstants) == 64);
static_assert(sizeof(MarkRecord) == 16 && sizeof(StrokeRecord) == 36);
static_assert(sizeof(SpaceLineRecord) == 32 && sizeof(SpaceLineConstants) == 48);
}  // namespace knotspan::gpu
#endif
#endif
