#include "ui/panels/deviation_form.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "ui/panels/ramp_legend.h"
#include "ui/tools/probe_texts.h"
#include "ui/viewport/described.h"
#include "ui/viewport/number_box.h"

namespace knotspan {

DeviationForm::DeviationForm(const Document& document, const Selection& selection, Viewport& viewport,
                             QWidget* parent)
    : QGroupBox(tr("Deviation"), parent),
      document_(document),
      selection_(selection),
      viewport_(viewport)
{
    auto* form = new QFormLayout(this);
    shown_ = new QCheckBox(tr("&Colour surfaces by their distance"), this);
    describe(shown_, "deviation-shown", tr("Colour surfaces by their distance from a reference"),
             tr("The shading deviation: blue where a surface is nearest to the reference, orange where it is "
                "furthest from it"));
    form->addRow(shown_);
    form->addRow(tr("Measured"),
                 addSide("deviation-measured", tr("Measured"),
                         tr("Measure the surfaces that are selected; with nothing selected all but the "
                            "reference"),
                         measured_, &DeviationSettings::measured));
    form->addRow(tr("Reference"),
                 addSide("deviation-reference", tr("Reference"),
                         tr("Measure from the surfaces and meshes that are selected; with nothing selected "
                            "from all others"),
                         reference_, &DeviationSettings::reference));
    form->addRow(tr("Largest"), largest_ = addFigure("deviation-largest", tr("The largest distance"),
                                                     tr("Of all points, and within what it is proved")));
    form->addRow(tr("At"), place_ = addFigure("deviation-place", tr("Where it is"), tr("Where it is")));
    form->addRow(tr("Mean"), mean_ = addFigure("deviation-mean", tr("The mean distance"),
                                               tr("The mean over the measured surfaces' area")));
    form->addRow(tr("Colours"),
                 colours_ = addFigure("deviation-accuracy", tr("How true the colours are"),
                                      tr("How far a colour's distance may be off, about: measured between "
                                         "the places where it is known")));
    makeRange();
    takeOver();
    connect(shown_, &QCheckBox::toggled, &viewport_, &Viewport::showDeviation);
    connect(&viewport_.deviation(), &ShownDeviation::changed, this, &DeviationForm::takeOver);
    connect(&viewport_, &Viewport::frameChanged, this, &DeviationForm::takeOver);
    connect(&viewport_, &Viewport::frameDrawn, this, &DeviationForm::showRamp);
}

QWidget* DeviationForm::addSide(const char* id, const QString& title, const QString& tip, QLabel*& label,
                                std::set<ObjectId> DeviationSettings::*side)
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    label = addFigure(id, title, tip);
    auto* take = new QPushButton(tr("Take selected"), row);
    describe(take, (QByteArray(id) + "-take").constData(), tr("%1: take what is selected").arg(title), tip);
    layout->addWidget(label, 1);
    layout->addWidget(take);
    connect(take, &QPushButton::clicked, this, [this, side] {
        DeviationSettings settings = viewport_.deviation().settings();
        settings.*side = selection_.objects();
        if (side == &DeviationSettings::reference)
            settings.reference.insert(selection_.meshes().begin(), selection_.meshes().end());
        viewport_.deviation().setSettings(settings);
    });
    return row;
}

QLabel* DeviationForm::addFigure(const char* id, const QString& name, const QString& tip)
{
    auto* label = new QLabel(this);
    describe(label, id, name, tip);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    return label;
}

void DeviationForm::makeRange()
{
    auto* form = static_cast<QFormLayout*>(layout());
    automatic_ = new QCheckBox(tr("&Range up to the largest"), this);
    describe(automatic_, "deviation-automatic", tr("Range up to the largest"),
             tr("Colours go from no distance to the largest; without, between what stands below"));
    form->addRow(automatic_);
    const auto number = [&](const char* id, const QString& name, const QString& tip) {
        auto* box = new NumberBox(this);
        describe(box, id, name, tip);
        box->setRange(0, 1e9);
        box->setDecimals(9);
        box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        box->setKeyboardTracking(false);
        form->addRow(name, box);
        connect(box, &QDoubleSpinBox::valueChanged, this, &DeviationForm::tellRange);
        return box;
    };
    low_ = number("deviation-low", tr("From"), tr("Blue is this distance or less"));
    high_ = number("deviation-high", tr("To"), tr("Orange is this distance or more"));
    legend_ = new RampLegend(this);
    legend_->setObjectName("deviation-legend");
    form->addRow(legend_);
    connect(automatic_, &QCheckBox::toggled, this, &DeviationForm::tellRange);
}

void DeviationForm::takeOver()
{
    const bool on = viewport_.frame().shading == Shading::deviation;
    const auto& range = viewport_.frame().look.deviationRange;
    isShowing_ = true;
    const QSignalBlocker quietShown(shown_);
    shown_->setChecked(on);
    automatic_->setChecked(!range);
    for (NumberBox* box : {low_, high_})
        box->setEnabled(on && range);
    if (range) {
        low_->setValue(range->low);
        high_->setValue(range->high);
    }
    isShowing_ = false;
    legend_->setVisible(on);
    showSides();
    showFigures();
}

void DeviationForm::showSides()
{
    const DeviationSettings& settings = viewport_.deviation().settings();
    const auto text = [&](const std::set<ObjectId>& ids, const QString& none) {
        if (ids.empty())
            return none;
        const SharedObject only = document_.scene().find(*ids.begin());
        return ids.size() == 1 && only && !only->name.empty()
                   ? QString::fromStdString(only->name)
                   : tr("%Ln object(s)", nullptr, static_cast<int>(ids.size()));
    };
    measured_->setText(
        text(settings.measured, settings.reference.empty() ? tr("all surfaces") : tr("all others")));
    reference_->setText(
        text(settings.reference, settings.measured.empty() ? tr("all meshes") : tr("all others")));
}

void DeviationForm::showFigures()
{
    const ShownDeviation& deviation = viewport_.deviation();
    const DeviationMap* const map = deviation.map();
    for (QLabel* label : {largest_, mean_, place_, colours_})
        label->setText(tr("-"));
    if (viewport_.frame().shading != Shading::deviation)
        return;
    if (map == nullptr) {
        const QString failure = deviation.failure();
        largest_->setText(failure.isEmpty() ? tr("measuring") : failure);
        largest_->setWordWrap(!failure.isEmpty());
        return;
    }
    largest_->setWordWrap(false);
    const QString units = QString::fromStdString(document_.scene().units());
    const MeshDistance& found = map->figures;
    const auto about = [](double value) { return QString::number(value, 'g', 1); };
    largest_->setText(tr("%1 %2 (± %3)").arg(measureFigure(found.largest), units, about(map->uncertainty())));
    place_->setText(vectorText(found.at, document_.scene().bounds().diagonal()));
    mean_->setText(tr("%1 %2").arg(measureFigure(found.mean), units));
    colours_->setText(tr("within about %1 %2").arg(about(map->accuracy), units));
}

void DeviationForm::showRamp(const FrameStats& stats)
{
    if (viewport_.frame().shading != Shading::deviation || !stats.rampLow || !stats.rampHigh)
        return;
    const NumberRange range{*stats.rampLow, *stats.rampHigh};
    legend_->show(range, ' ' + QString::fromStdString(document_.scene().units()));
    if (viewport_.frame().look.deviationRange)
        return;
    isShowing_ = true;  // where setting a range starts from
    low_->setValue(range.low);
    high_->setValue(range.high);
    isShowing_ = false;
}

void DeviationForm::tellRange()
{
    if (isShowing_)
        return;
    Frame frame = viewport_.frame();
    auto& range = frame.look.deviationRange;
    if (automatic_->isChecked())
        range.reset();
    else if (low_->value() < high_->value())
        range = NumberRange{low_->value(), high_->value()};
    else if (!range)
        range = NumberRange{0, 1};  // nothing is measured yet
    viewport_.setFrame(frame);      // numbers that are no range go back
}

}  // namespace knotspan
