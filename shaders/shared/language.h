// Lets one text be GLSL and C++: the few words in which the languages differ.
//
// In C++ the functions are templates on the evaluator, the scalar and the source of span tables and control points; in
// GLSL the evaluator is a specialization constant, the scalar is float unless the stage defines KNOTSPAN_DOUBLE, and the
// source is whatever it bound (spanTable(), controlPoint()).
#ifndef KNOTSPAN_LANGUAGE_H
#define KNOTSPAN_LANGUAGE_H

// The size of arrays that hold a number for each of degree + 1 functions. Stages are compiled for several sizes: long
// arrays are slow, and the software driver compiles them for many seconds.
#ifndef KNOTSPAN_MAX_ORDER
#define KNOTSPAN_MAX_ORDER 16  // degree 15
#endif

#ifdef __cplusplus

#include <algorithm>
#include <cmath>
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
#define KNOTSPAN_SCENE_TEMPLATE template <class Source>
#define KNOTSPAN_INLINE inline
#define KNOTSPAN_UNUSED [[maybe_unused]]
#define KNOTSPAN_SOURCE [[maybe_unused]] const Source &source,
#define KNOTSPAN_PASS_SOURCE source,
#define KNOTSPAN_TABLE(index) source.spanTable(index)
#define KNOTSPAN_POINT(index) source.controlPoint(index)
#define KNOTSPAN_SURFACE(index) source.surface(index)
#define KNOTSPAN_SURFACE_VIEW(index) source.surfaceView(index)
#define KNOTSPAN_SHOWN_SIDE(index) source.shownSide(index)
#define KNOTSPAN_PIXEL_MAP(index) source.pixelMap(index)
#define KNOTSPAN_POSITION(index, t) source.position(index, t)
#define KNOTSPAN_IS_VISIBLE(index) source.isVisible(index)
#define KNOTSPAN_KSQUAD(index) source.ksquad(index)
#define KNOTSPAN_GRID(index) source.grid(index)
#define KNOTSPAN_BORDER_SIDE(index) source.borderSide(index)
#define KNOTSPAN_BORDER_CORNER(index) source.borderCorner(index)
#define KNOTSPAN_BORDER_PIECE(index) source.borderPiece(index)
#define KNOTSPAN_BORDER_USE(index) source.borderUse(index)
#define KNOTSPAN_FACING_WORD(index) source.facingWord(index)
#define KNOTSPAN_FACING_BOX(index) source.facingBox(index)
#define KNOTSPAN_TRIM_VERDICT(index) source.trimVerdict(index)
#define KNOTSPAN_OVERSAMPLES(flags) false
#define KNOTSPAN_OF_REAL <Real>
#define KNOTSPAN_INOUT(type) type&
#define KNOTSPAN_OF_SOURCE <Source>
#define KNOTSPAN_FLOAT2 vec2
#define KNOTSPAN_FLOAT_MAP PixelMap<float>
#define KNOTSPAN_VEC2 glm::vec<2, Real>
#define KNOTSPAN_VEC3 glm::vec<3, Real>
#define KNOTSPAN_VEC4 glm::vec<4, Real>

namespace knotspan::gpu {
using uint = std::uint32_t;
using std::abs;
using std::ceil;
using std::floor;
using std::max;
using std::min;
using glm::mat4;
using glm::mat4x3;
using glm::uvec2;
using glm::uvec3;
using glm::vec2;
using glm::vec3;
using glm::vec4;
}  // namespace knotspan::gpu

#else

#define KNOTSPAN_TEMPLATE
#define KNOTSPAN_SOURCE_TEMPLATE
#define KNOTSPAN_EVALUATOR_TEMPLATE
#define KNOTSPAN_IF_EVALUATOR(number) if (evaluator == uint(number))
#define KNOTSPAN_SCENE_TEMPLATE
#define KNOTSPAN_INLINE
#define KNOTSPAN_UNUSED
#define KNOTSPAN_SOURCE
#define KNOTSPAN_PASS_SOURCE
#define KNOTSPAN_TABLE(index) spanTable(index)
#define KNOTSPAN_POINT(index) controlPoint(index)
#define KNOTSPAN_SURFACE(index) surfaces[index]
#define KNOTSPAN_SURFACE_VIEW(index) surfaceViews[index]
#define KNOTSPAN_SHOWN_SIDE(index) shownSide(index)
#define KNOTSPAN_PIXEL_MAP(index) pixelMap(index)
#define KNOTSPAN_POSITION(index, t) positionOf(ksquads[index], t)
#define KNOTSPAN_IS_VISIBLE(index) isVisible(index)
#define KNOTSPAN_KSQUAD(index) ksquads[index]
#define KNOTSPAN_GRID(index) grids[index]
#define KNOTSPAN_BORDER_SIDE(index) borderSides[index]
#define KNOTSPAN_BORDER_CORNER(index) borderCorners[index]
#define KNOTSPAN_BORDER_PIECE(index) borderPieces[index]
#define KNOTSPAN_BORDER_USE(index) borderUses[index]
#define KNOTSPAN_FACING_WORD(index) facingWords[index]
#define KNOTSPAN_FACING_BOX(index) facingBoxOf(facing[index])
#define KNOTSPAN_TRIM_VERDICT(index) trimVerdict(index)
#define KNOTSPAN_OVERSAMPLES(flagsOfBorder) \
    ((frame.flags & (((flagsOfBorder) & BORDER_FRIEND) == 0u ? FRAME_OVERSAMPLE_STRANGERS : FRAME_OVERSAMPLE_FRIENDS)) != 0u)
#define KNOTSPAN_OF_REAL
#define KNOTSPAN_INOUT(type) inout type
#define KNOTSPAN_OF_SOURCE
#define KNOTSPAN_FLOAT2 vec2
#define KNOTSPAN_FLOAT_MAP PixelMap
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
