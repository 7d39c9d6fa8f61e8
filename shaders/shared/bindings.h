// Where each buffer is bound: one descriptor set for all pipelines.
#ifndef KNOTSPAN_BINDINGS_H
#define KNOTSPAN_BINDINGS_H

#define BINDING_FRAME 0
#define BINDING_SURFACES 1
#define BINDING_SURFACE_VIEWS 2
#define BINDING_KSQUADS 3
#define BINDING_SPAN_TABLES 4
#define BINDING_CONTROL_POINTS 5
#define BINDING_VISIBLE 6      // indices of the KSQuads to draw, in order
#define BINDING_CULL_GROUPS 7  // for each group of KSQuads: which are visible and which ask, where their parts start
#define BINDING_DRAWS 8        // indirect draw commands
#define BINDING_COUNTERS 9
#define BINDING_CAPTURED 10    // vertices, or what the compute stage evaluated
#define BINDING_REQUESTS 11
#define BINDING_BORDER_SIDES 12    // who else lies along the KSQuad sides that are their surface's border
#define BINDING_BORDER_CORNERS 13  // where the vertices at the ends of those sides come from
#define BINDING_BORDER_PIECES 14   // of sides that several others lie along
#define BINDING_BORDER_USES 15     // who lies along those
#define BINDING_ASKING 16          // indices of the KSQuads that choose a grid: the visible ones and their neighbours
#define BINDING_GRIDS 17           // for each KSQuad, how finely this frame asks it to be drawn
#define BINDING_TILES 18           // the parts of KSQuads' grids that this frame draws, in order
#define BINDING_TILE_COUNTS 19     // tiles of each visible KSQuad
#define BINDING_TILE_GROUPS 20     // for each group of visible KSQuads: their tiles, where its part of the list starts
#define BINDING_MESH_GROUPS 21     // for each group of tiles: vertices and cells, and where its parts start
#define BINDING_MESH_STARTS 22     // for each tile: where its vertices and its cells end
#define BINDING_VERTICES 23        // of the path compute
#define BINDING_INDICES 24
#define BINDING_ADAPTIVE_BLOCKS 25 // for each KSQuad, which of its 4 x 4 blocks need all cells (path tessellation-adaptive)
#define BINDING_SURFACE_SPANS 26   // where the spans of whole surfaces lie (path surface)
#define BINDING_REST_POINTS 27  // control points before a wave moved them
#define BINDING_WAVES 28      // how the wave moves each surface's
#define BINDING_FACING 29     // for each KSQuad, which eyes it faces away from (culling mode sqc)
#define BINDING_FACING_RAYS 30  // the same more closely
#define BINDING_CANDIDATES 31   // bits of the KSQuads that only occlusion can still drop
#define BINDING_SEEN 32         // bits of those that were not occluded in the last frame
#define BINDING_SEEN_NOW 33     // and in this one
#define BINDING_DEPTHS 34       // the depth pyramid
#define BINDING_SHOWN_SHELLS 35  // for each shell, whether only the outside of its surfaces is shown
#define BINDING_VERDICTS 36      // for each KSQuad, what a culling camera that stands still said of it
#define BINDING_LISTS 37         // how many groups work on the lists of visible and of asking KSQuads
#define BINDING_EDGE_LINES 38        // parts of KSQuad sides that are drawn as lines
#define BINDING_MARKS 39             // control points to mark
#define BINDING_STROKES 40           // straight lines in the picture
#define BINDING_MESH_VERTICES 41     // of the reference meshes
#define BINDING_MESH_TRIANGLES 42
#define BINDING_SPAN_PLACES 43       // where spans of surfaces lie along their parameters, or along their iso-curves
#define BINDING_SPACE_LINES 44       // straight lines in the model
#define BINDING_DEVIATIONS 45        // for each KSQuad, a grid of its distances from a reference
#define BINDING_TRIM_WORDS 46        // what trim loops leave of each KSQuad (trimming.glsl)
#define BINDING_DRAWN 47             // of each pixel what was drawn so far (drawn_pixels.glsl)
#define BINDING_COUNT 48

// Specialization constants.
#define KNOTSPAN_LINES_CONSTANT 0      // of the overlays: lines, not points
#define KNOTSPAN_EVALUATOR_CONSTANT 1  // of what evaluates: the number in evaluator_list.h
#define KNOTSPAN_CAPTURE_CONSTANT 2    // of what makes vertices: whether it notes them down

// Work group sizes.
#define TASK_KSQUADS 32   // KSQuads a task group looks at: one bit each in a word (MESH)
#define MESH_THREADS 128  // (MESH)
#define CULL_KSQUADS 64   // KSQuads a group of cull.comp looks at: two words
#define SCAN_THREADS 128
#define PYRAMID_TEXELS 64
#define OUTLINE_SEGMENTS 8u  // lines along each side of a rejected KSQuad
#define EDGE_LINE_SEGMENTS 32  // pieces of a line along a KSQuad side
#define LIST_KSQUADS 64   // KSQuads of a list that a group of sampling.comp or tile_count.comp looks at
#define GEOMETRY_SIDE 5   // cells along a side of a tile of the path geometry
#define GEOMETRY_VERTICES (2 * GEOMETRY_SIDE * (GEOMETRY_SIDE + 1))
#define ADAPTIVE_VERTICES 24  // of a base cell of the path tessellation-adaptive: 8 triangles
#define MESH_TILES 64    // tiles a group of compute_count.comp looks at
#define MESH_ITEMS 64    // vertices or cells a group of the path compute makes
#define TASK_TILES 32     // tiles a task group of the path mesh packs into mesh groups
#define TILE_PAYLOAD_WORDS ((TASK_TILES + 4) / 4)  // a byte for each start of a mesh group, and the end
#define TILE_THREADS 32   // threads of its mesh groups
#define EVALUATE_THREADS 64
#define WAVE_POINTS 64    // control points a group of wave.comp moves

#endif
