// Which surfaces of a shell may go through each other, or through themselves. A body that does can be turned
// inside out in places: from outside one sees back faces there.
//
// Two KSQuads without a common corner are shown to be apart by slabs around their Bézier nets, in thirteen
// directions and across either of them; where that is not enough they are cut into four. Of KSQuads beside
// each other the same is shown of their quarters. A fold within quarters beside each other stays unknown, and
// at T-joints one within KSQuads beside each other.
#pragma once

#include <memory>
#include <set>
#include <utility>

#include "model/analysis/coincident_edges.h"
#include "model/analysis/shell_part.h"

namespace knotspan {

class ShellCrossings {
public:
    using Parts = std::vector<std::shared_ptr<const ShellPart>>;  // by surface

    // Looks at the surfaces that changed since it saw the same shell last, or at all of another one. True
    // where all were shown to keep apart. `margin`: how far points that are joined may be apart.
    [[nodiscard]] bool lookAgain(const std::vector<std::uint32_t>& shell, const Parts& parts,
                                 const CoincidentEdges& edges, double margin);

private:
    struct Seen {
        std::shared_ptr<const ShellPart> part;
        std::shared_ptr<const std::vector<std::uint32_t>> shell;
    };
    [[nodiscard]] Box dropChanged(const std::vector<std::uint32_t>& shell, const Parts& parts);

    std::vector<char> fresh_;                                     // by surface: changed since it was seen
    std::vector<Seen> seen_;                                      // by surface
    std::set<std::pair<std::uint32_t, std::uint32_t>> crossing_;  // surfaces, the lower number first
};

}  // namespace knotspan
