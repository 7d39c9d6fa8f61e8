// The border of a face as an eye sees it: closed curves of the picture, by which another face can be trimmed.
#pragma once

#include <vector>

#include "model/trimming/curve_projection.h"

namespace knotspan {

// A surface in space, and what trims it. Refers to what someone else keeps.
struct PlacedFace {
    const NurbsSurface& surface;
    const Mat4& transform;
    const std::vector<TrimLoop>& loops;
};

struct Sight {
    Mat4 toPlane{1.0};     // as that of PlaneProjection
    Vec4 eye{0, 0, 1, 0};  // a place, or with a last number of 0 the direction from all points towards it
    // The more, the nearer to the eye.
    [[nodiscard]] double nearness(const Vec3& point) const;
};

// The outer loops of a trimmed face, else the four sides of its surface. Of rings around a closed surface, as
// the ends of a pipe are, the one nearest to the eye; of a flat one's the longer. Fails, with a sentence,
// where there is no border, where it is open and where it goes behind the eye. The curves refer to the
// surface.
[[nodiscard]] Result<std::vector<PlaneCurve>> seenBorders(const PlacedFace& face, const Sight& sight);

}  // namespace knotspan
