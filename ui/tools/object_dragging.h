// Selected objects, dragged by a handle of the gizmo: moved, turned or scaled, only their transforms change
// (model/making/object_making.h). Everything counts from where they stood at the press.
#pragma once

#include <map>

#include "model/making/object_making.h"
#include "ui/tools/drag_snapping.h"
#include "ui/tools/dragging.h"
#include "ui/tools/gizmo.h"

namespace knotspan {

class ObjectDragging : public Dragging {
public:
    // `centre`: the gizmo's, in model space; `grip`: where the hand took hold, in pixels from there.
    ObjectDragging(std::map<ObjectId, SharedObject> objects, const GizmoHandle& handle, const Vec3& centre,
                   const Vec2& grip);

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
    [[nodiscard]] Vec3 direction() const;
    [[nodiscard]] Result<Vec3> movementOf(const ToolContext& context, const Vec2& way);
    [[nodiscard]] Result<double> factorOf(const ToolContext& context, const Vec2& way) const;
    [[nodiscard]] Result<Edit> movedBy(const Vec3& by);
    [[nodiscard]] Result<Edit> turnedByDegrees(double degrees);
    [[nodiscard]] Result<Edit> scaledBy(double factor);
    [[nodiscard]] Result<Edit> transformed(TransformNumbers numbers) const;

    std::map<ObjectId, SharedObject> objects_;  // as they stood
    HandleKind kind_;
    DragAxis axis_;
    Vec3 centre_;
    Vec2 grip_;
    double degrees_ = 0;  // by the hand's last move
    Vec3 moved_{0};
    std::optional<DragSnapping> snapping_;
    std::optional<Vec3> target_;
};

}  // namespace knotspan
