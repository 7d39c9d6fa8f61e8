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
#define BINDING_CULL_GROUPS 7  // for each group of KSQuads: two words of visible bits, where its part starts
#define BINDING_DRAWS 8        // indirect draw commands
#define BINDING_COUNTERS 9
#define BINDING_CAPTURED 10    // vertices, or what the compute stage evaluated
#define BINDING_REQUESTS 11
#define BINDING_COUNT 12

// Specialization constants.
#define KNOTSPAN_LINES_CONSTANT 0      // of the overlays: lines, not points
#define KNOTSPAN_EVALUATOR_CONSTANT 1  // of what evaluates: the number in evaluator_list.h

// Work group sizes.
#define TASK_KSQUADS 32   // KSQuads a task group looks at: one bit each in a word (MESH)
#define MESH_THREADS 128  // (MESH)
#define CULL_KSQUADS 64   // KSQuads a group of cull.comp looks at: two words
#define SCAN_THREADS 128
#define EVALUATE_THREADS 64

#endif
