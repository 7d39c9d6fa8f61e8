// Selects objects and control points by clicking, and moves the selected ones with the hand: control points
// in the plane that faces the eye or along the axis that the settings ask for (point_dragging.h), or by a
// handle of the gizmo, that also moves, turns and scales objects (object_dragging.h). Keys choose axes and
// type numbers meanwhile (drag_gesture.h). With ToolSettings::keepFriends the control points of friends
// follow; where they cannot, nothing moves and the reason is said.
#pragma once

#include "ui/tools/drag_gesture.h"
#include "ui/tools/gizmo.h"
#include "ui/tools/reach.h"
#include "ui/tools/selection_gizmo.h"
#include "ui/tools/tool.h"

namespace knotspan {

class MoveControlPoint : public Tool {
public:
    void hover(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer press(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer move(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer release(const ToolContext& context, const ToolPointer& pointer) override;
    void click(const ToolContext& context, const ToolPointer& pointer) override;
    void cancel() override;
    ToolAnswer key(const ToolContext& context, const QKeyEvent& event) override;
    void leave(const ToolContext& context) override;
    void show(const ToolContext& context, Overlays& overlays) const override;

private:
    struct Held {
        DragGesture gesture;
        PlacedHandles gizmo;              // as it stood
        std::optional<size_t> handle;     // of it, if the hand holds one,
        std::optional<ScenePoint> point;  // or the control point
        bool alone = false;               // a press that goes nowhere leaves the point selected alone
    };
    [[nodiscard]] std::optional<size_t> handleUnder(const ToolContext& context, const Vec2& pixel,
                                                    const Pick& pick) const;
    ToolAnswer pressHandle(const ToolContext& context, const ToolPointer& pointer, size_t handle);
    ToolAnswer pressPoint(const ToolContext& context, const ToolPointer& pointer, const ScenePoint& point);

    [[nodiscard]] std::optional<size_t> litWhileHeld() const;

    std::optional<Held> held_;
    std::optional<size_t> lit_;
    mutable SelectionGizmo gizmo_;  // keeps what it found
    ShownReach reach_;
};

}  // namespace knotspan
