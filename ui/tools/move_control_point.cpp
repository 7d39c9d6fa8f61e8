#include "ui/tools/move_control_point.h"

#include <glm/geometric.hpp>

#include "model/scene/control_point_editing.h"
#include "model/sculpting/twins.h"

namespace knotspan {

namespace {

// A hand that only clicks trembles less than this.
constexpr double kStillPx = 3;
constexpr double kFine = 0.1;

// Who may follow a drag beside the objects that it has points of.
std::set<ObjectId> followersIn(const Scene& scene, const DragSettings& settings)
{
    const bool inSpace = settings.falloff.radius > 0 && settings.falloff.distance == FalloffDistance::space;
    std::set<ObjectId> others;
    if (inSpace || settings.symmetry.kind == SymmetryKind::plane)
        for (const auto& [id, object] : scene.objects())
            if (object->visible)
                others.insert(id);
    return others;
}

// The point of the axis through a point that is nearest on the picture to where the hand is.
Result<double> alongAxis(const Camera& camera, const Vec3& axis, const Vec3& inPlane)
{
    const Vec2 seen(glm::dot(axis, camera.right()), glm::dot(axis, camera.upward()));
    constexpr double kLeast = 0.02;
    if (glm::dot(seen, seen) < kLeast * kLeast)
        return failure("The axis points at the eye", "Turn the view, or choose another axis");
    const Vec2 wanted(glm::dot(inPlane, camera.right()), glm::dot(inPlane, camera.upward()));
    return glm::dot(wanted, seen) / glm::dot(seen, seen);
}

}  // namespace

void MoveControlPoint::hover(const ToolContext& context, const ToolPointer& pointer)
{
    context.selection.setHovered(context.pick(pointer.position).controlPoint);
}

ToolAnswer MoveControlPoint::press(const ToolContext& context, const ToolPointer& pointer)
{
    const std::optional<PickedControlPoint> picked = context.pick(pointer.position).controlPoint;
    if (!picked)
        return ToolAnswer::pass;
    context.document.endPreview();
    const Scene& scene = context.document.scene();
    const ScenePoint point{picked->object, picked->index};
    const PointSelection one = pointOf(scene, point);
    if (one.isEmpty())
        return ToolAnswer::pass;
    const bool adds = pointer.modifiers.testFlag(Qt::ShiftModifier);
    const bool toggles = pointer.modifiers.testFlag(Qt::ControlModifier);
    PointSelection chosen = context.selection.points();
    const bool wasChosen = chosen.contains(point);
    if (toggles)
        chosen.toggle(one);
    else if (adds)
        chosen.add(one);
    else if (!wasChosen)
        chosen = one;
    if (!adds && !toggles && !wasChosen)
        context.selection.setObjects({point.object});
    context.selection.setPoints(chosen);
    context.hint({});
    if (!chosen.contains(point))
        return ToolAnswer::commit;  // taken out
    drag_ = Drag{};
    drag_->point = point;
    drag_->alone = !adds && !toggles;
    drag_->pressed = drag_->last = pointer.position;
    drag_->start = controlPointInModel(*scene.find(point.object), point.index);
    return ToolAnswer::keep;
}

Result<void> MoveControlPoint::begin(const ToolContext& context)
{
    const Scene& scene = context.document.scene();
    const PointSelection chosen = withTwins(scene, context.selection.points());
    DragSettings settings = context.settings.drag;
    settings.others = followersIn(scene, settings);
    auto points = PointDrag::begin(scene, chosen, settings);
    if (!points)
        return tl::unexpected(points.error());
    drag_->points = *std::move(points);
    const size_t count = context.selection.points().size();
    drag_->step = count == 1 ? QObject::tr("Move control point")
                             : QObject::tr("Move %1 control points").arg(static_cast<qulonglong>(count));
    if (context.settings.keepFriends)
        drag_->friends.emplace(scene, context.settings.friends);
    return {};
}

Result<Edit> MoveControlPoint::editTo(const ToolContext& context)
{
    const Camera& camera = context.camera;
    const double unit = camera.unitsPerPixel(drag_->start, context.height);
    Vec3 by = (camera.right() * drag_->way.x - camera.upward() * drag_->way.y) * unit;
    const Vec3 axis = drag_->points->direction();
    if (context.settings.drag.axis != DragAxis::free) {
        const auto distance = alongAxis(camera, axis, by);
        if (!distance)
            return tl::unexpected(distance.error());
        if (!drag_->friends)
            return drag_->points->movedAlong(*distance);
        by = *distance * axis;
    }
    if (!drag_->friends)
        return drag_->points->moved(by);
    std::vector<ObjectPull> pulls;
    for (const auto& [id, shifts] : drag_->points->shifts(by))
        for (const PointShift& shift : shifts)
            pulls.push_back({id, shift.index, drag_->friends->startOf(id, shift.index) + shift.by});
    return drag_->friends->pull(pulls);
}

ToolAnswer MoveControlPoint::move(const ToolContext& context, const ToolPointer& pointer)
{
    if (!drag_->moved && glm::length(pointer.position - drag_->pressed) < kStillPx * context.pixelRatio)
        return ToolAnswer::keep;
    const bool first = !drag_->moved;
    drag_->moved = true;
    const double share = pointer.modifiers.testFlag(Qt::ShiftModifier) ? kFine : 1;
    drag_->way += share * (pointer.position - drag_->last);
    drag_->last = pointer.position;
    const auto refuse = [&](const Error& error) {
        const QString refusal = QString::fromStdString(error.sentence());
        if (refusal != drag_->refusal)
            context.hint(refusal);
        drag_->refusal = refusal;
        return ToolAnswer::keep;  // all stay where they were
    };
    if (first || !drag_->points)
        if (const auto begun = begin(context); !begun)
            return refuse(begun.error());
    const Result<Edit> edit = editTo(context);
    if (!edit)
        return refuse(edit.error());
    if (!drag_->refusal.isEmpty())
        context.hint({});
    drag_->refusal.clear();
    drag_->applied = true;
    context.document.apply(*edit, drag_->step, context.gesture);
    return ToolAnswer::keep;
}

ToolAnswer MoveControlPoint::release(const ToolContext& context, const ToolPointer&)
{
    const bool cameToNothing = !drag_->applied && !drag_->refusal.isEmpty();
    if (cameToNothing) {
        context.hint({});
        context.trouble(drag_->refusal);
    }
    if (!drag_->moved && drag_->alone)
        context.selection.setPoints(pointOf(context.document.scene(), drag_->point));
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
    context.selection.setPoints({});
    context.selection.setObjects(std::move(chosen));
}

void MoveControlPoint::cancel()
{
    drag_.reset();
}

}  // namespace knotspan
