#include "ui/tools/weight_drag.h"

#include <algorithm>
#include <cmath>

#include "model/sculpting/twins.h"
#include "ui/tools/choosing.h"
#include "ui/tools/steadiness.h"

namespace knotspan {

namespace {

constexpr double kPixelsPerE = 100;

double weightOf(const Scene& scene, const ScenePoint& point)
{
    return scene.find(point.object)->surface.controlPoint(point.index.i, point.index.j).weight;
}

}  // namespace

void WeightDrag::hover(const ToolContext& context, const ToolPointer& pointer)
{
    hoverAt(context, pointer);
}

ToolAnswer WeightDrag::press(const ToolContext& context, const ToolPointer& pointer)
{
    const auto point = takenPoint(context, context.pick(pointer.position));
    if (!point)
        return ToolAnswer::pass;
    context.document.endPreview();
    const Scene& scene = context.document.scene();
    const Choosing how = choosingBy(pointer.modifiers);
    if (how != Choosing::alone || !context.selection.points().contains(*point)) {
        if (how == Choosing::alone)
            context.selection.setObjects({point->object});
        choosePoints(context.selection, pointOf(scene, *point), how);
    }
    if (!context.selection.points().contains(*point))
        return ToolAnswer::commit;  // taken out
    const PointSelection chosen = withTwins(scene, context.selection.points());
    drag_ = Drag{scene, *point, chosen, factorRange(scene, chosen), 0, pointer.position.y, false};
    QString hint = QObject::tr("Weight %1: drag up or down").arg(weightOf(scene, *point));
    if (context.settings.keepFriends)
        hint += QObject::tr("; friends do not follow weights");
    context.hint(hint);
    return ToolAnswer::keep;
}

ToolAnswer WeightDrag::move(const ToolContext& context, const ToolPointer& pointer)
{
    const double share = pointer.modifiers.testFlag(Qt::ShiftModifier) ? kFine : 1;
    if (!drag_->hasMoved && std::abs(pointer.position.y - drag_->last) < kStillPx * context.pixelRatio)
        return ToolAnswer::keep;
    drag_->hasMoved = true;
    drag_->way += share * (drag_->last - pointer.position.y) / context.pixelRatio;
    drag_->last = pointer.position.y;
    if (drag_->range.low > drag_->range.high) {
        context.hint(QObject::tr("The selected weights differ too much to be scaled: set them by numbers"));
        return ToolAnswer::keep;
    }
    const double factor = std::clamp(std::exp(drag_->way / kPixelsPerE), drag_->range.low, drag_->range.high);
    const auto scaled = withWeightsScaled(drag_->start, drag_->chosen, factor);
    if (!scaled) {
        context.hint(QString::fromStdString(scaled.error().sentence()));
        return ToolAnswer::keep;
    }
    Scene wanted = drag_->start;
    Edit(*scaled).applyTo(wanted);
    Edit edit;  // also where it says nothing: back to the start
    for (const auto& [id, points] : drag_->chosen.objects())
        edit.set(id, wanted.find(id));
    const size_t count = context.selection.points().size();
    context.document.apply(edit,
                           count == 1 ? QObject::tr("Change a weight")
                                      : QObject::tr("Change %1 weights").arg(static_cast<qulonglong>(count)),
                           context.gesture);
    context.hint(QObject::tr("Weight %1").arg(weightOf(wanted, drag_->point)));
    return ToolAnswer::keep;
}

ToolAnswer WeightDrag::release(const ToolContext& context, const ToolPointer&)
{
    drag_.reset();
    context.hint({});
    return ToolAnswer::commit;
}

void WeightDrag::click(const ToolContext& context, const ToolPointer& pointer)
{
    chooseAt(context, pointer);
}

}  // namespace knotspan
