#include "ui/tools/choosing.h"

namespace knotspan {

namespace {

std::optional<ObjectId> takenObject(const ToolContext& context, const Pick& pick)
{
    return context.settings.filter.objects ? pick.object() : std::nullopt;
}

}  // namespace

Choosing choosingBy(Qt::KeyboardModifiers keys)
{
    return keys.testFlag(Qt::ControlModifier) ? Choosing::toggling
           : keys.testFlag(Qt::ShiftModifier) ? Choosing::adding
                                              : Choosing::alone;
}

void choosePoints(Selection& selection, const PointSelection& points, Choosing how)
{
    PointSelection chosen = how == Choosing::alone ? PointSelection() : selection.points();
    if (how == Choosing::toggling)
        chosen.toggle(points);
    else
        chosen.add(points);
    selection.setPoints(std::move(chosen));
}

void chooseObjects(Selection& selection, const std::set<ObjectId>& objects, Choosing how)
{
    std::set<ObjectId> chosen;
    if (how != Choosing::alone)
        chosen = selection.objects();
    for (const ObjectId id : objects)
        if (how != Choosing::toggling || chosen.erase(id) == 0)
            chosen.insert(id);
    if (how == Choosing::alone)
        selection.setPoints({});
    selection.setObjects(std::move(chosen));
}

std::optional<ScenePoint> takenPoint(const ToolContext& context, const Pick& pick)
{
    if (!context.settings.filter.points || !pick.controlPoint)
        return std::nullopt;
    return ScenePoint{pick.controlPoint->object, pick.controlPoint->index};
}

void chooseAt(const ToolContext& context, const ToolPointer& pointer)
{
    const Pick pick = context.pick(pointer.position);
    const Choosing how = choosingBy(pointer.modifiers);
    if (const auto point = takenPoint(context, pick)) {
        if (how == Choosing::alone)
            context.selection.setObjects({point->object});
        choosePoints(context.selection, pointOf(context.document.scene(), *point), how);
        return;
    }
    std::set<ObjectId> objects;
    if (const auto object = takenObject(context, pick))
        objects.insert(*object);
    chooseObjects(context.selection, objects, how);
}

void hoverAt(const ToolContext& context, const ToolPointer& pointer)
{
    const Pick pick = context.pick(pointer.position);
    if (takenPoint(context, pick))
        context.selection.setHovered(pick.controlPoint);
    else
        context.selection.setHoveredObject(takenObject(context, pick));
}

}  // namespace knotspan
