// The paths that turn visible KSQuads into triangles, as pickers and the command line see them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knotspan {

enum class PathId : int { mesh9x9, tessellation };

struct PathInfo {
    PathId id;
    std::string name;         // "mesh-9x9"
    std::string description;  // a sentence for a tooltip
    bool followsTolerance;    // false: it draws as many triangles whatever the tolerance
};

// In the order that pickers show.
[[nodiscard]] const std::vector<PathInfo>& paths();
[[nodiscard]] const PathInfo& pathInfo(PathId id);
[[nodiscard]] std::optional<PathId> findPath(std::string_view name);

}  // namespace knotspan
