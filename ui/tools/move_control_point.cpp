#include "ui/tools/move_control_point.h"

#include <glm/geometric.hpp>

#include "model/scene/control_point_editing.h"

namespace knotspan {

namespace {

// A hand that only clicks trembles less than this.
constexpr double kStillPx = 3;

bool hasControlPoint(const SceneObject& object, ControlPointIndex index)
{
    return index.i < object.surface.countU() && index.j < object.surface.countV();
}

}  // namespace

void MoveControlPoint::hover(const ToolContext& context, const ToolPointer& pointer)
{
    context.selection.setHovered(context.pick(pointer.position).controlPoint);
}

ToolAnswer MoveControlPoint::press(const ToolContext& context, const ToolPointer& pointer)
{
    const std::optional<PickedControlPoint> point = context.pick(pointer.position).controlPoint;
    if (!point)
        return ToolAnswer::pass;
    context.document.endPreview();
    const SharedObject object = context.document.scene().find(point->object);
    if (!object || !hasControlPoint(*object, point->index))
        return ToolAnswer::pass;
    context.selection.setControlPoint(point, object.get());
    context.hint({});
    drag_ = Drag{};
    drag_->point = *point;
    drag_->pressed = pointer.position;
    drag_->start = controlPointInModel(*object, point->index);
    drag_->keepsFriends = context.settings.keepFriends;
    return ToolAnswer::keep;
}

Result<Edit> MoveControlPoint::editTo(const ToolContext& context, const SceneObject& object,
                                      const Vec3& position)
{
    const PickedControlPoint& point = drag_->point;
    if (drag_->keepsFriends && !drag_->friends)
        drag_->friends.emplace(context.document.scene(), context.settings.friends);
    if (drag_->friends)
        return drag_->friends->pull({{point.object, point.index, position}});
    Result<SharedObject> changed = withControlPointAt(object, point.index, position);
    if (!changed)
        return tl::unexpected(changed.error());
    Edit edit;
    edit.set(point.object, std::move(*changed));
    return edit;
}

ToolAnswer MoveControlPoint::move(const ToolContext& context, const ToolPointer& pointer)
{
    const SharedObject object = context.document.scene().find(drag_->point.object);
    if (!object)
        return ToolAnswer::revert;
    const Vec2 way = pointer.position - drag_->pressed;
    if (!drag_->moved && glm::length(way) < kStillPx * context.pixelRatio)
        return ToolAnswer::keep;
    drag_->moved = true;
    const Camera& camera = context.camera;
    const double unit = camera.unitsPerPixel(drag_->start, context.height);
    const Vec3 position = drag_->start + (camera.right() * way.x - camera.upward() * way.y) * unit;
    const Result<Edit> edit = editTo(context, *object, position);
    const QString refusal = edit ? QString() : QString::fromStdString(edit.error().sentence());
    if (refusal != drag_->refusal)
        context.hint(refusal);
    drag_->refusal = refusal;
    if (!edit)
        return ToolAnswer::keep;  // stays where it was
    drag_->applied = true;
    context.document.apply(*edit, QObject::tr("Move control point"), context.gesture);
    return ToolAnswer::keep;
}

ToolAnswer MoveControlPoint::release(const ToolContext& context, const ToolPointer&)
{
    const bool cameToNothing = !drag_->applied && !drag_->refusal.isEmpty();
    if (cameToNothing) {
        context.hint({});
        context.trouble(drag_->refusal);
    }
    drag_.reset();
    return cameToNothing ? ToolAnswer::revert : ToolAnswer::commit;
}

void MoveControlPoint::click(const ToolContext& context, const ToolPointer& pointer)
{
    const std::optional<ObjectId> object = context.pick(pointer.position).object;
    std::set<ObjectId> chosen = context.selection.objects();
    const bool adds = pointer.modifiers.testFlag(Qt::ShiftModifier);
    const bool toggles = pointer.modifiers.testFlag(Qt::ControlModifier);
    if (!adds && !toggles)
        chosen.clear();
    if (object && !(toggles && chosen.erase(*object) != 0))
        chosen.insert(*object);
    context.selection.setControlPoint({});
    context.selection.setObjects(std::move(chosen));
}

void MoveControlPoint::cancel()
{
    drag_.reset();
}

}  // namespace knotspan
