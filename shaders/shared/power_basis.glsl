// The evaluator `power`: each function as a polynomial in t, by Horner's rule. Macri, "Using NURBS surfaces in real-time
// applications" (1999).
//
// Its table is (p+1)^2 numbers: the coefficient of t^m of N_{i-p+k,p} at index k (p + 1) + m. They alternate in sign and
// reach 3^p, so that digits are lost from degree 4 on. What is left of a function that fades out is rounding, so weights
// that differ by more than 10 are felt from degree 3 on: the other evaluators keep the digits of each function.
#ifndef KNOTSPAN_POWER_BASIS_GLSL
#define KNOTSPAN_POWER_BASIS_GLSL

#include "basis_records.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

KNOTSPAN_SOURCE_TEMPLATE
BasisValues KNOTSPAN_OF_REAL powerValues(KNOTSPAN_SOURCE uint table, int degree, Real t)
{
    BasisValues KNOTSPAN_OF_REAL basis;
    for (int k = 0; k <= degree; ++k) {
        uint first = table + uint(k * (degree + 1));
        Real value = KNOTSPAN_TABLE(first + uint(degree));
        for (int m = degree - 1; m >= 0; --m)
            value = value * t + KNOTSPAN_TABLE(first + uint(m));
        basis.value[k] = value;
    }
    return basis;
}

KNOTSPAN_SOURCE_TEMPLATE
Basis KNOTSPAN_OF_REAL powerBasis(KNOTSPAN_SOURCE uint table, int degree, Real t)
{
    Basis KNOTSPAN_OF_REAL basis;
    for (int k = 0; k <= degree; ++k) {
        uint first = table + uint(k * (degree + 1));
        Real value = KNOTSPAN_TABLE(first + uint(degree));
        Real slope = Real(0);
        for (int m = degree - 1; m >= 0; --m) {
            slope = slope * t + value;
            value = value * t + KNOTSPAN_TABLE(first + uint(m));
        }
        basis.value[k] = value;
        basis.slope[k] = slope;
    }
    return basis;
}

KNOTSPAN_SOURCE_TEMPLATE
BentBasis KNOTSPAN_OF_REAL powerBent(KNOTSPAN_SOURCE uint table, int degree, Real t)
{
    BentBasis KNOTSPAN_OF_REAL basis;
    for (int k = 0; k <= degree; ++k) {
        uint first = table + uint(k * (degree + 1));
        Real value = KNOTSPAN_TABLE(first + uint(degree));
        Real slope = Real(0);
        Real halfBend = Real(0);
        for (int m = degree - 1; m >= 0; --m) {
            halfBend = halfBend * t + slope;
            slope = slope * t + value;
            value = value * t + KNOTSPAN_TABLE(first + uint(m));
        }
        basis.value[k] = value;
        basis.slope[k] = slope;
        basis.bend[k] = Real(2) * halfBend;
    }
    return basis;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
