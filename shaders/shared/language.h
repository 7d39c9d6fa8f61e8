// Lets one text be GLSL and C++: the few words in which the languages differ.
//
// In C++ the functions are templates on the evaluator, the scalar and the source of span tables and control points; in
// GLSL the evaluator is a specialization constant, the scalar is float unless the stage defines KNOTSPAN_DOUBLE, and the
// source is whatever it bound (spanTable(), controlPoint()).
#ifndef KNOTSPAN_LANGUAGE_H
#define KNOTSPAN_LANGUAGE_H

#define KNOTSPAN_MAX_ORDER 16  // degree 15

#ifdef __cplusplus

#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#define KNOTSPAN_TEMPLATE template <class Real>
#define KNOTSPAN_SOURCE_TEMPLATE template <class Real, class Source>
#define KNOTSPAN_EVALUATOR_TEMPLATE template <auto evaluator, class Real, class Source>
#define KNOTSPAN_IF_EVALUATOR(number) if constexpr (static_cast<uint>(evaluator) == number)
#define KNOTSPAN_SOURCE const Source &source,
#define KNOTSPAN_PASS_SOURCE source,
#define KNOTSPAN_TABLE(index) source.spanTable(index)
#define KNOTSPAN_POINT(index) source.controlPoint(index)
#define KNOTSPAN_OF_REAL <Real>
#define KNOTSPAN_VEC2 glm::vec<2, Real>
#define KNOTSPAN_VEC3 glm::vec<3, Real>
#define KNOTSPAN_VEC4 glm::vec<4, Real>

namespace knotspan::gpu {
using uint = std::uint32_t;
using glm::mat4;
using glm::mat4x3;
using glm::uvec2;
using glm::vec2;
using glm::vec3;
using glm::vec4;
}  // namespace knotspan::gpu

#else

#define KNOTSPAN_TEMPLATE
#define KNOTSPAN_SOURCE_TEMPLATE
#define KNOTSPAN_EVALUATOR_TEMPLATE
#define KNOTSPAN_IF_EVALUATOR(number) if (evaluator == uint(number))
#define KNOTSPAN_SOURCE
#define KNOTSPAN_PASS_SOURCE
#define KNOTSPAN_TABLE(index) spanTable(index)
#define KNOTSPAN_POINT(index) controlPoint(index)
#define KNOTSPAN_OF_REAL
#ifdef KNOTSPAN_DOUBLE
#define Real double
#define KNOTSPAN_ROUNDING 1e-14lf  // of a coordinate, by evaluation
#define KNOTSPAN_VEC2 dvec2
#define KNOTSPAN_VEC3 dvec3
#define KNOTSPAN_VEC4 dvec4
#else
#define Real float
#define KNOTSPAN_ROUNDING 1e-6  // of a coordinate, by evaluation
#define KNOTSPAN_VEC2 vec2
#define KNOTSPAN_VEC3 vec3
#define KNOTSPAN_VEC4 vec4
#endif

#endif
#endif
