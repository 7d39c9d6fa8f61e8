#include "ui/points_dialog.h"

#include <QComboBox>
#include <QDoubleSpinBox>

#include "model/scene/control_point_editing.h"
#include "model/sculpting/twins.h"
#include "model/sculpting/weights.h"
#include "ui/tools/point_dragging.h"

namespace knotspan {

namespace {

enum class What { moveBy, moveTo, weigh };

// The mean of where they stand, in model space.
Vec3 middleOf(const Scene& scene, const PointSelection& points)
{
    Vec3 sum{0};
    for (const auto& [id, chosen] : points.objects())
        for (const ControlPointIndex index : chosen.points)
            sum += controlPointInModel(*scene.find(id), index);
    return sum / static_cast<double>(points.size());
}

}  // namespace

PointsDialog::PointsDialog(Document& document, Selection& selection, std::function<ToolSettings()> settings,
                           QWidget* parent)
    : MakingDialog(document, selection, tr("Control points by numbers"), parent),
      chosen_(selection),
      settings_(std::move(settings))
{
    setObjectName("points-dialog");
    what_ = addChoice("what", tr("&What to do"), tr("What is done to the selected control points"),
                      {tr("Move them by"), tr("Move their middle to"), tr("Set their weight")});
    place_ = addVector("place", tr("&X, Y, Z"), tr("In the model's coordinates"));
    weight_ = addNumber("weight", tr("W&eight"), tr("How much they draw the surface towards themselves"));
    weight_->setRange(kLeastWeight, kMostWeight);
    weight_->setValue(1);
    finishLayout();
    connect(what_, &QComboBox::currentIndexChanged, this, [this] {
        offerNumbers();
        showWhatCounts();
    });
    connect(&chosen_, &Selection::changed, this, [this] {
        if (chosen_.points() == seen_)
            return;
        seen_ = chosen_.points();
        offerNumbers();
        lookSoon();
    });
    showWhatCounts();
}

void PointsDialog::showWhatCounts()
{
    const bool weighs = static_cast<What>(what_->currentIndex()) == What::weigh;
    showRow(place_, !weighs);
    showRow(weight_, weighs);
}

// Where they are, so that nothing moves at first.
void PointsDialog::offerNumbers()
{
    seen_ = chosen_.points();
    PointSelection points = seen_;
    points.keepOnly(scene());
    if (points.isEmpty())
        return;
    const bool absolute = static_cast<What>(what_->currentIndex()) == What::moveTo;
    setValue(place_, absolute ? middleOf(scene(), points) : Vec3(0));
    offered_ = valueOf(place_);
    const auto& [id, chosen] = *points.objects().begin();
    const auto [i, j] = chosen.points.front();
    setQuietly(*weight_, scene().find(id)->surface.controlPoint(i, j).weight);
}

Making PointsDialog::make() const
{
    PointSelection points = chosen_.points();
    points.keepOnly(scene());
    if (points.isEmpty())
        return refusal(tr("Select control points: click one in the viewport, with Shift more."));
    Making making =
        static_cast<What>(what_->currentIndex()) == What::weigh ? weighing(points) : moving(points);
    making.selected = chosen_.objects();
    return making;
}

Making PointsDialog::moving(const PointSelection& chosen) const
{
    const bool absolute = static_cast<What>(what_->currentIndex()) == What::moveTo;
    Vec3 by = valueOf(place_);
    if (absolute) {
        const Vec3 middle = middleOf(scene(), chosen);
        for (int axis = 0; axis < 3; ++axis)  // a box that nobody touched shows too few digits
            by[axis] = by[axis] == offered_[axis] ? 0 : by[axis] - middle[axis];
    }
    auto points = movedPoints(scene(), chosen, settings_(), by);
    if (!points)
        return refusal(points.error());
    const auto count = static_cast<int>(chosen.size());
    Making making;
    making.edit = std::move(points->edit);
    making.step = count == 1 ? tr("Move control point") : tr("Move %1 control points").arg(count);
    const QString moved = count == 1 ? tr("Moves the selected control point")
                                     : tr("Moves the %1 selected control points").arg(count);
    const size_t following = points->following;
    making.told = following == 0 ? tr("%1.").arg(moved) : tr("%1; %2 follow.").arg(moved).arg(following);
    return making;
}

Making PointsDialog::weighing(const PointSelection& chosen) const
{
    auto edit = withWeights(scene(), withTwins(scene(), chosen), weight_->value());
    if (!edit)
        return refusal(edit.error());
    Making making;
    making.edit = *std::move(edit);
    making.step = tr("Set weights");
    making.told = chosen.size() == 1
                      ? tr("Sets the weight of the selected control point.")
                      : tr("Sets the weights of the %1 selected control points.").arg(chosen.size());
    return making;
}

}  // namespace knotspan
