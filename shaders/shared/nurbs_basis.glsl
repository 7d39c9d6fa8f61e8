// B-spline basis functions on one span: the same text for every shader stage and, as a template, for C++.
//
// t = (u - U_i) / h in [0, 1] runs over the span [U_i, U_{i+1}) of length h. What an evaluator needs to know of the span
// is a table of numbers, made in double and normalised to h (model/geometry/evaluator_tables.h). So nothing here sees where
// the knots lie or how long the span is, and float keeps its digits.
#ifndef KNOTSPAN_NURBS_BASIS_GLSL
#define KNOTSPAN_NURBS_BASIS_GLSL

#include "bernstein_basis.glsl"
#include "bindings.h"
#include "evaluator_list.h"
#include "power_basis.glsl"
#include "stair_basis.glsl"
#include "triangular_basis.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#else
layout(constant_id = KNOTSPAN_EVALUATOR_CONSTANT) const uint evaluator = 0u;
#endif

// Values of N_{i-p,p} .. N_{i,p}. `table` is where the span's table starts.
KNOTSPAN_EVALUATOR_TEMPLATE
BasisValues KNOTSPAN_OF_REAL evaluateBasisValues(KNOTSPAN_SOURCE uint table, int degree, Real t)
{
    BasisValues KNOTSPAN_OF_REAL basis;
#define KNOTSPAN_CHOICE(number, name, values, both, bent, sentence) \
    KNOTSPAN_IF_EVALUATOR(number)                             \
        basis = values KNOTSPAN_OF_REAL(KNOTSPAN_PASS_SOURCE table, degree, t);
    KNOTSPAN_EVALUATOR_LIST(KNOTSPAN_CHOICE)
#undef KNOTSPAN_CHOICE
    return basis;
}

// The same and their derivatives by t.
KNOTSPAN_EVALUATOR_TEMPLATE
Basis KNOTSPAN_OF_REAL evaluateBasis(KNOTSPAN_SOURCE uint table, int degree, Real t)
{
    Basis KNOTSPAN_OF_REAL basis;
#define KNOTSPAN_CHOICE(number, name, values, both, bent, sentence) \
    KNOTSPAN_IF_EVALUATOR(number)                             \
        basis = both KNOTSPAN_OF_REAL(KNOTSPAN_PASS_SOURCE table, degree, t);
    KNOTSPAN_EVALUATOR_LIST(KNOTSPAN_CHOICE)
#undef KNOTSPAN_CHOICE
    return basis;
}

// The same and their second derivatives.
KNOTSPAN_EVALUATOR_TEMPLATE
BentBasis KNOTSPAN_OF_REAL evaluateBentBasis(KNOTSPAN_SOURCE uint table, int degree, Real t)
{
    BentBasis KNOTSPAN_OF_REAL basis;
#define KNOTSPAN_CHOICE(number, name, values, both, bent, sentence) \
    KNOTSPAN_IF_EVALUATOR(number)                                   \
        basis = bent KNOTSPAN_OF_REAL(KNOTSPAN_PASS_SOURCE table, degree, t);
    KNOTSPAN_EVALUATOR_LIST(KNOTSPAN_CHOICE)
#undef KNOTSPAN_CHOICE
    return basis;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
