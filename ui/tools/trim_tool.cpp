#include "ui/tools/trim_tool.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/sculpting/screen_selection.h"
#include "model/sculpting/surface_snapping.h"
#include "ui/tools/hand_strokes.h"
#include "ui/tools/steadiness.h"
#include "ui/tools/trim_sight.h"

namespace knotspan {

namespace {

constexpr size_t kFewest = 3;
constexpr double kClosingPx = 9;  // so near to the first point a click closes
constexpr int kStrokesPerPart = 12;

}  // namespace

void TrimTool::hover(const ToolContext& context, const ToolPointer& pointer)
{
    const Pick pick = context.pick(pointer.position);
    context.selection.setHoveredObject(pick.place ? std::optional(pick.place->object) : std::nullopt);
}

void TrimTool::leave(const ToolContext& context)
{
    context.selection.setHoveredObject(std::nullopt);
}

void TrimTool::cancel()
{
    corners_.clear();
    choice_.reset();
}

std::vector<Vec2> TrimTool::pixels() const
{
    std::vector<Vec2> result;
    for (const Corner& corner : corners_)
        result.push_back(corner.pixel);
    return result;
}

void TrimTool::hint(const ToolContext& context) const
{
    if (corners_.size() < kFewest)
        context.hint(
            QObject::tr(
                "Click points around what is to be trimmed. S: %1, Backspace: one point less, Escape: "
                "none")
                .arg(isSmooth_ ? QObject::tr("straight") : QObject::tr("smooth")));
    else
        context.hint(
            QObject::tr(
                "Click on, or close the curve: click the first point, click twice, or press Enter. S: %1")
                .arg(isSmooth_ ? QObject::tr("straight") : QObject::tr("smooth")));
}

void TrimTool::add(const ToolContext& context, const Vec2& pixel)
{
    Corner corner{pixel, {}, {}};
    const Pick pick = context.pick(pixel);
    const SharedObject object = pick.place ? context.document.scene().find(pick.place->object) : nullptr;
    if (object) {
        const SurfacePlace place = nearestFrom(pick.place->object, *object,
                                               {pick.place->spanU, pick.place->spanV}, pick.place->position);
        corner.object = place.object;
        corner.place = Vec2(place.u, place.v);
    }
    corners_.push_back(corner);
}

ToolAnswer TrimTool::press(const ToolContext& context, const ToolPointer& pointer)
{
    if (choice_) {
        move(context, pointer);
        if (!canTake())
            return ToolAnswer::stay;
        context.hint({});
        cancel();
        return ToolAnswer::commit;
    }
    if (corners_.empty()) {
        context.document.endPreview();
        context.selection.setHovered({});
    }
    pointer_ = pointer.position;
    const auto isAt = [&](const Corner& corner, double px) {
        return glm::distance(corner.pixel, pointer.position) <= px * context.pixelRatio;
    };
    if (corners_.size() >= kFewest &&
        (isAt(corners_.front(), kClosingPx) || isAt(corners_.back(), kStillPx))) {
        close(context);
        return ToolAnswer::stay;
    }
    if (corners_.empty() || !isAt(corners_.back(), kStillPx))
        add(context, pointer.position);
    hint(context);
    context.redraw();
    return corners_.size() == 1 ? ToolAnswer::keep : ToolAnswer::stay;
}

ToolAnswer TrimTool::move(const ToolContext& context, const ToolPointer& pointer)
{
    pointer_ = pointer.position;
    if (choice_)
        showSide(context,
                 Lasso(outline(pixels())).contains(pointer.position) ? KeptSide::inside : KeptSide::outside);
    context.redraw();
    return ToolAnswer::keep;
}

ToolAnswer TrimTool::key(const ToolContext& context, const QKeyEvent& event)
{
    switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (choice_) {
            if (!canTake())
                return ToolAnswer::stay;
            context.hint({});
            cancel();
            return ToolAnswer::commit;
        }
        close(context);
        return ToolAnswer::stay;
    case Qt::Key_Backspace:
        if (choice_) {
            Edit edit;
            edit.set(choice_->object, choice_->before);
            context.document.apply(edit, QObject::tr("Trim"), context.gesture);
            choice_.reset();
        } else {
            corners_.pop_back();
        }
        if (corners_.empty()) {
            context.hint({});
            return ToolAnswer::revert;
        }
        break;
    case Qt::Key_S:
        if (choice_)
            return ToolAnswer::stay;
        isSmooth_ = !isSmooth_;
        break;
    default:
        return ToolAnswer::pass;
    }
    hint(context);
    context.redraw();
    return ToolAnswer::stay;
}

PlaneCurve TrimTool::curveThrough(const std::vector<Vec2>& pixels) const
{
    return isSmooth_ ? closedSpline(pixels) : closedPolygon(pixels);
}

// As strokes: closed.
std::vector<Vec2> TrimTool::outline(std::vector<Vec2> pixels) const
{
    pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
    if (pixels.size() < kFewest || !isSmooth_)
        return pixels;
    std::vector<Vec2> result;
    const PlaneCurve curve = closedSpline(pixels);
    std::vector<double> ends = curve[0].breaks;
    ends.insert(ends.begin(), 0);
    ends.push_back(1);
    for (size_t k = 0; k + 1 < ends.size(); ++k)
        for (int s = 0; s < kStrokesPerPart; ++s)
            result.push_back(
                curve[0].at(std::lerp(ends[k], ends[k + 1], static_cast<double>(s) / kStrokesPerPart)));
    return result;
}

Result<TrimTool::Choice> TrimTool::choiceOf(const ToolContext& context) const
{
    // What is selected, where that is one surface; else what the first point on one took.
    const std::set<ObjectId>& chosen = context.selection.objects();
    const auto isOnChosen = [&](const Corner& c) {
        return c.place && chosen.size() == 1 && *chosen.begin() == c.object;
    };
    auto first = std::find_if(corners_.begin(), corners_.end(), isOnChosen);
    if (first == corners_.end())
        first = std::find_if(corners_.begin(), corners_.end(),
                             [](const Corner& c) { return c.place.has_value(); });
    if (first == corners_.end())
        return failure("None of the points lies on a surface", "Put at least one of them on it");
    Choice choice{
        .object = first->object, .before = context.document.scene().find(first->object), .loops = {}};
    if (!choice.before || choice.before->locked)
        return failure("The surface is gone or locked", "Press Escape and choose another");
    const SceneObject& object = *choice.before;
    std::vector<Vec2> order = pixels();
    std::rotate(order.begin(), order.begin() + (first - corners_.begin()), order.end());
    const Sight sight = sightOf(context.camera, context.width, context.height);
    const auto curve = projectedOnto(object.surface, {sight.toPlane, object.transform}, curveThrough(order),
                                     *first->place, trimTolerance(context.settings, object));
    if (!curve)
        return tl::unexpected(curve.error());
    choice.error = curve->error;
    for (const KeptSide side : {KeptSide::inside, KeptSide::outside})
        choice.loops[static_cast<size_t>(side)] =
            trimmedBy(curve->curves, object.trimLoops, object.surface, side);
    if (!choice.loops[0] && !choice.loops[1])
        return tl::unexpected(choice.loops[0].error());
    return choice;
}

void TrimTool::close(const ToolContext& context)
{
    if (corners_.size() < kFewest) {
        context.hint(QObject::tr("A closed curve has three points at least: click on"));
        return;
    }
    auto choice = choiceOf(context);
    if (!choice) {
        context.hint(QString::fromStdString(choice.error().sentence()));
        return;
    }
    choice_ = *std::move(choice);
    showSide(context,
             choice_->loops[static_cast<size_t>(KeptSide::outside)] ? KeptSide::outside : KeptSide::inside);
}

void TrimTool::showSide(const ToolContext& context, KeptSide side)
{
    if (choice_->shown == side)
        return;
    choice_->shown = side;
    const auto& loops = choice_->loops[static_cast<size_t>(side)];
    SharedObject shown = choice_->before;
    if (loops) {
        SceneObject trimmed = *choice_->before;
        trimmed.trimLoops = *loops;
        shown = std::make_shared<SceneObject>(std::move(trimmed));
    }
    Edit edit;
    edit.set(choice_->object, shown);
    context.document.apply(edit, QObject::tr("Trim"), context.gesture);
    if (loops)
        context.hint(
            QObject::tr(
                "Click the side that is to stay; Enter takes what is shown, Escape nothing. The curve "
                "follows the drawn one %1")
                .arg(nearnessText(choice_->error, *choice_->before, context.document.scene().units())));
    else
        context.hint(QString::fromStdString(loops.error().sentence()));
    context.redraw();
}

void TrimTool::show(const ToolContext& context, Overlays& overlays) const
{
    if (corners_.empty())
        return;
    std::vector<Vec2> points = pixels();
    if (!choice_)
        points.push_back(pointer_);
    const bool isClosed = choice_ || isSmooth_;
    addClosed(outline(std::move(points)), context.pixelRatio, isClosed ? 1 : 0.4F, overlays.strokes);
    if (choice_)
        return;
    const double half = 3 * context.pixelRatio;
    for (const Corner& corner : corners_)
        for (const double sign : {-1.0, 1.0}) {
            const Vec2 arm(half, sign * half);
            overlays.strokes.push_back(
                handStroke(corner.pixel - arm, corner.pixel + arm, context.pixelRatio));
        }
}

}  // namespace knotspan
