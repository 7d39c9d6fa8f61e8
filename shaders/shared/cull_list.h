// The culling modes: GLSL expands the list into the chain of tests, C++ into bits, check boxes and stats
// rows.
//
// A mode is one pure function in shaders/culling/NAME.glsl and one line here:
//     MODE(bit, name, function, conservative, byDefault, colour, "a sentence for people")
// The order is the order of the tests, those in CULL_LATE behind the others: the first that says so culls. Colours, sRGB, are
// those that colour-blind eyes tell apart (Okabe and Ito); what a mode drops is outlined in its.
#ifndef KNOTSPAN_CULL_LIST_H
#define KNOTSPAN_CULL_LIST_H

#define KNOTSPAN_CULL_LIST(MODE)                                                                   \
    MODE(0, surface, culledBySurface, false, false, 0x009e73u,                                     \
         "Drops whole surfaces whose four corners face away. Fast, and wrong at times")            \
    MODE(1, lqc, culledByLqc, false, false, 0x0072b2u,                                             \
         "Light quad culling: drops KSQuads whose four corners face away. Fast, and wrong at times") \
    MODE(2, sqc, culledBySqc, true, true, 0xe69f00u,                                               \
         "Strong quad culling: drops KSQuads of closed bodies that face away, by a box each")      \
    MODE(3, frustum, culledByFrustum, true, true, 0x56b4e9u,                                       \
         "Drops KSQuads that lie outside the picture")                                             \
    MODE(4, small, culledBySmall, true, true, 0xf0e442u,                                           \
         "Drops KSQuads so small that no pixel shows them")                                        \
    MODE(5, sqc-full, culledBySqcFull, true, false, 0xd55e00u,                                     \
         "Strong quad culling with the exact test: drops almost all that face away, for more memory") \
    MODE(6, occlusion, culledByOcclusion, true, true, 0xcc79a7u,                                   \
         "Drops KSQuads that lie behind what the picture already shows")                           \
    MODE(7, evs, culledByEvs, true, false, 0xbbbbbbu,                                              \
         "Exact visible set: drops triangles that face away or lie outside, where a stage makes them") \
    MODE(8, trimmed, culledByTrimmed, true, true, 0x000000u,                                       \
         "Drops KSQuads that trim loops leave nothing of")

#define KNOTSPAN_CULL_MODE_COUNT 9
#define CULL_OCCLUSION 6
#define CULL_BY_HULL (8u | 16u)  // bits of the modes that look at where the control points are in the picture
#define CULL_BY_BOX 4u           // and of those that look at which way it faces
#define CULL_BY_RAYS 32u
#define CULL_LATE (CULL_BY_HULL | CULL_BY_RAYS)  // tested after the others, since they cost more
#define CULL_BY_DEPTH 64u
#define CULL_DICE 128u
// Of these it can be counted how often they are wrong (wrong_culls.comp): they drop by facing or place alone.
#define CULL_JUDGED (1u | 2u | CULL_BY_BOX | 8u | CULL_BY_RAYS)

#endif
