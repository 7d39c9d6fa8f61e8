// The evaluator `bernstein`: each function as a sum of t^m (1 - t)^(p-m). All terms are positive, so no digit is lost.
//
// Its table is (p+1)^2 + p^2 numbers, binomials included. At index k (p + 1) + m the coefficient of t^m (1 - t)^(p-m) of
// N_{i-p+k,p}. Then at index k p + m that of t^m (1 - t)^(p-1-m) of the share p N_{i-p+1+k,p-1} / (U_{i+1+k} -
// U_{i-p+1+k}), by the span's t, of which derivatives are differences (The NURBS Book, eq. 2.7).
#ifndef KNOTSPAN_BERNSTEIN_BASIS_GLSL
#define KNOTSPAN_BERNSTEIN_BASIS_GLSL

#include "basis_records.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

// t^m (1 - t)^(n-m), m = 0 .. n: powers of t upwards, then of 1 - t downwards.
KNOTSPAN_TEMPLATE
BasisValues KNOTSPAN_OF_REAL bernsteinPowers(int n, Real t)
{
    BasisValues KNOTSPAN_OF_REAL powers;
    powers.value[0] = Real(1);
    for (int m = 1; m <= n; ++m)
        powers.value[m] = powers.value[m - 1] * t;
    Real rest = Real(1) - t;
    Real power = Real(1);
    for (int m = n - 1; m >= 0; --m) {
        power = power * rest;
        powers.value[m] = powers.value[m] * power;
    }
    return powers;
}

KNOTSPAN_SOURCE_TEMPLATE
BasisValues KNOTSPAN_OF_REAL bernsteinValues(KNOTSPAN_SOURCE uint table, int degree, Real t)
{
    BasisValues KNOTSPAN_OF_REAL powers = bernsteinPowers(degree, t);
    BasisValues KNOTSPAN_OF_REAL basis;
    for (int k = 0; k <= degree; ++k) {
        uint first = table + uint(k * (degree + 1));
        Real value = Real(0);
        for (int m = 0; m <= degree; ++m)
            value += KNOTSPAN_TABLE(first + uint(m)) * powers.value[m];
        basis.value[k] = value;
    }
    return basis;
}

KNOTSPAN_SOURCE_TEMPLATE
Basis KNOTSPAN_OF_REAL bernsteinBasis(KNOTSPAN_SOURCE uint table, int degree, Real t)
{
    BasisValues KNOTSPAN_OF_REAL lower = bernsteinPowers(degree - 1, t);
    Basis KNOTSPAN_OF_REAL basis;
    Real previousShare = Real(0);
    uint shares = table + uint((degree + 1) * (degree + 1));
    for (int k = 0; k <= degree; ++k) {
        Real value = KNOTSPAN_TABLE(table + uint(k * (degree + 1) + degree)) * (lower.value[degree - 1] * t);
        Real share = Real(0);
        for (int m = 0; m < degree; ++m) {
            value += KNOTSPAN_TABLE(table + uint(k * (degree + 1) + m)) * (lower.value[m] * (Real(1) - t));
            if (k < degree)
                share += KNOTSPAN_TABLE(shares + uint(k * degree + m)) * lower.value[m];
        }
        basis.value[k] = value;
        basis.slope[k] = previousShare - share;
        previousShare = share;
    }
    return basis;
}

// Second derivatives are differences of the shares' first ones.
KNOTSPAN_SOURCE_TEMPLATE
BentBasis KNOTSPAN_OF_REAL bernsteinBent(KNOTSPAN_SOURCE uint table, int degree, Real t)
{
    BasisValues KNOTSPAN_OF_REAL lower = bernsteinPowers(degree - 1, t);
    BasisValues KNOTSPAN_OF_REAL lowest = bernsteinPowers(max(degree - 2, 0), t);
    BentBasis KNOTSPAN_OF_REAL basis;
    Real previousShare = Real(0);
    Real previousSlope = Real(0);
    uint shares = table + uint((degree + 1) * (degree + 1));
    for (int k = 0; k <= degree; ++k) {
        Real value = KNOTSPAN_TABLE(table + uint(k * (degree + 1) + degree)) * (lower.value[degree - 1] * t);
        Real share = Real(0);
        Real shareSlope = Real(0);
        for (int m = 0; m < degree; ++m) {
            value += KNOTSPAN_TABLE(table + uint(k * (degree + 1) + m)) * (lower.value[m] * (Real(1) - t));
            if (k == degree)
                continue;
            Real coefficient = KNOTSPAN_TABLE(shares + uint(k * degree + m));
            share += coefficient * lower.value[m];
            Real rising = m > 0 ? Real(m) * lowest.value[m - 1] : Real(0);
            Real falling = m < degree - 1 ? Real(degree - 1 - m) * lowest.value[m] : Real(0);
            shareSlope += coefficient * (rising - falling);
        }
        basis.value[k] = value;
        basis.slope[k] = previousShare - share;
        basis.bend[k] = previousSlope - shareSlope;
        previousShare = share;
        previousSlope = shareSlope;
    }
    return basis;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
