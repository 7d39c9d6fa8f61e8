#include "ui/export_dialog.h"

#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/viewport/described.h"
#include "ui/viewport/number_box.h"

namespace knotspan {

namespace {

QString number(size_t count)
{
    return QLocale().toString(static_cast<qulonglong>(count));
}

QString length(double value)
{
    return QLocale().toString(value, 'g', 3);
}

// 1, 2 or 5 times a power of ten, no more than `value`.
double roundedDown(double value)
{
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double digit : {5.0, 2.0})
        if (digit * power <= value)
            return digit * power;
    return power;
}

QLabel* makeLine(const char* id, const QString& name, QWidget* parent)
{
    auto* label = new QLabel(parent);
    describe(label, id, name, {});
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

}  // namespace

ExportDialog::ExportDialog(Document& document, Questions questions, QWidget* parent)
    : QDialog(parent),
      document_(document),
      questions_(std::move(questions))
{
    setWindowTitle(tr("Export mesh"));
    setObjectName("export-dialog");
    soon_.setSingleShot(true);
    soon_.setInterval(250);
    makeLayout();
    proposeDeviation();
    connect(&soon_, &QTimer::timeout, this, &ExportDialog::count);
    connect(format_, &QComboBox::currentIndexChanged, this, &ExportDialog::countSoon);
    connect(deviation_, &QDoubleSpinBox::valueChanged, this, &ExportDialog::countSoon);
    connect(limitsAngle_, &QCheckBox::toggled, this, [this](bool limits) {
        angle_->setEnabled(limits);
        countSoon();
    });
    connect(angle_, &QDoubleSpinBox::valueChanged, this, &ExportDialog::countSoon);
    connect(export_, &QPushButton::clicked, this, &ExportDialog::askAndWrite);
    connect(&document_, &Document::sceneChanged, this, &ExportDialog::countSoon);
    connect(&document_, &Document::documentReplaced, this, [this] {
        outcome_->clear();
        proposeDeviation();
    });
}

ExportDialog::~ExportDialog() = default;

void ExportDialog::makeLayout()
{
    format_ = new QComboBox(this);
    describe(format_, "format", tr("Format"), tr("What the file will be"));
    for (const formats::MeshFormat& format : formats::meshFormats())
        format_->addItem(QString::fromStdString(format.name), static_cast<int>(format.kind));
    deviation_ = new NumberBox(this);
    describe(deviation_, "deviation", tr("Deviation"),
             tr("How far triangles may lie from the surfaces: guaranteed, and measured when written"));
    deviation_->setDecimals(9);
    deviation_->setRange(1e-9, 1e9);
    deviation_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    limitsAngle_ = new QCheckBox(tr("Limit the &angle to"), this);
    describe(limitsAngle_, "limits-angle", tr("Limit the angle"),
             tr("Also make triangles small where normals turn, for shading elsewhere"));
    angle_ = new QDoubleSpinBox(this);
    describe(angle_, "angle", tr("Angle"),
             tr("How far triangles' normals may turn from the surface's: sampled"));
    angle_->setRange(0.1, 90);
    angle_->setValue(10);
    angle_->setSuffix(tr("°"));
    angle_->setEnabled(false);
    count_ = makeLine("count", tr("Triangles"), this);
    outcome_ = makeLine("outcome", tr("Outcome"), this);

    auto* form = new QFormLayout;
    form->addRow(tr("&Format"), format_);
    form->addRow(tr("&Deviation"), deviation_);
    form->addRow(limitsAngle_, angle_);
    form->addRow(tr("Triangles"), count_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    export_ = buttons->addButton(tr("&Export…"), QDialogButtonBox::ActionRole);
    describe(export_, "export", tr("Export"), tr("Choose a file and write it"));
    export_->setDefault(true);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addLayout(form);
    column->addWidget(outcome_);
    column->addStretch(1);
    setMinimumWidth(440);
    column->addWidget(buttons);
}

// A thousandth of the control points' box.
void ExportDialog::proposeDeviation()
{
    deviation_->setSuffix(" " + QString::fromStdString(document_.scene().units()));
    const double size = document_.scene().bounds().diagonal();
    deviation_->setValue(size > 0 ? roundedDown(size / 1000) : 0.1);
}

formats::MeshExportOptions ExportDialog::options() const
{
    formats::MeshExportOptions options;
    options.kind = static_cast<formats::MeshKind>(format_->currentData().toInt());
    options.deviation = deviation_->value();
    if (limitsAngle_->isChecked())
        options.angleDegrees = angle_->value();
    return options;
}

void ExportDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    countSoon();
}

void ExportDialog::countSoon()
{
    isStale_ = thread_ != nullptr;
    if (!isVisible())
        return;  // counted when it is shown
    count_->setText(tr("Counting…"));
    if (thread_ == nullptr)
        soon_.start();
}

void ExportDialog::count()
{
    if (thread_ == nullptr)
        start({});
}

void ExportDialog::askAndWrite()
{
    const formats::MeshFormat& format = formats::meshFormats()[static_cast<size_t>(format_->currentIndex())];
    const QString suffix = "." + QString::fromStdString(format.extension);
    const QString model = QFileInfo(document_.title().section(": ", -1)).completeBaseName();
    const QString folder = QString::fromStdString(document_.source().parent_path().string());
    QString name = questions_.fileToSave(
        this, tr("Export the mesh as"), (folder.isEmpty() ? "" : folder + "/") + model + suffix,
        {QString("%1 (*%2)").arg(QString::fromStdString(format.name), suffix)});
    if (name.isEmpty())
        return;
    // Who types another extension means it.
    if (const auto typed = formats::meshKindOf(name.toStdString()))
        format_->setCurrentIndex(format_->findData(static_cast<int>(*typed)));
    else
        name += suffix;
    soon_.stop();
    if (thread_ != nullptr) {  // what it counts is wanted no more
        thread_->disconnect(this);
        thread_.reset();
    }
    outcome_->setText(tr("Writing %1…").arg(QFileInfo(name).fileName()));
    start(name.toStdString());
}

void ExportDialog::start(const std::filesystem::path& path)
{
    isStale_ = false;
    thread_ = std::make_unique<ExportThread>(document_.settledScene(), path, options());
    connect(thread_.get(), &QThread::finished, this, &ExportDialog::takeFromThread);
    enable();
    thread_->start();
}

void ExportDialog::takeFromThread()
{
    if (!thread_ || !thread_->isFinished())
        return;
    const std::unique_ptr<ExportThread> done = std::move(thread_);
    enable();
    if (done->writes())
        showWritten(done->path(), done->written());
    else if (!isStale_)
        count_->setText(done->counted()
                            ? tr("%1, with %2 vertices")
                                  .arg(number(done->counted()->triangles), number(done->counted()->vertices))
                            : QString::fromStdString(done->counted().error().sentence()));
    makeRoom();
    if (isStale_)
        countSoon();
}

void ExportDialog::showWritten(const std::filesystem::path& path,
                               const Result<formats::MeshExportReport>& written)
{
    if (!written) {
        outcome_->setText(QString::fromStdString(written.error().sentence()));
        return;
    }
    const QString units = QString::fromStdString(document_.scene().units());
    count_->setText(
        tr("%1, with %2 vertices").arg(number(written->counts.triangles), number(written->counts.vertices)));
    QStringList lines{tr("%1 is written.").arg(QString::fromStdString(path.filename().string()))};
    if (const auto& deviation = written->deviation)
        lines << tr("No triangle is further than %1 %3 from the surfaces; the furthest found is %2 %3.")
                     .arg(length(deviation->bound), length(deviation->measured), units);
    if (written->boundaryEdges == 0 && written->nonManifoldEdges == 0)
        lines << tr("The mesh is closed.");
    else
        lines << tr("The mesh is open: %1 of its edges have one triangle, %2 more than two.")
                     .arg(number(written->boundaryEdges), number(written->nonManifoldEdges));
    for (const std::string& note : written->notes)
        lines << QString::fromStdString(note);
    outcome_->setText(lines.join('\n'));
    makeRoom();
}

// Lines of text that are wrapped need more height than a dialog gives them by itself.
void ExportDialog::makeRoom()
{
    const int needed = layout()->totalHeightForWidth(width());
    if (needed > height())
        resize(width(), needed);
}

void ExportDialog::enable()
{
    const bool isWriting = thread_ != nullptr && thread_->writes();
    for (QWidget* widget : std::initializer_list<QWidget*>{format_, deviation_, limitsAngle_, export_})
        widget->setEnabled(!isWriting);
    angle_->setEnabled(!isWriting && limitsAngle_->isChecked());
}

}  // namespace knotspan
