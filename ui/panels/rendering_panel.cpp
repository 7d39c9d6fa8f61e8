#include "ui/panels/rendering_panel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPixmap>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QToolButton>

#include "ui/panels/look_form.h"

namespace knotspan {

namespace {

struct Preset {
    const char* name;
    double tolerancePx;
    const char* tip;
};
constexpr std::array<Preset, 3> kPresets = {{
    {QT_TRANSLATE_NOOP("knotspan::RenderingPanel", "Draft"), 4,
     QT_TRANSLATE_NOOP("knotspan::RenderingPanel", "4 pixels: the fastest picture")},
    {QT_TRANSLATE_NOOP("knotspan::RenderingPanel", "Balanced"), 1,
     QT_TRANSLATE_NOOP("knotspan::RenderingPanel", "1 pixel")},
    {QT_TRANSLATE_NOOP("knotspan::RenderingPanel", "Exact"), 0.25,
     QT_TRANSLATE_NOOP("knotspan::RenderingPanel", "A quarter of a pixel: nothing that an eye can see")},
}};

// The slider is logarithmic, coarse on the left: 16 steps halve the tolerance.
constexpr double kCoarsest = 4;
constexpr double kFinest = 0.25;
constexpr int kStepsPerHalf = 16;
constexpr int kSteps = 4 * kStepsPerHalf;

double toleranceAt(int step)
{
    return kCoarsest * std::exp2(-double(step) / kStepsPerHalf);
}

int stepFor(double tolerance)
{
    return static_cast<int>(std::lround(std::log2(kCoarsest / tolerance) * kStepsPerHalf));
}

QString text(const std::string& utf8)
{
    return QString::fromStdString(utf8);
}

void describe(QWidget* widget, const QString& name, const QString& tip)
{
    widget->setAccessibleName(name);
    widget->setToolTip(tip);
    widget->setStatusTip(tip);
}

// What frozen culling outlines in it.
QIcon swatch(std::uint32_t colour)
{
    QPixmap square(12, 12);
    square.fill(QColor::fromRgb(colour));
    return square;
}

QString whyToleranceIsIdle(const PathInfo& chosen, const Renderer* renderer)
{
    QString how = text(chosen.description);
    how.replace(0, 1, how.left(1).toLower());
    const QString why =
        RenderingPanel::tr("%1 draws the same whatever the tolerance: %2.").arg(text(chosen.name), how);
    for (const PathInfo& other : paths())
        if (other.followsTolerance && renderer != nullptr && renderer->whyUnavailable(other.id).empty())
            return RenderingPanel::tr("%1 Choose the path %2 to trade speed for accuracy.")
                .arg(why, text(other.name));
    return why;
}

}  // namespace

RenderingPanel::RenderingPanel(Viewport& viewport, QWidget* parent) : QWidget(parent), viewport_(viewport)
{
    auto* layout = new QFormLayout(this);
    layout->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    layout->setRowWrapPolicy(QFormLayout::DontWrapRows);
    layout->addRow(tr("&Path"), makePathPicker());
    layout->addRow(tr("&Shading"), makeShadingPicker());
    layout->addRow(QString(), new LookForm(viewport_, this));
    layout->addRow(tr("Tolerance"), makeTolerance());
    layout->addRow(tr("Sa&mpling"), makeSamplingPicker());
    layout->addRow(tr("Culling"), makeCulling());
    layout->addRow(tr("&Evaluator"), makeEvaluatorPicker());
    connect(&viewport_, &Viewport::rendererChanged, this, &RenderingPanel::fillPaths);
    connect(&viewport_, &Viewport::frameChanged, this, &RenderingPanel::showFrame);
    fillPaths();
    showFrame();
}

QWidget* RenderingPanel::makePathPicker()
{
    path_ = new QComboBox(this);
    path_->setObjectName("path");
    describe(path_, tr("Path"), tr("How the graphics device turns surfaces into triangles"));
    for (const PathInfo& info : paths())
        path_->addItem(text(info.name), static_cast<int>(info.id));
    connect(path_, &QComboBox::activated, this, [this](int row) {
        change([&](Frame& frame) {
            frame.path = static_cast<PathId>(path_->itemData(row).toInt());
            if (!pathInfo(frame.path).follows(frame.sampling))
                frame.sampling = {};
        });
    });
    return path_;
}

QWidget* RenderingPanel::makeShadingPicker()
{
    shading_ = new QComboBox(this);
    shading_->setObjectName("shading");
    describe(shading_, tr("Shading"), tr("What the surfaces' colours show"));
    for (const ShadingInfo& info : shadings()) {
        shading_->addItem(text(info.name), static_cast<int>(info.id));
        shading_->setItemData(shading_->count() - 1, text(info.description), Qt::ToolTipRole);
    }
    connect(shading_, &QComboBox::activated, this, [this](int row) {
        change([&](Frame& frame) { frame.shading = static_cast<Shading>(shading_->itemData(row).toInt()); });
    });
    return shading_;
}

QWidget* RenderingPanel::makeSamplingPicker()
{
    auto* box = new QWidget(this);
    sampling_ = new QComboBox(box);
    sampling_->setObjectName("sampling");
    describe(sampling_, tr("Sampling"), tr("What decides how finely each KSQuad is cut"));
    sampling_->addItem(tr("the path's own"), static_cast<int>(SamplingRule::Kind::pathDefault));
    for (const SamplingRuleInfo& rule : samplingRules()) {
        sampling_->addItem(text(rule.name), static_cast<int>(rule.kind));
        sampling_->setItemData(sampling_->count() - 1, text(rule.description), Qt::ToolTipRole);
    }
    cells_ = new QSpinBox(box);
    cells_->setObjectName("sampling-cells");
    cells_->setRange(1, 64);
    cells_->setValue(8);
    describe(cells_, tr("Cells"), tr("Cells along each side, for the rule fixed"));
    const auto apply = [this] {
        change([&](Frame& frame) {
            const auto kind = static_cast<SamplingRule::Kind>(sampling_->currentData().toInt());
            frame.sampling = {kind, kind == SamplingRule::Kind::fixed ? cells_->value() : 0};
        });
    };
    connect(sampling_, &QComboBox::activated, this, apply);
    connect(cells_, &QSpinBox::valueChanged, this, apply);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(sampling_, 1);
    row->addWidget(cells_);
    return box;
}

QWidget* RenderingPanel::makeEvaluatorPicker()
{
    evaluator_ = new QComboBox(this);
    evaluator_->setObjectName("evaluator");
    describe(evaluator_, tr("Evaluator"), tr("How the points of surfaces are computed"));
    for (const EvaluatorInfo& info : evaluators()) {
        evaluator_->addItem(text(info.name), static_cast<int>(info.id));
        evaluator_->setItemData(evaluator_->count() - 1, text(info.description), Qt::ToolTipRole);
    }
    connect(evaluator_, &QComboBox::activated, this, [this](int row) {
        change([&](Frame& frame) {
            frame.evaluator = static_cast<Evaluator>(evaluator_->itemData(row).toInt());
        });
    });
    return evaluator_;
}

QWidget* RenderingPanel::makeCulling()
{
    auto* box = new QWidget(this);
    auto* rows = new QGridLayout(box);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setVerticalSpacing(2);
    constexpr int kColumns = 2;
    int bit = 0;
    for (const CullMode& mode : cullModes()) {
        auto* check = new QCheckBox(text(mode.name), box);
        check->setIcon(swatch(mode.colour));
        check->setObjectName("culling-" + text(mode.name));
        describe(check, tr("Culling: %1").arg(text(mode.name)), text(mode.description));
        connect(check, &QCheckBox::clicked, this,
                [this, bit](bool on) { change([&](Frame& frame) { frame.culling.set(bit, on); }); });
        rows->addWidget(check, bit / kColumns, bit % kColumns);
        culling_.push_back(check);
        ++bit;
    }
    countWrong_ = new QCheckBox(tr("Count wrong decisions"), box);
    countWrong_->setObjectName("count-wrong");
    describe(countWrong_, tr("Count wrong decisions"),
             tr("Shows in the statistics how often culling drops what faces the eye within the picture"));
    connect(countWrong_, &QCheckBox::clicked, this,
            [this](bool on) { change([&](Frame& frame) { frame.countWrongCulls = on; }); });
    rows->addWidget(countWrong_, rows->rowCount(), 0, 1, kColumns);
    return box;
}

QWidget* RenderingPanel::makeTolerance()
{
    auto* box = new QWidget(this);
    slider_ = new QSlider(Qt::Horizontal, box);
    slider_->setObjectName("tolerance-slider");
    slider_->setRange(0, kSteps);
    slider_->setPageStep(kStepsPerHalf);
    slider_->setTickInterval(kStepsPerHalf);
    slider_->setTickPosition(QSlider::TicksBelow);
    const QString tip =
        tr("How far the picture may be from the true surface: left is faster, right is finer");
    describe(slider_, tr("Tolerance"), tip);
    tolerance_ = new QDoubleSpinBox(box);
    tolerance_->setObjectName("tolerance");
    tolerance_->setRange(kFinest, kCoarsest);
    tolerance_->setDecimals(2);
    tolerance_->setSingleStep(0.25);
    tolerance_->setSuffix(tr(" px"));
    tolerance_->setKeyboardTracking(false);
    describe(tolerance_, tr("Tolerance in pixels"), tip);
    connect(slider_, &QSlider::valueChanged, this,
            [this](int step) { change([&](Frame& frame) { frame.tolerancePx = toleranceAt(step); }); });
    connect(tolerance_, &QDoubleSpinBox::valueChanged, this,
            [this](double value) { change([&](Frame& frame) { frame.tolerancePx = value; }); });
    auto* top = new QHBoxLayout;
    top->addWidget(slider_, 1);
    top->addWidget(tolerance_);
    auto* below = new QHBoxLayout;
    for (const Preset& preset : kPresets) {
        auto* button = new QToolButton(box);
        button->setText(tr(preset.name));
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        describe(button, tr(preset.name), tr(preset.tip));
        connect(button, &QToolButton::clicked, this,
                [this, px = preset.tolerancePx] { change([&](Frame& frame) { frame.tolerancePx = px; }); });
        below->addWidget(button, 1);
        presets_.push_back(button);
    }
    toleranceTips_ = {{slider_, tip}, {tolerance_, tip}};
    for (QToolButton* button : presets_)
        toleranceTips_.emplace_back(button, button->toolTip());
    auto* rows = new QVBoxLayout(box);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addLayout(top);
    rows->addLayout(below);
    return box;
}

// Which paths there are never changes, but which of them run is up to the device.
void RenderingPanel::fillPaths()
{
    auto* items = qobject_cast<QStandardItemModel*>(path_->model());
    const Renderer* renderer = viewport_.renderer();
    int row = 0;
    for (const PathInfo& info : paths()) {
        const std::string why = renderer != nullptr ? renderer->whyUnavailable(info.id) : std::string();
        const bool runs = renderer != nullptr && why.empty();
        items->item(row)->setEnabled(runs);
        items->item(row)->setToolTip(text(why.empty() ? info.description : why));
        ++row;
    }
    showFrame();
}

void RenderingPanel::showFrame()
{
    const Frame& frame = viewport_.frame();
    path_->setCurrentIndex(path_->findData(static_cast<int>(frame.path)));
    path_->setToolTip(text(pathInfo(frame.path).description));
    shading_->setCurrentIndex(shading_->findData(static_cast<int>(frame.shading)));
    evaluator_->setCurrentIndex(evaluator_->findData(static_cast<int>(frame.evaluator)));
    for (size_t mode = 0; mode < culling_.size(); ++mode)
        culling_[mode]->setChecked(frame.culling.has(static_cast<int>(mode)));
    countWrong_->setChecked(frame.countWrongCulls);
    const QSignalBlocker quietSlider(slider_);
    const QSignalBlocker quietBox(tolerance_);
    slider_->setValue(stepFor(frame.tolerancePx));
    tolerance_->setValue(frame.tolerancePx);
    for (size_t preset = 0; preset < presets_.size(); ++preset)
        presets_[preset]->setChecked(std::abs(frame.tolerancePx - kPresets[preset].tolerancePx) < 1e-9);
    showSampling(frame);
    showWhetherToleranceCounts(frame.path);
}

void RenderingPanel::showSampling(const Frame& frame)
{
    const PathInfo& path = pathInfo(frame.path);
    auto* items = qobject_cast<QStandardItemModel*>(sampling_->model());
    for (int row = 0; row < sampling_->count(); ++row) {
        const auto kind = static_cast<SamplingRule::Kind>(sampling_->itemData(row).toInt());
        const bool possible = std::any_of(path.rules.begin(), path.rules.end(),
                                          [&](const SamplingRule& rule) { return rule.kind == kind; });
        items->item(row)->setEnabled(possible || kind == SamplingRule::Kind::pathDefault);
    }
    sampling_->setCurrentIndex(sampling_->findData(static_cast<int>(frame.sampling.kind)));
    const auto own = std::find_if(path.rules.begin(), path.rules.end(), [](const SamplingRule& rule) {
        return rule.kind == SamplingRule::Kind::fixed;
    });
    const bool onlyOne = own != path.rules.end() && own->count != 0;
    const bool fixed = frame.sampling.kind == SamplingRule::Kind::fixed;
    const QSignalBlocker quiet(cells_);
    cells_->setEnabled(fixed && !onlyOne);
    if (fixed || onlyOne)
        cells_->setValue(onlyOne ? own->count : frame.sampling.count);
}

void RenderingPanel::showWhetherToleranceCounts(PathId path)
{
    const PathInfo& chosen = pathInfo(path);
    const QString why =
        chosen.followsTolerance ? QString() : whyToleranceIsIdle(chosen, viewport_.renderer());
    for (const auto& [control, tip] : toleranceTips_) {
        control->setEnabled(chosen.followsTolerance);
        control->setToolTip(chosen.followsTolerance ? tip : why);
        control->setStatusTip(control->toolTip());
    }
}

}  // namespace knotspan
