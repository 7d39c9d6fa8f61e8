// B-spline basis functions on one span: the same text for every shader stage and, as a template, for C++.
//
// A span [U_i, U_{i+1}) of degree p is 2p numbers, made in double and normalised to the span's length h:
//     L_j = (U_i - U_{i+1-j}) / h   at index j - 1          j = 1 .. p
//     R_j = (U_{i+j} - U_{i+1}) / h at index p + j - 1      j = 1 .. p
// and t = (u - U_i) / h in [0, 1]. So nothing here sees where the knots lie or how long the span is, and float
// keeps its digits. The NURBS Book, A2.2, with left_j = t + L_j, right_j = (1 - t) + R_j.
#ifndef KNOTSPAN_NURBS_BASIS_GLSL
#define KNOTSPAN_NURBS_BASIS_GLSL

#include "language.h"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

KNOTSPAN_TEMPLATE
struct BasisValues {
    Real value[KNOTSPAN_MAX_ORDER];
};

// Values of N_{i-d,d} .. N_{i,d} for d = `raised`, which is at most the span's `degree`. Elements above d are not set.
KNOTSPAN_SOURCE_TEMPLATE
BasisValues KNOTSPAN_OF_REAL evaluateBasisValues(KNOTSPAN_SOURCE uint span, int degree, int raised, Real t)
{
    BasisValues KNOTSPAN_OF_REAL basis;
    basis.value[0] = Real(1);
    for (int d = 1; d <= raised; ++d) {
        Real carried = Real(0);
        for (int r = 0; r < d; ++r) {
            Real leftKnot = spanKnot(span + uint(d - r - 1));
            Real rightKnot = spanKnot(span + uint(degree + r));
            Real share = basis.value[r] / (Real(1) + leftKnot + rightKnot);
            basis.value[r] = carried + (rightKnot + (Real(1) - t)) * share;
            carried = (t + leftKnot) * share;
        }
        basis.value[d] = carried;
    }
    return basis;
}

// Values of N_{i-p,p} .. N_{i,p} and their derivatives by t (by u: divide by h). Elements above the degree are not set.
KNOTSPAN_TEMPLATE
struct Basis {
    Real value[KNOTSPAN_MAX_ORDER];
    Real slope[KNOTSPAN_MAX_ORDER];
};

// The last step of the recursion gives both: N' = p (N_{r-1,p-1} / (..) - N_{r,p-1} / (..)), The NURBS Book, eq. 2.7.
KNOTSPAN_SOURCE_TEMPLATE
Basis KNOTSPAN_OF_REAL evaluateBasis(KNOTSPAN_SOURCE uint span, int degree, Real t)
{
    BasisValues KNOTSPAN_OF_REAL lower = evaluateBasisValues(KNOTSPAN_PASS_SOURCE span, degree, degree - 1, t);
    Basis KNOTSPAN_OF_REAL basis;
    Real carried = Real(0);
    Real previousShare = Real(0);
    for (int r = 0; r < degree; ++r) {
        Real leftKnot = spanKnot(span + uint(degree - r - 1));
        Real rightKnot = spanKnot(span + uint(degree + r));
        Real share = lower.value[r] / (Real(1) + leftKnot + rightKnot);
        basis.value[r] = carried + (rightKnot + (Real(1) - t)) * share;
        basis.slope[r] = Real(degree) * (previousShare - share);
        carried = (t + leftKnot) * share;
        previousShare = share;
    }
    basis.value[degree] = carried;
    basis.slope[degree] = Real(degree) * previousShare;
    return basis;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
