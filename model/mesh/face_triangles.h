// One face as triangles inside its outline: the outline's own vertices, those of its KSQuads' grids inside,
// knot lines as edges, so that each triangle lies in one KSQuad and is proved to be near it.
#pragma once

#include "model/mesh/outline_samples.h"
#include "model/mesh/quad_triangles.h"

namespace knotspan {

// Of a seam's samples, this one and the next.
struct SeamSegment {
    std::uint32_t seam = 0;
    std::uint32_t segment = 0;
};

struct FaceTriangles {
    struct Corners {
        Triangle vertices{};  // below `outlineCount` those of the samples, beyond them those of `inside`
        TriangleParameters t{};
        std::uint32_t ksquad = 0;  // a countV + b
    };
    std::vector<Corners> triangles;  // by KSQuad, increasing
    std::vector<OutlinePlace> inside;
    std::uint32_t outlineCount = 0;    // of the samples as they were when this was made
    double bound = 0;                  // but for the outline's gaps
    std::vector<SeamSegment> tooLong;  // what has to be finer first: then there is not more than this
    std::vector<std::array<std::uint32_t, 2>> same;  // samples' vertices that are one place here
    // Straight edges of the outline that run there and back, so that nothing is beside them: sorted, the
    // smaller vertex first.
    std::vector<std::array<std::uint32_t, 2>> hairs;
    bool crosses = false;  // the outline still crosses itself
};

// A stretch of the face's outline, as a seam has it.
struct FaceStretch {
    std::uint32_t seam = 0;
    std::uint32_t member = 0;
    std::uint32_t arc = 0;
};

struct FaceTask {
    const OutlinedFace& face;
    const FaceErrors& errors;
    const TrimRegion& region;
    const std::vector<FaceStretch>& stretches;
    const OutlineSamples& samples;
};

// With `anyway`, triangles come of outlines too that cross themselves, as well as they can.
[[nodiscard]] FaceTriangles trianglesOf(const FaceTask& task, bool anyway);

}  // namespace knotspan
