// A triangle between places of a face, as the KSQuad has it that it lies in.
#pragma once

#include "model/mesh/face_plane.h"
#include "model/mesh/quad_triangles.h"

namespace knotspan {

struct TriangleInKsquad {
    int a = 0;
    int b = 0;
    TriangleParameters t{};
    double spills = 0;  // how far, in space, corners are beyond it

    [[nodiscard]] Vec2 size() const;  // of the box around the parameters
};

[[nodiscard]] TriangleInKsquad inKsquad(const std::array<OutlinePlace, 3>& corners, const FacePlane& plane,
                                        const FaceErrors& errors);

}  // namespace knotspan
