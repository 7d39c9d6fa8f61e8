#include "ui/panels/look_form.h"

#include <array>

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QSpinBox>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/panels/ramp_legend.h"
#include "ui/viewport/described.h"
#include "ui/viewport/number_box.h"

namespace knotspan {

namespace {

enum Page { kNothing, kStripes, kMatcap, kCurvature, kDraft, kChecker };

Page pageOf(Shading shading)
{
    switch (shading) {
    case Shading::zebra:
    case Shading::reflection:
    case Shading::isophotes:
        return kStripes;
    case Shading::matcap:
        return kMatcap;
    case Shading::curvature:
        return kCurvature;
    case Shading::draft:
        return kDraft;
    case Shading::checker:
        return kChecker;
    default:
        return kNothing;
    }
}

const std::array<std::pair<const char*, Vec3>, 6> kPulls = {{{"+z", {0, 0, 1}},
                                                             {"-z", {0, 0, -1}},
                                                             {"+x", {1, 0, 0}},
                                                             {"-x", {-1, 0, 0}},
                                                             {"+y", {0, 1, 0}},
                                                             {"-y", {0, -1, 0}}}};

QString text(const std::string& utf8)
{
    return QString::fromStdString(utf8);
}

template <class Info>
void fill(QComboBox* box, const std::vector<Info>& list)
{
    for (const Info& info : list) {
        box->addItem(text(info.name), static_cast<int>(info.id));
        box->setItemData(box->count() - 1, text(info.description), Qt::ToolTipRole);
    }
}

}  // namespace

LookForm::LookForm(Viewport& viewport, QWidget* parent) : QWidget(parent), viewport_(viewport)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    pages_ = new QStackedWidget(this);
    layout->addWidget(pages_);
    legend_ = new RampLegend(this);
    layout->addWidget(legend_);
    addPage();
    makeStripes();
    makeMatcap();
    makeCurvature();
    makeDraft();
    makeChecker();
    connect(&viewport_, &Viewport::frameChanged, this, &LookForm::showFrame);
    connect(&viewport_, &Viewport::frameDrawn, this, &LookForm::showRamp);
    showFrame();
}

QFormLayout* LookForm::addPage()
{
    auto* page = new QWidget(pages_);
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 0, 0, 0);
    pages_->addWidget(page);
    return form;
}

void LookForm::makeStripes()
{
    QFormLayout* form = addPage();
    stripes_ = new QSpinBox(this);
    describe(stripes_, "look-stripes", tr("Stripes"),
             tr("Over half a turn of the normal or of what it mirrors: more are narrower"));
    stripes_->setRange(1, kMostStripes);
    angle_ = new QSpinBox(this);
    describe(angle_, "look-stripe-angle", tr("Turned by"),
             tr("How far the stripes are turned in the picture"));
    angle_->setRange(0, 179);
    angle_->setWrapping(true);
    angle_->setSingleStep(15);
    angle_->setSuffix(tr("°"));
    form->addRow(tr("Stripes"), stripes_);
    form->addRow(tr("Turned by"), angle_);
    connect(stripes_, &QSpinBox::valueChanged, this, &LookForm::tell);
    connect(angle_, &QSpinBox::valueChanged, this, &LookForm::tell);
}

void LookForm::makeMatcap()
{
    matcap_ = new QComboBox(this);
    describe(matcap_, "look-matcap", tr("Material"), tr("What the surfaces seem to be made of"));
    fill(matcap_, matcaps());
    addPage()->addRow(tr("Material"), matcap_);
    connect(matcap_, &QComboBox::activated, this, &LookForm::tell);
}

void LookForm::makeCurvature()
{
    QFormLayout* form = addPage();
    curvature_ = new QComboBox(this);
    describe(curvature_, "look-curvature", tr("Curvature"), tr("Which figure the colours show"));
    fill(curvature_, curvatureKinds());
    automatic_ = new QCheckBox(tr("Range by the model"), this);
    describe(automatic_, "look-automatic", tr("Range by the model"),
             tr("Colours span what nearly all of the model has; without, what stands below"));
    form->addRow(tr("Curvature"), curvature_);
    form->addRow(automatic_);
    const auto number = [&](const char* id, const QString& name, const QString& tip) {
        auto* box = new NumberBox(this);
        describe(box, id, name, tip);
        box->setRange(-1e9, 1e9);
        box->setDecimals(9);
        box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        box->setKeyboardTracking(false);
        form->addRow(name, box);
        connect(box, &QDoubleSpinBox::valueChanged, this, &LookForm::tell);
        return box;
    };
    low_ = number("look-low", tr("From"), tr("Blue is this much, 1 per unit of length (gauss: its square)"));
    high_ = number("look-high", tr("To"), tr("Orange is this much"));
    connect(curvature_, &QComboBox::activated, this, &LookForm::tell);
    connect(automatic_, &QCheckBox::toggled, this, &LookForm::tell);
}

void LookForm::makeDraft()
{
    QFormLayout* form = addPage();
    pull_ = new QComboBox(this);
    describe(pull_, "look-pull", tr("Pulled along"), tr("The direction in which a mould is taken off"));
    for (const auto& [name, direction] : kPulls)
        pull_->addItem(QLatin1String(name));
    draft_ = new QDoubleSpinBox(this);
    describe(draft_, "look-draft", tr("Draft"), tr("The angle that has the full colour"));
    draft_->setRange(0.1, 90);
    draft_->setDecimals(1);
    draft_->setSuffix(tr("°"));
    form->addRow(tr("Pulled along"), pull_);
    form->addRow(tr("Draft"), draft_);
    connect(pull_, &QComboBox::activated, this, &LookForm::tell);
    connect(draft_, &QDoubleSpinBox::valueChanged, this, &LookForm::tell);
}

void LookForm::makeChecker()
{
    QFormLayout* form = addPage();
    checker_ = new QComboBox(this);
    describe(checker_, "look-checker", tr("Squares of one"), tr("In what the squares are equal"));
    fill(checker_, checkers());
    squares_ = new QSpinBox(this);
    describe(squares_, "look-squares", tr("Along each"), tr("Squares along each parameter"));
    squares_->setRange(1, kMostCheckerCells);
    squareLength_ = new NumberBox(this);
    describe(squareLength_, "look-square-length", tr("Length"),
             tr("How long a square is; 0: a round length that suits the model"));
    squareLength_->setRange(0, 1e9);
    squareLength_->setDecimals(6);
    squareLength_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    squareLength_->setSpecialValueText(tr("by the model"));
    squareLength_->setKeyboardTracking(false);
    form->addRow(tr("Squares of one"), checker_);
    form->addRow(tr("Along each"), squares_);
    form->addRow(tr("Length"), squareLength_);
    connect(checker_, &QComboBox::activated, this, &LookForm::tell);
    connect(squares_, &QSpinBox::valueChanged, this, &LookForm::tell);
    connect(squareLength_, &QDoubleSpinBox::valueChanged, this, &LookForm::tell);
}

void LookForm::showFrame()
{
    const Frame& frame = viewport_.frame();
    const Look& look = frame.look;
    isShowing_ = true;
    const Page page = pageOf(frame.shading);
    pages_->setCurrentIndex(page);
    pages_->setMaximumHeight(pages_->currentWidget()->sizeHint().height());
    const bool isRamp = page == kCurvature || page == kDraft || frame.shading == Shading::deviation;
    pages_->setVisible(page != kNothing);
    setVisible(page != kNothing || isRamp);
    legend_->setVisible(isRamp);
    stripes_->setValue(look.stripes);
    angle_->setValue(static_cast<int>(look.stripesTurnedDegrees));
    matcap_->setCurrentIndex(matcap_->findData(static_cast<int>(look.matcap)));
    curvature_->setCurrentIndex(curvature_->findData(static_cast<int>(look.curvature)));
    automatic_->setChecked(!look.curvatureRange);
    for (NumberBox* box : {low_, high_})
        box->setEnabled(look.curvatureRange.has_value());
    if (look.curvatureRange) {
        low_->setValue(look.curvatureRange->low);
        high_->setValue(look.curvatureRange->high);
    }
    for (size_t k = 0; k < kPulls.size(); ++k)
        if (kPulls[k].second == look.pull)
            pull_->setCurrentIndex(static_cast<int>(k));
    draft_->setValue(look.draftDegrees);
    checker_->setCurrentIndex(checker_->findData(static_cast<int>(look.checker)));
    squares_->setValue(look.checkerCells);
    squares_->setEnabled(look.checker == CheckerBy::parameter);
    squareLength_->setValue(look.checkerLength.value_or(0));
    squareLength_->setEnabled(look.checker == CheckerBy::length);
    isShowing_ = false;
}

void LookForm::showRamp(const FrameStats& stats)
{
    if (!stats.rampLow || !stats.rampHigh)
        return;
    const NumberRange range{*stats.rampLow, *stats.rampHigh};
    const bool draft = viewport_.frame().shading == Shading::draft;
    legend_->show(range, draft ? tr("°") : QString());
    if (viewport_.frame().shading != Shading::curvature || viewport_.frame().look.curvatureRange)
        return;
    isShowing_ = true;  // where setting a range starts from
    low_->setValue(range.low);
    high_->setValue(range.high);
    isShowing_ = false;
}

void LookForm::tell()
{
    if (isShowing_)
        return;
    Frame frame = viewport_.frame();
    Look& look = frame.look;
    look.stripes = stripes_->value();
    look.stripesTurnedDegrees = angle_->value();
    look.matcap = static_cast<Matcap>(matcap_->currentData().toInt());
    look.curvature = static_cast<CurvatureKind>(curvature_->currentData().toInt());
    if (automatic_->isChecked())
        look.curvatureRange.reset();
    else if (low_->value() < high_->value())
        look.curvatureRange = NumberRange{low_->value(), high_->value()};
    else if (!look.curvatureRange)
        look.curvatureRange = NumberRange{};
    look.checker = static_cast<CheckerBy>(checker_->currentData().toInt());
    look.checkerCells = squares_->value();
    look.checkerLength.reset();
    if (squareLength_->value() > 0)
        look.checkerLength = squareLength_->value();
    look.pull = kPulls[static_cast<size_t>(pull_->currentIndex())].second;
    look.draftDegrees = draft_->value();
    viewport_.setFrame(frame);
    showFrame();  // numbers that are no range go back
}

}  // namespace knotspan
