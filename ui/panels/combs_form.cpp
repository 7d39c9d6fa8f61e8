#include "ui/panels/combs_form.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>

#include "ui/tools/probe_texts.h"
#include "ui/viewport/described.h"

namespace knotspan {

CombsForm::CombsForm(const Document& document, Viewport& viewport, QWidget* parent)
    : QGroupBox(tr("Curvature combs"), parent),
      document_(document),
      viewport_(viewport)
{
    auto* form = new QFormLayout(this);
    shown_ = new QCheckBox(tr("On iso-curves of the &selected objects"), this);
    describe(
        shown_, "combs-shown", tr("Curvature combs on iso-curves of the selected objects"),
        tr("Show how iso-curves bend: a tooth is as long as the curve's curvature there, and points out of "
           "the bend"));
    curves_ = new QSpinBox(this);
    describe(curves_, "combs-curves", tr("Iso-curves each way"),
             tr("How many iso-curves have combs, along u and along v"));
    curves_->setRange(1, kMostCombCurves);
    longest_ = new QDoubleSpinBox(this);
    describe(longest_, "combs-longest", tr("How long the longest teeth are"),
             tr("How long the longest teeth are, of the model's size: about, since it goes in steps"));
    longest_->setRange(0.1, 200);
    longest_->setDecimals(1);
    longest_->setSuffix(tr(" %"));
    longest_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    strongest_ = new QLabel(this);
    describe(strongest_, "combs-strongest", tr("The strongest curvature of the combs"),
             tr("The strongest curvature of the combs, but for one tooth in a hundred, and its radius"));
    strongest_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    form->addRow(shown_);
    form->addRow(tr("C&urves each way"), curves_);
    form->addRow(tr("Longest &teeth"), longest_);
    form->addRow(tr("Strongest"), strongest_);
    takeOver();
    connect(shown_, &QCheckBox::toggled, this, &CombsForm::tell);
    connect(curves_, &QSpinBox::valueChanged, this, &CombsForm::tell);
    connect(longest_, &QDoubleSpinBox::valueChanged, this, &CombsForm::tell);
    connect(&viewport_.combs(), &ShownCombs::changed, this, &CombsForm::takeOver);
    connect(&viewport_, &Viewport::frameDrawn, this, &CombsForm::showStrongest);
}

void CombsForm::takeOver()
{
    const CombSettings& now = viewport_.combs().settings();
    const QSignalBlocker quietShown(shown_);
    const QSignalBlocker quietCurves(curves_);
    const QSignalBlocker quietLongest(longest_);
    shown_->setChecked(now.shown);
    curves_->setValue(now.curves);
    longest_->setValue(now.longestPercent);
    curves_->setEnabled(now.shown);
    longest_->setEnabled(now.shown);
    showStrongest();
}

void CombsForm::tell()
{
    viewport_.combs().setSettings({shown_->isChecked(), curves_->value(), longest_->value()});
}

void CombsForm::showStrongest()
{
    const ShownCombs& combs = viewport_.combs();
    const double strongest = combs.strongest();
    const QString units = QString::fromStdString(document_.scene().units());
    strongest_->setText(
        !combs.settings().shown || !(strongest > 0)
            ? tr("-")
            : tr("%1 1/%2, radius %3 %2").arg(measureFigure(strongest), units, measureFigure(1 / strongest)));
}

}  // namespace knotspan
