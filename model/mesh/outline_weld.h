// Which stretches of faces' outlines run together in space: the edges of a model, found again.
//
// Corners are where arcs end, or where the end of another one lies on them. Between two corners a stretch of
// one outline is joined to the stretch of another that is nearest all along. That begins with what agrees to
// rounding and goes on, for what is still alone, up to the tolerance; two corners of one face never become
// one, so that features smaller than the tolerance stay.
#pragma once

#include "model/mesh/outlined_face.h"

namespace knotspan {

// Of an arc, between two corners.
struct OutlineStretch {
    std::uint32_t face = 0;
    std::uint32_t arc = 0;
    double from = 0;
    double to = 0;
    std::uint32_t start = 0;  // corners
    std::uint32_t end = 0;
};

// Stretches that run together: two of a closed model, one at an open edge.
struct OutlineSeam {
    std::vector<std::uint32_t> stretches;
    std::vector<char> reversed;  // against the first
    bool isPoint = false;        // all of it is one corner, such as a pole
};

struct OutlineWeld {
    std::vector<OutlineStretch> stretches;
    std::vector<OutlineSeam> seams;
    std::vector<Vec3> corners;
    double gap = 0;  // how far joined stretches and corners are apart, about
};

[[nodiscard]] OutlineWeld weldOutlines(const std::vector<OutlinedFace>& faces, double tolerance);

}  // namespace knotspan
