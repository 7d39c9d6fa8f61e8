// A surface's parameters as whole numbers, for triangulations: so that a cell of the grids that its KSQuads
// ask for is about as wide as high, or, where they ask for single cells, so that lengths are about those in
// space.
#pragma once

#include "model/mesh/face_errors.h"
#include "model/mesh/outlined_face.h"
#include "model/mesh/plane_triangulation.h"

namespace knotspan {

class FacePlane {
public:
    // Of the part between two places on the lattice of its KSQuads.
    FacePlane(const OutlinedFace& face, const FaceErrors& errors, const Vec2& low, const Vec2& high);

    [[nodiscard]] GridPlace at(const OutlinePlace& place) const;
    // KSQuads along an axis that the part reaches into.
    [[nodiscard]] int first(int axis) const { return first_[axis]; }
    [[nodiscard]] int last(int axis) const { return last_[axis]; }

private:
    std::array<std::vector<double>, 2> starts_;  // of each span, and the last one's end
    Vec2 low_{};
    double scale_ = 1;
    std::array<int, 2> first_{};
    std::array<int, 2> last_{};
};

}  // namespace knotspan
