// The paths that turn visible KSQuads into triangles, as pickers and the command line see them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/scene/render_lists.h"

namespace knotspan {

enum class PathId : int {
    mesh,
    mesh9x9,
    tessellation,
    tessellationAdaptive,
    geometry,
    compute,
    cpu,
    surface,
    bezier
};

struct PathInfo {
    PathId id;
    std::string name;                 // "mesh-9x9"
    std::string description;          // a sentence for a tooltip
    bool followsTolerance;            // false: it draws as many triangles whatever the tolerance
    std::vector<SamplingRule> rules;  // that it can follow, its own first; a count of 0: any
    bool drawsFromDevice =
        true;                // from the control points there: what moves them there is enough (Frame::wave)
    bool cullsDice = false;  // its stages make triangles, and can cull them by evs

    [[nodiscard]] bool follows(SamplingRule rule) const;
    // By its own rule no pixel is further off than asked, and nothing cracks.
    [[nodiscard]] bool keepsTolerance() const { return rules.front().kind == SamplingRule::Kind::bound; }
};

// In the order that pickers show.
[[nodiscard]] const std::vector<PathInfo>& paths();
[[nodiscard]] const PathInfo& pathInfo(PathId id);
[[nodiscard]] std::optional<PathId> findPath(std::string_view name);

}  // namespace knotspan
