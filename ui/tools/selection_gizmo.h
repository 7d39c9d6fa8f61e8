// The handles of what is selected: of control points where some are, otherwise of objects. Found anew only
// when the scene or the selection is another.
#pragma once

#include "ui/tools/gizmo.h"
#include "ui/tools/scene_watch.h"

namespace knotspan {

struct PlacedHandles {
    Vec3 centre{0};  // the selected points' mean, or the middle of the objects' bounds
    std::vector<GizmoHandle> handles;
    bool ofObjects = false;
};

// Visible and not locked: what a gizmo moves.
[[nodiscard]] std::map<ObjectId, SharedObject> movableObjects(const Scene& scene,
                                                              const std::set<ObjectId>& selected);

// Without handles where nothing is selected or the frame is `none`. U, V and N are left out where the net has
// no such direction.
[[nodiscard]] PlacedHandles handlesOf(const Scene& scene, const Selection& selection, GizmoFrame frame);

class SelectionGizmo {
public:
    [[nodiscard]] const PlacedHandles& at(const ToolContext& context);

private:
    SceneWatch watch_;
    std::optional<std::uint64_t> change_;
    GizmoFrame frame_ = GizmoFrame::none;
    PlacedHandles found_;
};

}  // namespace knotspan
