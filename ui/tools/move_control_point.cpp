#include "ui/tools/move_control_point.h"

#include <utility>

#include "model/scene/control_point_editing.h"
#include "ui/tools/choosing.h"
#include "ui/tools/object_dragging.h"
#include "ui/tools/point_dragging.h"

namespace knotspan {

// A control point that is nearer wins.
std::optional<size_t> MoveControlPoint::handleUnder(const ToolContext& context, const Vec2& pixel,
                                                    const Pick& pick) const
{
    const PlacedHandles& placed = gizmo_.at(context);
    if (placed.handles.empty())
        return std::nullopt;
    const auto hit = Gizmo(viewOf(context), placed.centre, placed.handles).under(pixel);
    if (!hit || (takenPoint(context, pick) && pick.distancePx < hit->distancePx))
        return std::nullopt;
    return hit->handle;
}

void MoveControlPoint::hover(const ToolContext& context, const ToolPointer& pointer)
{
    const Pick pick = context.pick(pointer.position);
    const std::optional<size_t> lit = handleUnder(context, pointer.position, pick);
    const bool isLitAnew = std::exchange(lit_, lit) != lit;
    const std::optional<ScenePoint> point = lit ? std::nullopt : takenPoint(context, pick);
    const bool isReachNew = reach_.find(context, point);
    if (isLitAnew || isReachNew)
        context.redraw();
    if (lit)
        context.selection.setHovered({});
    else if (point)
        context.selection.setHovered(pick.controlPoint);
    else
        context.selection.setHoveredObject(context.settings.filter.objects ? pick.object() : std::nullopt);
}

void MoveControlPoint::leave(const ToolContext& context)
{
    const bool wasLit = std::exchange(lit_, std::nullopt).has_value();
    const bool isReachNew = reach_.find(context, {});
    if (wasLit || isReachNew)
        context.redraw();
    context.selection.setHovered({});
}

ToolAnswer MoveControlPoint::press(const ToolContext& context, const ToolPointer& pointer)
{
    const Pick pick = context.pick(pointer.position);
    const bool toggles = pointer.modifiers.testFlag(Qt::ControlModifier);
    if (const auto handle = handleUnder(context, pointer.position, pick); handle && !toggles)
        return pressHandle(context, pointer, *handle);
    const auto point = takenPoint(context, pick);
    return point ? pressPoint(context, pointer, *point) : ToolAnswer::pass;
}

ToolAnswer MoveControlPoint::pressHandle(const ToolContext& context, const ToolPointer& pointer,
                                         size_t handle)
{
    context.document.endPreview();
    context.hint({});
    const PlacedHandles placed = gizmo_.at(context);
    if (handle >= placed.handles.size())
        return ToolAnswer::pass;  // it was a preview's
    const GizmoHandle& chosen = placed.handles[handle];
    std::unique_ptr<Dragging> dragging;
    if (placed.ofObjects) {
        const auto middle = context.camera.toPixel(placed.centre, context.width, context.height);
        dragging = std::make_unique<ObjectDragging>(
            movableObjects(context.document.scene(), context.selection.objects()), chosen, placed.centre,
            pointer.position - middle.value_or(pointer.position));
    } else {
        dragging = std::make_unique<PointDragging>(placed.centre, chosen.axis);
    }
    held_.emplace(Held{DragGesture(std::move(dragging), pointer.position), placed, handle, {}, false});
    context.redraw();
    return ToolAnswer::keep;
}

ToolAnswer MoveControlPoint::pressPoint(const ToolContext& context, const ToolPointer& pointer,
                                        const ScenePoint& point)
{
    context.document.endPreview();
    const Scene& scene = context.document.scene();
    const PointSelection one = pointOf(scene, point);
    if (one.isEmpty())
        return ToolAnswer::pass;
    const Choosing how = choosingBy(pointer.modifiers);
    const bool keeps = how == Choosing::alone && context.selection.points().contains(point);
    if (how == Choosing::alone && !keeps)
        context.selection.setObjects({point.object});
    if (!keeps)
        choosePoints(context.selection, one, how);
    context.hint({});
    if (!context.selection.points().contains(point))
        return ToolAnswer::commit;  // taken out
    const Vec3 start = controlPointInModel(*scene.find(point.object), point.index);
    auto dragging = std::make_unique<PointDragging>(start, context.settings.drag.axis);
    held_.emplace(Held{DragGesture(std::move(dragging), pointer.position),
                       gizmo_.at(context),
                       {},
                       point,
                       how == Choosing::alone});
    return ToolAnswer::keep;
}

ToolAnswer MoveControlPoint::move(const ToolContext& context, const ToolPointer& pointer)
{
    held_->gesture.move(context, pointer);
    return ToolAnswer::keep;
}

ToolAnswer MoveControlPoint::key(const ToolContext& context, const QKeyEvent& event)
{
    if (!held_)
        return ToolAnswer::pass;
    const ToolAnswer answer = held_->gesture.key(context, event);
    if (answer == ToolAnswer::commit)
        cancel();
    return answer;
}

ToolAnswer MoveControlPoint::release(const ToolContext& context, const ToolPointer& pointer)
{
    Held held = *std::exchange(held_, std::nullopt);
    lit_.reset();
    const ToolAnswer answer = held.gesture.release(context);
    if (held.gesture.hasBegun())
        return answer;
    if (held.point && held.alone)
        context.selection.setPoints(pointOf(context.document.scene(), *held.point));
    else if (held.handle && held.gizmo.ofObjects && context.pick(pointer.position).object())
        click(context, pointer);  // meant what is behind the handle
    return answer;
}

void MoveControlPoint::click(const ToolContext& context, const ToolPointer& pointer)
{
    chooseAt(context, pointer);
}

void MoveControlPoint::cancel()
{
    held_.reset();
    lit_.reset();
}

void MoveControlPoint::show(const ToolContext& context, Overlays& overlays) const
{
    const PlacedHandles& placed = held_ ? held_->gizmo : gizmo_.at(context);
    const Vec3 moved = held_ ? held_->gesture.gizmoMoved() : Vec3(0);
    const Gizmo gizmo(viewOf(context), placed.centre + moved, placed.handles);
    const std::vector<Stroke> strokes = gizmo.strokes(held_ ? litWhileHeld() : lit_);
    overlays.strokes.insert(overlays.strokes.end(), strokes.begin(), strokes.end());
    if (held_)
        held_->gesture.dragging().show(context, overlays);
    if (!held_ || !held_->gesture.hasBegun())
        overlays.marks.insert(overlays.marks.end(), reach_.marks().begin(), reach_.marks().end());
}

// The one along the drag's axis: a key may have chosen another than the hand took.
std::optional<size_t> MoveControlPoint::litWhileHeld() const
{
    const std::vector<GizmoHandle>& handles = held_->gizmo.handles;
    const HandleKind kind = held_->handle ? handles[*held_->handle].kind : HandleKind::move;
    for (size_t k = 0; k < handles.size(); ++k)
        if (handles[k].kind == kind && handles[k].axis == held_->gesture.dragging().axis())
            return k;
    return std::nullopt;
}

}  // namespace knotspan
