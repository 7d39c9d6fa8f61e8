// The evaluator `triangular`: Cox and de Boor's recursion without recursion. The NURBS Book, A2.2, with
// left_j = t + L_j, right_j = (1 - t) + R_j.
//
// Its table is 2p numbers, differences of knots normalised to the span's length h:
//     L_j = (U_i - U_{i+1-j}) / h   at index j - 1          j = 1 .. p
//     R_j = (U_{i+j} - U_{i+1}) / h at index p + j - 1      j = 1 .. p
#ifndef KNOTSPAN_TRIANGULAR_BASIS_GLSL
#define KNOTSPAN_TRIANGULAR_BASIS_GLSL

#include "basis_records.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

// Values of N_{i-d,d} .. N_{i,d} for d = `raised`, which is at most the span's `degree`.
KNOTSPAN_SOURCE_TEMPLATE
BasisValues KNOTSPAN_OF_REAL triangularRaised(KNOTSPAN_SOURCE uint table, int degree, int raised, Real t)
{
    BasisValues KNOTSPAN_OF_REAL basis;
    basis.value[0] = Real(1);
    for (int d = 1; d <= raised; ++d) {
        Real carried = Real(0);
        for (int r = 0; r < d; ++r) {
            Real leftKnot = KNOTSPAN_TABLE(table + uint(d - r - 1));
            Real rightKnot = KNOTSPAN_TABLE(table + uint(degree + r));
            Real share = basis.value[r] / (Real(1) + leftKnot + rightKnot);
            basis.value[r] = carried + (rightKnot + (Real(1) - t)) * share;
            carried = (t + leftKnot) * share;
        }
        basis.value[d] = carried;
    }
    return basis;
}

KNOTSPAN_SOURCE_TEMPLATE
BasisValues KNOTSPAN_OF_REAL triangularValues(KNOTSPAN_SOURCE uint table, int degree, Real t)
{
    return triangularRaised KNOTSPAN_OF_REAL(KNOTSPAN_PASS_SOURCE table, degree, degree, t);
}

// The last step of the recursion gives both: N' = p (N_{r-1,p-1} / (..) - N_{r,p-1} / (..)), The NURBS Book, eq. 2.7.
KNOTSPAN_SOURCE_TEMPLATE
Basis KNOTSPAN_OF_REAL triangularBasis(KNOTSPAN_SOURCE uint table, int degree, Real t)
{
    BasisValues KNOTSPAN_OF_REAL lower =
        triangularRaised KNOTSPAN_OF_REAL(KNOTSPAN_PASS_SOURCE table, degree, degree - 1, t);
    Basis KNOTSPAN_OF_REAL basis;
    Real carried = Real(0);
    Real previousShare = Real(0);
    for (int r = 0; r < degree; ++r) {
        Real leftKnot = KNOTSPAN_TABLE(table + uint(degree - r - 1));
        Real rightKnot = KNOTSPAN_TABLE(table + uint(degree + r));
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

// The last two steps give second derivatives, too: those of degree p are differences of shares of the first ones of
// degree p - 1.
KNOTSPAN_SOURCE_TEMPLATE
BentBasis KNOTSPAN_OF_REAL triangularBent(KNOTSPAN_SOURCE uint table, int degree, Real t)
{
    BasisValues KNOTSPAN_OF_REAL lowest =
        triangularRaised KNOTSPAN_OF_REAL(KNOTSPAN_PASS_SOURCE table, degree, degree - 2, t);
    Basis KNOTSPAN_OF_REAL lower;
    int below = degree - 1;
    Real carried = Real(0);
    Real previousShare = Real(0);
    for (int r = 0; r < below; ++r) {
        Real leftKnot = KNOTSPAN_TABLE(table + uint(below - r - 1));
        Real rightKnot = KNOTSPAN_TABLE(table + uint(degree + r));
        Real share = lowest.value[r] / (Real(1) + leftKnot + rightKnot);
        lower.value[r] = carried + (rightKnot + (Real(1) - t)) * share;
        lower.slope[r] = Real(below) * (previousShare - share);
        carried = (t + leftKnot) * share;
        previousShare = share;
    }
    lower.value[below] = below > 0 ? carried : Real(1);
    lower.slope[below] = Real(below) * previousShare;
    BentBasis KNOTSPAN_OF_REAL basis;
    carried = Real(0);
    previousShare = Real(0);
    Real previousSlope = Real(0);
    for (int r = 0; r < degree; ++r) {
        Real leftKnot = KNOTSPAN_TABLE(table + uint(degree - r - 1));
        Real rightKnot = KNOTSPAN_TABLE(table + uint(degree + r));
        Real share = lower.value[r] / (Real(1) + leftKnot + rightKnot);
        Real shareSlope = lower.slope[r] / (Real(1) + leftKnot + rightKnot);
        basis.value[r] = carried + (rightKnot + (Real(1) - t)) * share;
        basis.slope[r] = Real(degree) * (previousShare - share);
        basis.bend[r] = Real(degree) * (previousSlope - shareSlope);
        carried = (t + leftKnot) * share;
        previousShare = share;
        previousSlope = shareSlope;
    }
    basis.value[degree] = carried;
    basis.slope[degree] = Real(degree) * previousShare;
    basis.bend[degree] = Real(degree) * previousSlope;
    return basis;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
