// Lets one text be GLSL and C++: the few words in which the languages differ.
//
// In C++ the functions are templates on the scalar and on the source of knots and control points; in GLSL the
// scalar is float and the source is whatever the including stage bound (spanKnot(), controlPoint()).
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
#define KNOTSPAN_SOURCE const Source &source,
#define KNOTSPAN_PASS_SOURCE source,
#define KNOTSPAN_OF_REAL <Real>
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
#define KNOTSPAN_SOURCE
#define KNOTSPAN_PASS_SOURCE
#define KNOTSPAN_OF_REAL
#define Real float
#define KNOTSPAN_VEC3 vec3
#define KNOTSPAN_VEC4 vec4

#endif
#endif
