// From our surfaces and trim curves to OpenCASCADE's, number by number.
//
// Only model/formats includes this: OpenCASCADE's macros break other libraries' headers.
#pragma once

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>

#include "model/scene/scene_object.h"

namespace knotspan::occt {

// The object's surface in model space, its coordinates times `scale`. Degrees, knots and weights stay; knots
// that differ by no more than rounding become one. Weights that are all the same become 1. Fails with a
// sentence where OpenCASCADE cannot hold the numbers.
[[nodiscard]] Result<Handle(Geom_BSplineSurface)> splineOf(const SceneObject& object, double scale);

// The coordinate, or 0 where it is so small that OpenCASCADE's writers have no room for its exponent.
[[nodiscard]] double withoutDust(double coordinate);

[[nodiscard]] Result<Handle(Geom2d_BSplineCurve)> splineOf(const TrimCurve& curve);

}  // namespace knotspan::occt
