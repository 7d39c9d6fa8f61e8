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

#include "model/analysis/shell_mesh.h"

namespace knotspan {

class ShellCrossings {
public:
    using Parts = std::vector<std::shared_ptr<const ShellPart>>;  // by surface

    // A shell as it is now.
    struct Body {
        const std::vector<std::uint32_t>& surfaces;  // increasing, the members of the mesh
        const Parts& parts;
        const CoincidentEdges& edges;
        const ShellMesh& mesh;
    };
    // Looks at the surfaces that changed since it saw the same shell last, or at all of another one. True
    // where all were shown to keep apart.
    [[nodiscard]] bool look(const Body& body);
    // The same, where only these surfaces of a shell that it saw may have changed since; looks at nobody far
    // from them.
    [[nodiscard]] bool lookAgain(const Body& body, const std::vector<std::uint32_t>& changed);

private:
    using Indices = std::vector<std::uint32_t>;

    struct Seen {
        std::shared_ptr<const ShellPart> part;
        std::shared_ptr<const Indices> shell;
    };
    // A surface that is another than it has seen; null: all of it is new.
    struct Fresh {
        std::uint32_t surface = 0;
        std::shared_ptr<const ShellPart> before;
    };
    [[nodiscard]] std::vector<Fresh> noteChanged(const Body& body);
    [[nodiscard]] bool sweep(const Body& body, std::vector<Fresh> fresh);

    struct Kept;

    std::shared_ptr<Kept> kept_;      // what a small look cut to pieces, for the next one
    std::vector<Seen> seen_;          // by surface
    std::set<std::uint32_t> gaveUp_;  // first surfaces of shells of which something was not looked at
    std::set<std::pair<std::uint32_t, std::uint32_t>> crossing_;  // surfaces, the lower number first
};

}  // namespace knotspan
