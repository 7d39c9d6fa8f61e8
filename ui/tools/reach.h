// Who follows a drag of control points, and how the picture shows it.
#pragma once

#include "ui/tools/scene_watch.h"
#include "ui/tools/tool.h"

namespace knotspan {

// Objects that may follow beside those with selected points: visible and not locked, where the settings look
// beyond one object at all.
[[nodiscard]] std::set<ObjectId> mayFollow(const Scene& scene, const DragSettings& settings);

// Larger and nearer to orange the larger their share, blue and small the least; without those of `leaders`.
// Of very many some, evenly.
[[nodiscard]] std::vector<ControlPointMark> marksOf(const Followers& followers,
                                                    const PointSelection& leaders);

// Who would follow the control point under the pointer, were it dragged. Found anew only when the point, the
// falloff, the scene or the selection is another.
class ShownReach {
public:
    // Whether marks() are others than before.
    bool find(const ToolContext& context, const std::optional<ScenePoint>& under);
    [[nodiscard]] const std::vector<ControlPointMark>& marks() const { return marks_; }

private:
    struct Asked {
        ScenePoint point;
        DragSettings settings;
        std::uint64_t change = 0;

        [[nodiscard]] bool operator==(const Asked&) const = default;
    };
    SceneWatch watch_;
    std::optional<Asked> asked_;
    std::vector<ControlPointMark> marks_;
};

}  // namespace knotspan
