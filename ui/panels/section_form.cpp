#include "ui/panels/section_form.h"

#include <algorithm>
#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

#include "ui/tools/probe_texts.h"
#include "ui/viewport/described.h"

namespace knotspan {

namespace {

constexpr int kSliderSteps = 1000;

}  // namespace

SectionForm::SectionForm(const Document& document, Viewport& viewport, QWidget* parent)
    : QGroupBox(tr("Section"), parent),
      document_(document),
      viewport_(viewport)
{
    auto* form = new QFormLayout(this);
    shown_ = new QCheckBox(tr("Cut the &visible surfaces with a plane"), this);
    describe(shown_, "section-shown", tr("Cut the visible surfaces with a plane"),
             tr("Show the curves in which a plane cuts the visible surfaces"));
    axis_ = new QComboBox(this);
    axis_->addItems({"x", "y", "z"});
    describe(axis_, "section-axis", tr("The axis that the plane is perpendicular to"),
             tr("The axis that the plane is perpendicular to"));
    offset_ = new QDoubleSpinBox(this);
    describe(offset_, "section-offset", tr("Where on the axis the plane is"),
             tr("Where on the axis the plane is"));
    offset_->setRange(-1e9, 1e9);
    offset_->setDecimals(4);
    offset_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    slider_ = new QSlider(Qt::Horizontal, this);
    slider_->setRange(0, kSliderSteps);
    describe(slider_, "section-slider", tr("Move the plane through the model"),
             tr("Move the plane through the model"));
    length_ = new QLabel(this);
    describe(length_, "section-length", tr("Length of the section's curves"),
             tr("How many curves there are, and how long they are together"));
    length_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    form->addRow(shown_);
    form->addRow(tr("Perpendicular &to"), axis_);
    form->addRow(tr("&At"), offset_);
    form->addRow(slider_);
    form->addRow(tr("Curves"), length_);
    takeOver();
    connect(shown_, &QCheckBox::toggled, this, &SectionForm::tell);
    connect(axis_, &QComboBox::currentIndexChanged, this, &SectionForm::tell);
    connect(offset_, &QDoubleSpinBox::valueChanged, this, &SectionForm::tell);
    connect(slider_, &QSlider::valueChanged, this, &SectionForm::slide);
    connect(&viewport_.section(), &ShownSection::changed, this, &SectionForm::takeOver);
    connect(&document_, &Document::documentReplaced, this, &SectionForm::takeOver);
    connect(&viewport_, &Viewport::frameDrawn, this, &SectionForm::showLength);
}

std::pair<double, double> SectionForm::extent() const
{
    const Box box = document_.scene().bounds();
    const int axis = axis_->currentIndex();
    return box.isEmpty() ? std::pair(0.0, 0.0) : std::pair(box.low[axis], box.high[axis]);
}

void SectionForm::takeOver()
{
    const SectionSettings& now = viewport_.section().settings();
    const QSignalBlocker quietShown(shown_);
    const QSignalBlocker quietAxis(axis_);
    const QSignalBlocker quietOffset(offset_);
    const QSignalBlocker quietSlider(slider_);
    shown_->setChecked(now.shown);
    axis_->setCurrentIndex(now.axis);
    offset_->setValue(now.offset);
    offset_->setSuffix(" " + QString::fromStdString(document_.scene().units()));
    const auto [low, high] = extent();
    if (high > low)
        slider_->setValue(static_cast<int>(
            std::lround(kSliderSteps * std::clamp((now.offset - low) / (high - low), 0.0, 1.0))));
    for (QWidget* box : std::initializer_list<QWidget*>{axis_, offset_, slider_})
        box->setEnabled(now.shown);
    showLength();
}

void SectionForm::tell()
{
    viewport_.section().setSettings({shown_->isChecked(), axis_->currentIndex(), offset_->value()});
}

void SectionForm::slide(int position)
{
    const auto [low, high] = extent();
    offset_->setValue(low + (high - low) * position / kSliderSteps);
}

void SectionForm::showLength()
{
    const ShownSection& section = viewport_.section();
    const QString units = QString::fromStdString(document_.scene().units());
    length_->setText(!section.settings().shown ? tr("-")
                     : !section.isComplete()   ? tr("cutting")
                     : section.curves() == 0   ? tr("none")
                                               : tr("%L1, together %2 %3 long")
                                                   .arg(section.curves())
                                                   .arg(measureFigure(section.length()), units));
}

}  // namespace knotspan
