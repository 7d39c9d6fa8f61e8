// How far apart edges of faces may be that are taken for one, and whether two stretches of outlines are.
#pragma once

#include <optional>

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

// How far apart is what is joined.
struct WeldReach {
    double same = 0;  // places up to here are one
    double tiny = 0;  // edges that only one face has and that are no longer are as good as a point
    double edges = 0;
};

// By the deviation that is asked for, and by the size of all that is there: what files' edges are off by has
// little to do with the former.
[[nodiscard]] WeldReach weldReach(const std::vector<OutlinedFace>& faces, double deviation);

struct RunningTogether {
    double gap = 0;
    bool reversed = false;
};
// Two stretches between the same corners, where they are no further apart than `most`.
[[nodiscard]] std::optional<RunningTogether> runningTogether(const std::vector<OutlinedFace>& faces,
                                                             const OutlineStretch& one,
                                                             const OutlineStretch& other, double most);

}  // namespace knotspan
