#include "ui/speed_dialog.h"

#include <algorithm>

#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <nlohmann/json.hpp>

#include "model/files/file_replacement.h"
#include "renderer/measurement/flight.h"
#include "ui/plots/path_plot.h"
#include "ui/plots/plot_view.h"
#include "ui/viewport/described.h"

namespace knotspan {

namespace {

constexpr int kFrames = 3;
constexpr size_t kFlightViews = 8;
constexpr PictureSize kFlightSize{800, 600};  // whatever the window's

std::vector<PathId> allPaths()
{
    std::vector<PathId> ids;
    for (const PathInfo& path : paths())
        ids.push_back(path.id);
    return ids;
}

}  // namespace

SpeedDialog::SpeedDialog(Document& document, Viewport& viewport, Questions questions, QWidget* parent)
    : QDialog(parent),
      document_(document),
      viewport_(viewport),
      questions_(std::move(questions))
{
    setWindowTitle(tr("Speed and accuracy"));
    setObjectName("speed-dialog");
    makeLayout();
    connect(&viewport_, &Viewport::frameChanged, this, &SpeedDialog::showPlot);
    connect(&document_, &Document::documentReplaced, this, &SpeedDialog::clear);
    connect(motion_, &QComboBox::currentIndexChanged, this, &SpeedDialog::showPlot);
    connect(measure_, &QPushButton::clicked, this, [this] { measure(); });
    connect(cancel_, &QPushButton::clicked, this, &SpeedDialog::cancel);
    connect(copy_, &QPushButton::clicked, this, &SpeedDialog::copyReport);
    connect(save_, &QPushButton::clicked, this, &SpeedDialog::saveReport);
    connect(plot_, &PlotView::chosen, this, &SpeedDialog::choose);
    connect(plot_, &PlotView::pointedAt, this, &SpeedDialog::showDetails);
    clear();
}

SpeedDialog::~SpeedDialog() = default;

void SpeedDialog::makeControls()
{
    views_ = new QComboBox(this);
    views_->addItem(tr("The viewport's view"), static_cast<int>(Views::viewport));
    views_->addItem(tr("A flight around the model"), static_cast<int>(Views::flight));
    describe(
        views_, "views", tr("What is looked at"),
        tr("What the next measurement draws: what the viewport shows, or %1 fixed views of %2 by %3 pixels, "
           "which compare with those of other machines")
            .arg(kFlightViews)
            .arg(kFlightSize.width)
            .arg(kFlightSize.height));
    motion_ = new QComboBox(this);
    motion_->addItem(tr("Model at rest"), static_cast<int>(Deformation::none));
    motion_->addItem(tr("Every control point moves"), static_cast<int>(Deformation::all));
    describe(motion_, "motion", tr("What moves"),
             tr("The chart of frames between which the model stays, or changes"));
    measure_ = new QPushButton(tr("&Measure again"), this);
    describe(measure_, "measure", tr("Measure again"), tr("Measure the open model as it is now"));
    cancel_ = new QPushButton(tr("&Cancel"), this);
    describe(cancel_, "cancel", tr("Cancel"),
             tr("Stop measuring before the next frame; what is measured stays"));
    copy_ = new QPushButton(tr("C&opy report"), this);
    describe(copy_, "copy", tr("Copy report"),
             tr("Put the figures and what this device is on the clipboard, as JSON for a bug report"));
    save_ = new QPushButton(tr("&Save report…"), this);
    describe(save_, "save", tr("Save report"), tr("Write the same into a file"));
    for (QPushButton* button : {measure_, cancel_, copy_, save_})
        button->setAutoDefault(false);
}

void SpeedDialog::makeLayout()
{
    makeControls();
    progress_ = new QProgressBar(this);
    describe(progress_, "progress", tr("Progress of the measurement"),
             tr("Which measurement of how many runs"));
    plot_ = new PlotView(this);
    describe(plot_, "plot", tr("Error against time, a curve a path"), {});
    details_ = new QLabel(this);
    details_->setObjectName("details");
    details_->setAccessibleName(tr("Details"));
    details_->setTextFormat(Qt::PlainText);
    details_->setWordWrap(true);
    details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    details_->setMinimumHeight(3 * details_->fontMetrics().lineSpacing());
    details_->setAlignment(Qt::AlignTop);

    auto* top = new QHBoxLayout;
    top->addWidget(views_);
    top->addWidget(motion_);
    top->addStretch(1);
    top->addWidget(cancel_);
    top->addWidget(measure_);
    auto* close = new QDialogButtonBox(QDialogButtonBox::Close, this);
    close->addButton(copy_, QDialogButtonBox::ActionRole);
    close->addButton(save_, QDialogButtonBox::ActionRole);
    qobject_cast<QPushButton*>(close->button(QDialogButtonBox::Close))->setAutoDefault(false);
    connect(close, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addLayout(top);
    column->addWidget(progress_);
    column->addWidget(plot_, 1);
    column->addWidget(details_);
    column->addWidget(close);
}

void SpeedDialog::hideEvent(QHideEvent* event)
{
    cancel();
    QDialog::hideEvent(event);
}

void SpeedDialog::clear()
{
    thread_.reset();
    rows_.clear();
    showEnd();
    showPlot();
}

SpeedDialog::Views SpeedDialog::views() const
{
    return static_cast<Views>(views_->currentData().toInt());
}

// The flight depends on the model alone, not on how the window happens to draw it.
PathMeasurementRequest SpeedDialog::request(Views views) const
{
    PathMeasurementRequest request;
    const bool isFlight = views == Views::flight;
    const PictureSize size = isFlight ? kFlightSize : viewport_.pictureSize();
    if (isFlight)
        request.frame.culling = defaultCulling();
    else
        request.frame = viewport_.frame();
    request.frame.cullingCamera.reset();
    request.frame.width = size.width;
    request.frame.height = size.height;
    request.paths = allPaths();
    request.tolerances = {4, 2, 1, 0.5, 0.25};
    request.evaluators = {request.frame.evaluator};
    request.frames = kFrames;
    if (isFlight) {
        request.flight =
            flightAround(document_.scene(), kFlightViews, static_cast<double>(size.width) / size.height);
        request.tolerances = {2, 0.5};
        request.frames = 1;
    }
    return request;
}

void SpeedDialog::measure()
{
    measure(views());
}

void SpeedDialog::measure(Views views)
{
    views_->setCurrentIndex(views_->findData(static_cast<int>(views)));
    measure(request(views));
}

void SpeedDialog::measure(const PathMeasurementRequest& wanted)
{
    clear();
    const Scene::Objects& objects = document_.scene().objects();
    if (std::none_of(objects.begin(), objects.end(),
                     [](const auto& entry) { return entry.second->visible; })) {
        details_->setText(tr("There is no surface to measure. Open a model first."));
        return;
    }
    title_ = document_.title();
    subtitle_ = tr("%1 by %2 pixels").arg(wanted.frame.width).arg(wanted.frame.height);
    if (!wanted.flight.empty())
        subtitle_ += ", " + tr("%1 views").arg(wanted.flight.size());
    subject_ = {document_.title().toStdString(), {}, wanted, {}, visibleKsQuads(document_.scene())};
    thread_ = std::make_unique<MeasuringThread>(document_.scene(), wanted);
    connect(thread_.get(), &MeasuringThread::progressed, this, &SpeedDialog::showProgress);
    connect(thread_.get(), &QThread::finished, this, &SpeedDialog::showEnd);
    measure_->setEnabled(false);
    cancel_->setEnabled(true);
    progress_->setRange(0, 0);
    details_->setText(tr("Measuring. A software driver takes a minute or more; edit on meanwhile."));
    thread_->start();
}

void SpeedDialog::cancel()
{
    if (thread_)
        thread_->cancel();
    cancel_->setEnabled(false);
}

// May be late, after the thread that it tells of is gone.
void SpeedDialog::showProgress()
{
    if (!thread_)
        return;
    const MeasuringThread::State state = thread_->state();
    rows_ = state.rows;
    progress_->setRange(0, static_cast<int>(rows_.size() * state.views));
    progress_->setValue(static_cast<int>(state.rowsDone * state.views + state.viewsDone));
    progress_->setFormat(whatRuns(state));
    showReportButtons();
    showPlot();
}

QString SpeedDialog::whatRuns(const MeasuringThread::State& state)
{
    if (state.rowsDone >= state.rows.size())
        return {};
    const PathRow& row = state.rows[state.rowsDone];
    QString text = tr("%1 of %2: %3")
                       .arg(state.rowsDone + 1)
                       .arg(state.rows.size())
                       .arg(QString::fromStdString(pathInfo(row.path).name));
    if (row.tolerancePx)
        text = tr("%1 at %2 px").arg(text).arg(*row.tolerancePx);
    return state.views == 1 ? text
                            : tr("%1, view %2 of %3").arg(text).arg(state.viewsDone + 1).arg(state.views);
}

void SpeedDialog::showReportButtons()
{
    copy_->setEnabled(!rows_.empty());
    save_->setEnabled(!rows_.empty());
}

std::string SpeedDialog::reportText() const
{
    PathReport report = subject_;
    report.rows = rows_;
    if (thread_)
        report.device = thread_->state().device;
    return textOf(jsonOf(report));
}

void SpeedDialog::copyReport()
{
    QGuiApplication::clipboard()->setText(QString::fromStdString(reportText()));
    details_->setText(tr("The report is on the clipboard."));
}

void SpeedDialog::saveReport()
{
    const QString name = questions_.fileToSave(this, tr("Save the report as"), "knotspan-benchmark.json",
                                               {tr("Reports (*.json)")});
    if (name.isEmpty())
        return;
    const auto saved = formats::replaceText(name.toStdString(), reportText());
    details_->setText(saved ? tr("The report is in %1.").arg(name)
                            : QString::fromStdString(saved.error().sentence()));
}

void SpeedDialog::showEnd()
{
    cancel_->setEnabled(false);
    measure_->setEnabled(true);
    progress_->setRange(0, 1);
    progress_->setValue(0);
    progress_->setFormat({});
    details_->clear();
    showReportButtons();
    if (!thread_)
        return;
    showProgress();
    const std::string failure = thread_->state().failure;
    if (failure.empty())
        showDetails({});
    else
        details_->setText(QString::fromStdString(failure));
}

QString SpeedDialog::deviceName() const
{
    const auto device = thread_->state().device;
    return device ? QString::fromStdString(device->name) : tr("no device");
}

void SpeedDialog::showPlot()
{
    const auto motion = static_cast<Deformation>(motion_->currentData().toInt());
    const Frame& frame = viewport_.frame();
    PathPlot made = pathPlot(rows_, {motion, frame.path, frame.tolerancePx});
    made.plot.title = rows_.empty() ? tr("Nothing is measured yet").toStdString() : title_.toStdString();
    if (thread_)
        made.plot.subtitle = subtitle_.toStdString() + ", " + deviceName().toStdString();
    markerRows_ = std::move(made.rows);
    plot_->setPlot(std::move(made.plot));
}

QStringList SpeedDialog::notMeasured() const
{
    QStringList lines;
    for (const PathRow& row : rows_)
        if (!row.unavailable.empty() && row.motion == Deformation::none)
            lines << QString::fromStdString(knotspan::describe(row));
    return lines;
}

void SpeedDialog::showDetails(const QString& pointedAt)
{
    if (!pointedAt.isEmpty())
        return details_->setText(pointedAt);
    if (isMeasuring() || rows_.empty())
        return;
    QStringList lines{
        tr("Click a point, or go to it with the arrow keys and press Enter, to draw with its path "
           "and tolerance.")};
    if (const size_t done = thread_->state().rowsDone; done < rows_.size())
        lines << tr("Stopped after %1 of %2 measurements.").arg(done).arg(rows_.size());
    lines << notMeasured();
    details_->setText(lines.join('\n'));
}

void SpeedDialog::choose(int marker)
{
    const PathRow& row = rows_.at(markerRows_.at(static_cast<size_t>(marker)));
    Frame frame = viewport_.frame();
    frame.path = row.path;
    frame.tolerancePx = row.tolerancePx.value_or(frame.tolerancePx);
    viewport_.setFrame(frame);
}

}  // namespace knotspan
