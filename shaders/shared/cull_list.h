// The culling modes: GLSL expands the list into the chain of tests, C++ into bits, check boxes and stats
// rows.
//
// A mode is one pure function in shaders/culling/NAME.glsl and one line here:
//     MODE(bit, name, GLSL function, conservative, "a sentence for people")
// The order is the order of the tests: the cheapest first, because the first that says so culls.
#ifndef KNOTSPAN_CULL_LIST_H
#define KNOTSPAN_CULL_LIST_H

#define KNOTSPAN_CULL_LIST(MODE)                                                        \
    MODE(0, surface, culledBySurface, false,                                            \
         "Drops whole surfaces whose four corners face away. Fast, and wrong at times") \
    MODE(1, lqc, culledByLqc, false,                                                    \
         "Light quad culling: drops KSQuads whose four corners face away. Fast, and wrong at times")

#define KNOTSPAN_CULL_MODE_COUNT 2

#endif
