// What the device holds of a KSQuad's facing (shaders/shared/facing_forms.glsl), made from its net in double.
#pragma once

#include <cstdint>
#include <span>

#include "model/geometry/bezier_conversion.h"
#include "shaders/shared/facing_forms.glsl"

namespace knotspan {

// `net`: the KSQuad's Bezier net of the control points that the device holds, floats, in the surface's
// coordinates. `origin`: the point of its control point (p / 2, q / 2), in the same; the device finds its
// own, rounded. `rays`: facingWordCount() words to fill; or none, where the box is enough.
//
// The box says "never" (reach.x < 0) of KSQuads that no eye can be told to see from behind: whose rays lie on
// no side of a plane, that are one point, or whose shape is lost in float's rounding.
[[nodiscard]] gpu::FacingRecord makeFacingForms(const BezierNet& net, const Vec3& origin,
                                                std::span<std::uint32_t> rays);
[[nodiscard]] gpu::FacingRecord neverFacingAway();

}  // namespace knotspan
