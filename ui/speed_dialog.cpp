#include "ui/speed_dialog.h"

#include <algorithm>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/plots/path_plot.h"
#include "ui/plots/plot_view.h"

namespace knotspan {

namespace {

constexpr int kFrames = 3;

std::vector<PathId> allPaths()
{
    std::vector<PathId> ids;
    for (const PathInfo& path : paths())
        ids.push_back(path.id);
    return ids;
}

void describe(QWidget* widget, const QString& name, const QString& tip)
{
    widget->setAccessibleName(name);
    widget->setToolTip(tip);
}

}  // namespace

SpeedDialog::SpeedDialog(Document& document, Viewport& viewport, QWidget* parent)
    : QDialog(parent),
      document_(document),
      viewport_(viewport)
{
    setWindowTitle(tr("Speed and accuracy"));
    setObjectName("speed-dialog");
    makeLayout();
    connect(&viewport_, &Viewport::frameChanged, this, &SpeedDialog::showPlot);
    connect(&document_, &Document::documentReplaced, this, &SpeedDialog::clear);
    connect(motion_, &QComboBox::currentIndexChanged, this, &SpeedDialog::showPlot);
    connect(measure_, &QPushButton::clicked, this, [this] { measure(); });
    connect(cancel_, &QPushButton::clicked, this, &SpeedDialog::cancel);
    connect(plot_, &PlotView::chosen, this, &SpeedDialog::choose);
    connect(plot_, &PlotView::pointedAt, this, &SpeedDialog::showDetails);
    clear();
}

SpeedDialog::~SpeedDialog() = default;

void SpeedDialog::makeLayout()
{
    motion_ = new QComboBox(this);
    motion_->setObjectName("motion");
    motion_->addItem(tr("Model at rest"), static_cast<int>(Deformation::none));
    motion_->addItem(tr("Every control point moves"), static_cast<int>(Deformation::all));
    describe(motion_, tr("What moves"), tr("Whether the model changes from frame to frame"));
    measure_ = new QPushButton(tr("&Measure again"), this);
    measure_->setObjectName("measure");
    describe(measure_, tr("Measure again"), tr("Measure the open model as the viewport shows it now"));
    cancel_ = new QPushButton(tr("&Cancel"), this);
    cancel_->setObjectName("cancel");
    describe(cancel_, tr("Cancel"), tr("Stop measuring before the next frame; what is measured stays"));
    progress_ = new QProgressBar(this);
    progress_->setObjectName("progress");
    progress_->setAccessibleName(tr("Progress of the measurement"));
    plot_ = new PlotView(this);
    plot_->setObjectName("plot");
    describe(plot_, tr("Error against time, a curve a path"), {});
    details_ = new QLabel(this);
    details_->setObjectName("details");
    details_->setAccessibleName(tr("Details"));
    details_->setTextFormat(Qt::PlainText);
    details_->setWordWrap(true);
    details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    details_->setMinimumHeight(3 * details_->fontMetrics().lineSpacing());
    details_->setAlignment(Qt::AlignTop);

    auto* top = new QHBoxLayout;
    top->addWidget(motion_);
    top->addWidget(progress_, 1);
    top->addWidget(cancel_);
    top->addWidget(measure_);
    auto* close = new QDialogButtonBox(QDialogButtonBox::Close, this);
    for (QAbstractButton* button : close->buttons())
        qobject_cast<QPushButton*>(button)->setAutoDefault(false);
    measure_->setAutoDefault(false);
    cancel_->setAutoDefault(false);
    connect(close, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addLayout(top);
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

PathMeasurementRequest SpeedDialog::request() const
{
    PathMeasurementRequest request;
    request.frame = viewport_.frame();
    request.frame.cullingCamera.reset();
    const PictureSize size = viewport_.pictureSize();
    request.frame.width = size.width;
    request.frame.height = size.height;
    request.paths = allPaths();
    request.tolerances = {4, 2, 1, 0.5, 0.25};
    request.evaluators = {request.frame.evaluator};
    request.frames = kFrames;
    return request;
}

void SpeedDialog::measure()
{
    measure(request());
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
    progress_->setRange(0, static_cast<int>(rows_.size()));
    progress_->setValue(static_cast<int>(state.rowsDone));
    progress_->setFormat(tr("%v of %m"));
    showPlot();
}

void SpeedDialog::showEnd()
{
    cancel_->setEnabled(false);
    measure_->setEnabled(true);
    progress_->setRange(0, 1);
    progress_->setValue(0);
    progress_->setFormat({});
    details_->clear();
    if (!thread_)
        return;
    showProgress();
    const std::string failure = thread_->state().failure;
    if (failure.empty())
        showDetails({});
    else
        details_->setText(QString::fromStdString(failure));
}

void SpeedDialog::showPlot()
{
    const auto motion = static_cast<Deformation>(motion_->currentData().toInt());
    const Frame& frame = viewport_.frame();
    PathPlot made = pathPlot(rows_, {motion, frame.path, frame.tolerancePx});
    made.plot.title = rows_.empty() ? tr("Nothing is measured yet").toStdString() : title_.toStdString();
    if (thread_)
        made.plot.subtitle = subtitle_.toStdString() + ", " + thread_->state().device;
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
