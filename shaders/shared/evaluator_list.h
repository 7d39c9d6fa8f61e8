// The evaluators of basis functions: GLSL expands the list into the choice that a specialization constant
// makes, C++ into the choice of a template, names for the command line and rows of pickers.
//
// An evaluator is three functions in shaders/shared/NAME_basis.glsl, the table of numbers that they read for a
// span (model/geometry/evaluator_tables.h) and one line here:
//     EVALUATOR(number, name, function of values, of values and slopes, of those and second derivatives,
//               "a sentence for people")
#ifndef KNOTSPAN_EVALUATOR_LIST_H
#define KNOTSPAN_EVALUATOR_LIST_H

#define KNOTSPAN_EVALUATOR_LIST(EVALUATOR)                                                          \
    EVALUATOR(0, triangular, triangularValues, triangularBasis, triangularBent,                     \
              "Cox and de Boor's recursion without recursion: exact at every degree")               \
    EVALUATOR(1, stair, stairValues, stairBasis, triangularBent,                                    \
              "The stairs of Concheiro and others: no division, exact at every degree")             \
    EVALUATOR(2, power, powerValues, powerBasis, powerBent,                                         \
              "Powers of the span's parameter: fast, exact up to degree 3 where weights are alike") \
    EVALUATOR(3, bernstein, bernsteinValues, bernsteinBasis, bernsteinBent,                         \
              "Bernstein polynomials of the span's parameter: no division, exact at every degree")

#define KNOTSPAN_EVALUATOR_COUNT 4

#endif
