// Selected control points, dragged: freely or along an axis, with falloff, symmetry, friends and snapping as
// the settings say (model/sculpting/point_drag.h).
#pragma once

#include "model/matching/drag_with_friends.h"
#include "ui/tools/drag_snapping.h"
#include "ui/tools/dragging.h"

namespace knotspan {

// The selected points moved at once, with all that follows a drag: falloff, images, friends. The settings'
// axis does not count.
struct MovedPoints {
    Edit edit;
    size_t following = 0;  // control points beside the selected ones; friends are not counted
};
[[nodiscard]] Result<MovedPoints> movedPoints(const Scene& scene, const PointSelection& chosen,
                                              const ToolSettings& settings, const Vec3& by);

class PointDragging : public Dragging {
public:
    // `start`: where what the hand holds stands, in model space.
    PointDragging(const Vec3& start, DragAxis axis) : start_(start), axis_(axis) {}

    [[nodiscard]] Result<void> begin(const ToolContext& context) override;
    [[nodiscard]] Result<void> choose(DragAxis axis) override;
    [[nodiscard]] DragAxis axis() const override { return axis_; }
    [[nodiscard]] Result<Edit> byHand(const ToolContext& context, const Vec2& way) override;
    [[nodiscard]] Result<Edit> byNumbers(const ToolContext& context, const DragNumbers& numbers) override;
    [[nodiscard]] QString step() const override;
    [[nodiscard]] QString manner() const override;
    [[nodiscard]] QString unit(const Scene& scene) const override;
    [[nodiscard]] Vec3 gizmoMoved() const override { return moved_; }
    void show(const ToolContext& context, Overlays& overlays) const override;

private:
    // What the drag was begun with.
    struct Begun {
        Scene scene;
        PointSelection chosen;
        PointSelection leaders;  // and their twins
        DragSettings settings;
    };
    [[nodiscard]] Result<void> takeHold();
    [[nodiscard]] Result<Edit> moved(const Vec3& by);
    [[nodiscard]] Result<Edit> movedAlongAxis(double distance);
    [[nodiscard]] Result<Edit> movedWithFriends(const Vec3& by);

    Vec3 start_;
    DragAxis axis_;
    std::optional<Begun> begun_;
    std::optional<PointDrag> points_;
    std::optional<DragWithFriends> friends_;  // where they are kept
    std::optional<DragSnapping> snapping_;
    std::optional<Vec3> target_;  // that the hand's last move found
    std::vector<ControlPointMark> marks_;
    Vec3 moved_{0};
};

}  // namespace knotspan
