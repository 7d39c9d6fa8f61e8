#include "ui/panels/snap_form.h"

#include <QCheckBox>
#include <QDoubleSpinBox>

namespace knotspan {

SnapForm::SnapForm(Document& document, Viewport& viewport, QWidget* parent)
    : ToolForm(document, viewport, tr("Snapping"), parent)
{
    points_ = check("snap-points", tr("To c&ontrol points"),
                    tr("Let a dragged control point jump to another one that the hand comes near"));
    knotLines_ = check("snap-knot-lines", tr("To knot &lines"),
                       tr("Let a dragged control point jump to knot lines of surfaces that do not move"));
    surfaces_ = check("snap-surfaces", tr("To s&urfaces"),
                      tr("Let a dragged control point jump to surfaces that do not move"));
    grid_ = check("snap-grid", tr("To the g&rid"),
                  tr("Let a dragged control point go by the grid's step along X, Y and Z"));
    step_ = number("grid-step", tr("Gr&id step"), tr("How far apart the grid's lines are"), {1e-4});
    begin();
}

void SnapForm::show(const ToolSettings& settings)
{
    const SnapSettings& snap = settings.snap;
    points_->setChecked(snap.points);
    knotLines_->setChecked(snap.knotLines);
    surfaces_->setChecked(snap.surfaces);
    grid_->setChecked(snap.grid);
    step_->setValue(snap.gridStep);
    step_->setEnabled(snap.grid);
    step_->setSuffix(units());
    step_->setSingleStep(stepLength());
}

void SnapForm::read(ToolSettings& settings) const
{
    SnapSettings& snap = settings.snap;
    snap.points = points_->isChecked();
    snap.knotLines = knotLines_->isChecked();
    snap.surfaces = surfaces_->isChecked();
    snap.grid = grid_->isChecked();
    snap.gridStep = step_->value();
}

}  // namespace knotspan
