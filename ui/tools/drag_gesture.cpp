#include "ui/tools/drag_gesture.h"

#include <glm/geometric.hpp>

#include "ui/tools/edit_checks.h"
#include "ui/tools/steadiness.h"

namespace knotspan {

namespace {

std::optional<DragAxis> axisOf(int key)
{
    switch (key) {
    case Qt::Key_X:
        return DragAxis::x;
    case Qt::Key_Y:
        return DragAxis::y;
    case Qt::Key_Z:
        return DragAxis::z;
    case Qt::Key_U:
        return DragAxis::u;
    case Qt::Key_V:
        return DragAxis::v;
    case Qt::Key_N:
        return DragAxis::normal;
    default:
        return std::nullopt;
    }
}

// 0 where the key writes nothing that we know.
char signOf(const QKeyEvent& event)
{
    const QString text = event.text();
    return text.size() == 1 ? text.front().toLatin1() : '\0';
}

}  // namespace

DragGesture::DragGesture(std::unique_ptr<Dragging> dragging, const Vec2& pressed)
    : dragging_(std::move(dragging)),
      pressed_(pressed),
      last_(pressed)
{
}

void DragGesture::move(const ToolContext& context, const ToolPointer& pointer)
{
    if (!hasMoved_ && glm::length(pointer.position - pressed_) < kStillPx * context.pixelRatio)
        return;
    hasMoved_ = true;
    const Vec2 by = pointer.position - last_;
    last_ = pointer.position;
    if (!typed_.isEmpty())
        return;
    way_ += (pointer.modifiers.testFlag(Qt::ShiftModifier) ? kFine : 1) * by;
    follow(context);
}

Result<Edit> DragGesture::wanted(const ToolContext& context)
{
    if (!isReady_)
        if (const auto begun = dragging_->begin(context); !begun)
            return tl::unexpected(begun.error());
    isReady_ = true;
    if (typed_.isEmpty())
        return dragging_->byHand(context, way_);
    const auto numbers = typed_.numbers();
    if (!numbers)
        return tl::unexpected(numbers.error());
    return dragging_->byNumbers(context, *numbers);
}

void DragGesture::follow(const ToolContext& context)
{
    Result<Edit> edit = wanted(context);
    if (edit)
        if (const auto allowed = leavesLockedAlone(context.document.scene(), *edit); !allowed)
            edit = tl::unexpected(allowed.error());
    if (!edit)
        return refuse(context, edit.error());
    accept(context);
    // A first edit that changes nothing is no step.
    if (isApplied_ || changes(context.document.scene(), *edit)) {
        isApplied_ = true;
        context.document.apply(*edit, dragging_->step(), context.gesture);
    }
    context.redraw();
}

void DragGesture::refuse(const ToolContext& context, const Error& error)
{
    const QString refusal = QString::fromStdString(error.sentence());
    if (refusal != refusal_)
        context.hint(refusal);
    isHinting_ = true;
    refusal_ = refusal;
    context.redraw();
}

void DragGesture::accept(const ToolContext& context)
{
    refusal_.clear();
    gizmoMoved_ = dragging_->gizmoMoved();
    if (!typed_.isEmpty()) {
        QString text = QString::fromStdString(typed_.text()).trimmed();
        // A comma may mean a decimal to who types it: several numbers are told as they were understood.
        if (const auto numbers = typed_.numbers(); numbers && numbers->values.size() > 1) {
            QStringList parts;
            for (const double value : numbers->values)
                parts += QString::number(value);
            text = (numbers->absolute ? "=" : "") + parts.join(" | ");
        }
        context.hint(QObject::tr("%1: %2%3 - Enter to take it, Escape to leave it")
                         .arg(dragging_->manner(), text, dragging_->unit(context.document.scene())));
    } else if (isHinting_) {
        context.hint({});
    }
    isHinting_ = !typed_.isEmpty();
}

void DragGesture::choose(const ToolContext& context, DragAxis axis)
{
    const DragAxis wish = axis == dragging_->axis() ? DragAxis::free : axis;
    if (const auto chosen = dragging_->choose(wish); !chosen) {
        context.hint(QString::fromStdString(chosen.error().sentence()));
        isHinting_ = true;
        return;
    }
    if (isReady_ || !typed_.isEmpty() || hasMoved_)
        follow(context);
    if (typed_.isEmpty() && refusal_.isEmpty()) {
        context.hint(QObject::tr("%1: go on with the hand, or type numbers").arg(dragging_->manner()));
        isHinting_ = true;
    }
    context.redraw();
}

ToolAnswer DragGesture::key(const ToolContext& context, const QKeyEvent& event)
{
    if ((event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0)
        return ToolAnswer::pass;
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)
        return take(context);
    if (const auto axis = axisOf(event.key())) {
        if (!event.isAutoRepeat())
            choose(context, *axis);
        return ToolAnswer::keep;
    }
    const bool isChanged = event.key() == Qt::Key_Backspace ? typed_.erase() : typed_.type(signOf(event));
    if (!isChanged)
        return ToolAnswer::pass;
    hasMoved_ = true;
    follow(context);
    return ToolAnswer::keep;
}

// Enter.
ToolAnswer DragGesture::take(const ToolContext& context)
{
    if (!refusal_.isEmpty()) {
        context.hint(refusal_);
        return ToolAnswer::keep;
    }
    context.hint({});
    return ToolAnswer::commit;
}

ToolAnswer DragGesture::release(const ToolContext& context)
{
    if (isHinting_)
        context.hint({});
    if (refusal_.isEmpty() || (isApplied_ && typed_.isEmpty()))
        return ToolAnswer::commit;
    context.trouble(refusal_);
    return ToolAnswer::revert;
}

}  // namespace knotspan
