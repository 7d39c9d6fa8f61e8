// Which stretches of faces' outlines run together in space: the edges of a model, found again.
//
// Corners are where arcs end, or where the end of another one lies on them. Between two corners a stretch of
// one outline is joined to the stretch of another that is nearest all along. That begins with what agrees to
// rounding and goes on, for what is still alone, up to a reach; two corners of one face never become one, so
// that features smaller than that stay.
#pragma once

#include "model/mesh/weld_reach.h"

namespace knotspan {

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
    std::vector<double> gaps;  // by face: how far what is joined there is from it, about
};

[[nodiscard]] OutlineWeld weldOutlines(const std::vector<OutlinedFace>& faces, const WeldReach& reach);

}  // namespace knotspan
