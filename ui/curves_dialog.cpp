#include "ui/curves_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>

#include <glm/geometric.hpp>

#include "model/making/object_making.h"
#include "model/making/sweeps.h"
#include "ui/scene_additions.h"

namespace knotspan {

namespace {

const KnotVector& knotsAcross(const NurbsSurface& surface, Direction across)
{
    return across == Direction::U ? surface.knotsU() : surface.knotsV();
}

// From one end of the domain to the other, each knot once.
std::vector<double> knotLines(const KnotVector& knots)
{
    std::vector<double> lines;
    for (const int span : knots.spans())
        lines.push_back(knots[span]);
    lines.push_back(knots.domainEnd());
    return lines;
}

// Exactly the ends at 0 and 1.
double parameterAt(const KnotVector& knots, double part)
{
    const double parameter = knots.domainStart() + part * (knots.domainEnd() - knots.domainStart());
    return part <= 0 ? knots.domainStart() : part >= 1 ? knots.domainEnd() : parameter;
}

// A curve that runs against the one before it is turned round.
void alignTo(const NurbsCurve& before, NurbsCurve& curve)
{
    const auto start = [](const NurbsCurve& c) { return c.controlPoints().front().position; };
    const auto end = [](const NurbsCurve& c) { return c.controlPoints().back().position; };
    const double asItIs = glm::distance(start(before), start(curve)) + glm::distance(end(before), end(curve));
    const double turned = glm::distance(start(before), end(curve)) + glm::distance(end(before), start(curve));
    if (turned < asItIs)
        curve = reversed(curve);
}

}  // namespace

CurvesDialog::CurvesDialog(Document& document, Selection& selection, QWidget* parent)
    : MakingDialog(document, selection, tr("Surface from curves"), parent)
{
    setObjectName("curves-dialog");
    use_ = addChoice("use", tr("&What to do"), tr("What is made from the curves of the selected surfaces"),
                     {tr("Extrude along a vector"), tr("Revolve round an axis"), tr("Loft through curves")});
    along_ = addChoice("along", tr("Curves &along"), tr("Which way the curves run on their surface"),
                       {tr("U"), tr("V")});
    at_ =
        addNumber("at", tr("&Taken at"), tr("Where across the surface: 0 is one border, 1 the opposite one"));
    at_->setDecimals(4);
    at_->setRange(0, 1);
    at_->setSingleStep(0.05);
    vector_ = addVector("vector", tr("A&long"), tr("The vector that the curves are moved along"));
    point_ = addVector("point", tr("Th&rough"), tr("A point of the axis"));
    axis_ = addChoice("axis", tr("A&xis"), tr("The axis of the model that it is parallel to"),
                      {tr("X"), tr("Y"), tr("Z")});
    axis_->setCurrentIndex(2);
    degrees_ = addNumber("degrees", tr("An&gle"), tr("How far round, up to 360 degrees either way"));
    degrees_->setDecimals(4);
    degrees_->setSuffix(tr("°"));
    degrees_->setSingleStep(15);
    degrees_->setValue(360);
    closed_ = addSwitch("closed", tr("&Closed: back to the first curve"),
                        tr("Needs at least three curves; as smooth where it closes as elsewhere"));
    finishLayout();
    followSelection();
    connect(use_, &QComboBox::currentIndexChanged, this, &CurvesDialog::showWhatCounts);
    showWhatCounts();
}

CurveUse CurvesDialog::use() const
{
    return static_cast<CurveUse>(use_->currentIndex());
}

// Of the boxes, those that count for what is chosen.
void CurvesDialog::showWhatCounts()
{
    showRow(vector_, use() == CurveUse::extrude);
    showRow(point_, use() == CurveUse::revolve);
    showRow(axis_, use() == CurveUse::revolve);
    showRow(degrees_, use() == CurveUse::revolve);
    showRow(closed_, use() == CurveUse::loft);
}

// Once for each size of scene: what was typed stays.
void CurvesDialog::offerNumbers()
{
    const double size = sceneSize();
    if (size == offered_)
        return;
    offered_ = size;
    setValue(vector_, {0, 0, size});
}

Result<std::vector<NurbsCurve>> CurvesDialog::curves(const Selected& objects) const
{
    const Direction across = along_->currentIndex() == 0 ? Direction::V : Direction::U;
    const bool linesOfOne = use() == CurveUse::loft && objects.size() == 1;
    std::vector<NurbsCurve> list;
    for (const auto& [id, object] : objects) {
        const KnotVector& knots = knotsAcross(object->surface, across);
        const std::vector<double> parameters =
            linesOfOne ? knotLines(knots) : std::vector{parameterAt(knots, at_->value())};
        for (const double parameter : parameters) {
            Result<NurbsCurve> curve = isoCurveInModel(*object, across, parameter);
            if (!curve)
                return tl::unexpected(curve.error().at(object->name));
            if (!list.empty() && use() == CurveUse::loft)
                alignTo(list.back(), *curve);
            list.push_back(*std::move(curve));
        }
    }
    return list;
}

Result<std::vector<NurbsSurface>> CurvesDialog::surfaces(const std::vector<NurbsCurve>& curves) const
{
    std::vector<NurbsSurface> list;
    if (use() == CurveUse::loft) {
        Result<Loft> loft = lofted(curves, closed_->isChecked() ? LoftEnds::closed : LoftEnds::open);
        if (!loft)
            return tl::unexpected(loft.error());
        list.push_back(std::move(loft->surface));
        return list;
    }
    RevolvingAxis axis{valueOf(point_), Vec3(0)};
    axis.direction[axis_->currentIndex()] = 1;
    for (const NurbsCurve& curve : curves) {
        Result<NurbsSurface> swept = use() == CurveUse::extrude ? extruded(curve, valueOf(vector_))
                                                                : revolved(curve, axis, degrees_->value());
        if (!swept)
            return tl::unexpected(swept.error());
        list.push_back(*std::move(swept));
    }
    return list;
}

Making CurvesDialog::make() const
{
    const Selected objects = selectedObjects();
    if (objects.empty())
        return refusal(tr("Select the surfaces that the curves are taken from: click them in the viewport."));
    const Result<std::vector<NurbsCurve>> taken = curves(objects);
    if (!taken)
        return refusal(taken.error());
    Result<std::vector<NurbsSurface>> made = surfaces(*taken);
    if (!made)
        return refusal(made.error());
    const std::pair<QString, QString> words[] = {{tr("Extrusion"), tr("Extrude curves")},
                                                 {tr("Revolution"), tr("Revolve curves")},
                                                 {tr("Loft"), tr("Loft through curves")}};
    const auto& [name, step] = words[static_cast<size_t>(use())];
    SceneAdditions additions(scene());
    for (NurbsSurface& surface : *made)
        additions.addNamed(name, std::move(surface));
    Making making;
    making.edit = additions.edit();
    making.selected = additions.ids();
    making.step = step;
    const bool linesOfOne = use() == CurveUse::loft && objects.size() == 1;
    making.told =
        (linesOfOne ? tr("The curves are all knot lines of the one surface; select more to take one of "
                         "each.") +
                          "\n"
                    : QString()) +
        tr("Curves: %1. Surfaces made from them: %2, of %3 control points.")
            .arg(taken->size())
            .arg(made->size())
            .arg(additions.controlPointCount());
    return making;
}

}  // namespace knotspan
