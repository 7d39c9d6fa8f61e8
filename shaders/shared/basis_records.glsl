// What the evaluators of basis functions give.
#ifndef KNOTSPAN_BASIS_RECORDS_GLSL
#define KNOTSPAN_BASIS_RECORDS_GLSL

#include "language.h"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

// Values of N_{i-p,p} .. N_{i,p}. Elements above the degree are not set.
KNOTSPAN_TEMPLATE
struct BasisValues {
    Real value[KNOTSPAN_MAX_ORDER];
};

// The same and their derivatives by t (by u: divide by the span's length).
KNOTSPAN_TEMPLATE
struct Basis {
    Real value[KNOTSPAN_MAX_ORDER];
    Real slope[KNOTSPAN_MAX_ORDER];
};

// And their second derivatives.
KNOTSPAN_TEMPLATE
struct BentBasis {
    Real value[KNOTSPAN_MAX_ORDER];
    Real slope[KNOTSPAN_MAX_ORDER];
    Real bend[KNOTSPAN_MAX_ORDER];
};

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
