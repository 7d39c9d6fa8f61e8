// Faces' triangles as one mesh: numbered through, turned one way, and said where it is open and why.
#pragma once

#include "model/mesh/face_triangles.h"
#include "model/mesh/trimmed_meshing.h"

namespace knotspan {

struct TrimmedParts {
    const PlacedScene& placed;
    const std::vector<TrimRegion>& regions;
    const std::vector<OutlinedFace>& faces;
    const OutlineWeld& weld;
    const WeldReach& reach;
    const OutlineSamples& samples;
    const std::vector<std::vector<FaceStretch>>& stretches;  // by face
    const std::vector<FaceTriangles>& triangles;             // by face
};

[[nodiscard]] Result<Tessellation> assembled(const TrimmedParts& parts);

}  // namespace knotspan
