#include "ui/tools/knot_insertion.h"

#include <algorithm>

#include "model/refining/object_refinement.h"

namespace knotspan {

namespace {

std::vector<Direction> directionsBy(Qt::KeyboardModifiers keys)
{
    if (keys.testFlag(Qt::ControlModifier))
        return {Direction::U, Direction::V};
    return {keys.testFlag(Qt::ShiftModifier) ? Direction::V : Direction::U};
}

double parameterOf(const SurfacePlace& place, Direction direction)
{
    return direction == Direction::U ? place.u : place.v;
}

}  // namespace

bool KnotInsertion::look(const ToolContext& context, const ToolPointer& pointer)
{
    const Pick pick = context.pick(pointer.position);
    const auto before = std::pair(place_, directions_);
    directions_ = directionsBy(pointer.modifiers);
    place_.reset();
    if (pick.place)
        if (const SharedObject object = context.document.scene().find(pick.place->object))
            place_ = nearestFrom(pick.place->object, *object, {pick.place->spanU, pick.place->spanV},
                                 pick.place->position);
    const auto isSame = [](const std::optional<SurfacePlace>& a, const std::optional<SurfacePlace>& b) {
        return a.has_value() == b.has_value() &&
               (!a || (a->object == b->object && a->u == b->u && a->v == b->v));
    };
    if (isSame(before.first, place_) && before.second == directions_)
        return place_.has_value();
    context.selection.setHoveredObject(place_ ? std::optional(place_->object) : std::nullopt);
    if (place_)
        context.hint(QObject::tr("Insert a knot at u = %1, v = %2: click for U, Shift for V, Ctrl for both")
                         .arg(place_->u)
                         .arg(place_->v));
    else
        context.hint({});
    context.redraw();
    return place_.has_value();
}

void KnotInsertion::hover(const ToolContext& context, const ToolPointer& pointer)
{
    look(context, pointer);
}

ToolAnswer KnotInsertion::press(const ToolContext& context, const ToolPointer& pointer)
{
    context.document.endPreview();
    return look(context, pointer) ? ToolAnswer::keep : ToolAnswer::pass;
}

// The line goes along while the button is down: the release counts.
ToolAnswer KnotInsertion::move(const ToolContext& context, const ToolPointer& pointer)
{
    look(context, pointer);
    return ToolAnswer::keep;
}

Result<SharedObject> KnotInsertion::withKnots(const SceneObject& object) const
{
    SceneObject changed = object;
    for (const Direction direction : directions_) {
        auto inserted =
            refined(changed, {.direction = direction, .parameter = parameterOf(*place_, direction)});
        if (!inserted)
            return tl::unexpected(inserted.error());
        changed = std::move(inserted->object);
    }
    return std::make_shared<SceneObject>(std::move(changed));
}

// What is lit is what comes.
ToolAnswer KnotInsertion::release(const ToolContext& context, const ToolPointer&)
{
    context.hint({});
    if (!place_ || !context.document.scene().find(place_->object))
        return ToolAnswer::revert;
    const auto object = withKnots(*context.document.scene().find(place_->object));
    if (!object) {
        context.trouble(QString::fromStdString(object.error().sentence()));
        return ToolAnswer::revert;
    }
    Edit edit;
    edit.set(place_->object, *object);
    const QString step = directions_.size() > 1                ? QObject::tr("Insert knots along U and V")
                         : directions_.front() == Direction::U ? QObject::tr("Insert a knot along U")
                                                               : QObject::tr("Insert a knot along V");
    context.document.apply(edit, step, context.gesture);
    return ToolAnswer::commit;
}

void KnotInsertion::leave(const ToolContext& context)
{
    place_.reset();
    context.hint({});
    context.redraw();
}

void KnotInsertion::show(const ToolContext& context, Overlays& overlays) const
{
    if (!place_ || !context.document.scene().find(place_->object))
        return;
    for (const Direction direction : directions_)
        overlays.isoLines.push_back(
            {.object = place_->object, .across = direction, .parameter = parameterOf(*place_, direction)});
}

}  // namespace knotspan
