// The evaluator `stair`: Concheiro, Amor, Padron, Doggett, CAD 56 (2014), section 3, in the form that is exact at every
// degree (the closed expression printed there is not, from degree 4 on).
//
// Stair k is the functions N_{i-k,d} over the degrees d = k .. p. It starts at its diagonal
//     N_{i-k,k} = N_{i-k+1,k-1} (1 - t) / D(k,1)
// and climbs from its own step below and the stair before it:
//     N_{i-k,d} = (t + L_{k+1}) / D(k+1,d-k) N_{i-k,d-1} + (1 - t + R_{d-k+1}) / D(k,d-k+1) N_{i-k+1,d-1}
// with L and R of triangular_basis.glsl and D(a,b) = 1 + L_a + R_b. The denominators are constants of the span, so the
// table is those 2p differences and then the reciprocals 1 / D(a,b) for a + b <= p + 1, row by row of a: nothing here
// divides.
#ifndef KNOTSPAN_STAIR_BASIS_GLSL
#define KNOTSPAN_STAIR_BASIS_GLSL

#include "basis_records.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

KNOTSPAN_SOURCE_TEMPLATE
Basis KNOTSPAN_OF_REAL stairBasis(KNOTSPAN_SOURCE uint table, int degree, Real t)
{
    Basis KNOTSPAN_OF_REAL basis;
    uint row = table + uint(2 * degree);  // of a = k; for the first stair that of a = 1
    Real step[KNOTSPAN_MAX_ORDER];
    step[0] = Real(1);
    for (int d = 1; d <= degree; ++d)
        step[d] = step[d - 1] * (t * KNOTSPAN_TABLE(row + uint(d - 1)));
    Real share = Real(degree) * step[degree - 1] * KNOTSPAN_TABLE(row + uint(degree - 1));
    basis.value[degree] = step[degree];
    basis.slope[degree] = share;
    Real diagonal = Real(1);
    for (int k = 1; k <= degree; ++k) {
        uint nextRow = row + uint(degree + 1 - k);
        Real leftKnot = k < degree ? KNOTSPAN_TABLE(table + uint(k)) : Real(0);
        diagonal = diagonal * ((Real(1) - t) * KNOTSPAN_TABLE(row));
        Real before = step[k];  // of the stair before, one degree below
        step[k] = diagonal;
        for (int d = k + 1; d <= degree; ++d) {
            Real rightKnot = KNOTSPAN_TABLE(table + uint(degree + d - k));
            Real up = (t + leftKnot) * KNOTSPAN_TABLE(nextRow + uint(d - k - 1)) * step[d - 1];
            Real across = (rightKnot + (Real(1) - t)) * KNOTSPAN_TABLE(row + uint(d - k)) * before;
            before = step[d];
            step[d] = up + across;
        }
        // The derivative is p times the difference of two such shares, The NURBS Book, eq. 2.7.
        Real previousShare = share;
        share = Real(0);
        if (k < degree)
            share = Real(degree) * step[degree - 1] * KNOTSPAN_TABLE(nextRow + uint(degree - k - 1));
        basis.value[degree - k] = step[degree];
        basis.slope[degree - k] = share - previousShare;
        row = nextRow;
    }
    return basis;
}

KNOTSPAN_SOURCE_TEMPLATE
BasisValues KNOTSPAN_OF_REAL stairValues(KNOTSPAN_SOURCE uint table, int degree, Real t)
{
    Basis KNOTSPAN_OF_REAL both = stairBasis KNOTSPAN_OF_REAL(KNOTSPAN_PASS_SOURCE table, degree, t);
    BasisValues KNOTSPAN_OF_REAL basis;
    for (int k = 0; k <= degree; ++k)
        basis.value[k] = both.value[k];
    return basis;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
