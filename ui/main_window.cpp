#include "ui/main_window.h"

#include <algorithm>

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>

#include "model/samples/sample_list.h"
#include "ui/keys_dialog.h"
#include "ui/message_bar.h"
#include "ui/panels/stats_panel.h"
#include "ui/recent_files.h"
#include "ui/speed_dialog.h"

namespace knotspan {
namespace fs = std::filesystem;

namespace {

fs::path toPath(const QString& name)
{
    return {name.toStdString()};
}

// The hourglass, while a file is read or written.
struct Busy {
    Busy() { QGuiApplication::setOverrideCursor(Qt::WaitCursor); }
    ~Busy() { QGuiApplication::restoreOverrideCursor(); }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;
};

std::vector<fs::path> localFiles(const QMimeData& data)
{
    std::vector<fs::path> files;
    for (const QUrl& url : data.urls())
        if (url.isLocalFile())
            files.push_back(toPath(url.toLocalFile()));
    return files;
}

std::ptrdiff_t trimmedFaces(const Scene& scene)
{
    return std::count_if(scene.objects().begin(), scene.objects().end(),
                         [](const auto& entry) { return !entry.second->trimLoops.empty(); });
}

}  // namespace

MainWindow::MainWindow(Questions questions) : questions_(std::move(questions))
{
    setObjectName("main-window");
    setAcceptDrops(true);
    makeCentre();
    makeActions();
    makePanels();
    makeToolBar();
    makeMenus();
    makeStatusBar();
    restoreLayout();
    connect(&document_, &Document::fileChanged, this, &MainWindow::showTitle);
    connect(&document_, &Document::fileChanged, this, &MainWindow::showActionStates);
    connect(&document_, &Document::sceneChanged, this, &MainWindow::showActionStates);
    connect(&document_.undoStack(), &QUndoStack::indexChanged, this, &MainWindow::showActionStates);
    // Not at each move of a drag: the bar's going would move the picture under the hand.
    connect(&document_.undoStack(), &QUndoStack::indexChanged, messages_, &MessageBar::dismissTrouble);
    connect(&selection_, &Selection::changed, this, &MainWindow::showActionStates);
    connect(viewport_, &Viewport::frameChanged, this, &MainWindow::showActionStates);
    showTitle();
    showActionStates();
}

MainWindow::~MainWindow()
{
    // What listens to the document goes before it; hidden first, so that nothing hears of a mouse that
    // leaves.
    hide();
    document_.disconnect();
    document_.undoStack().disconnect();
    selection_.disconnect();
    delete speed_;
    qDeleteAll(panels_);
    delete takeCentralWidget();
}

QAction* MainWindow::action(std::string_view id) const
{
    const auto found = actions_.find(id);
    return found == actions_.end() ? nullptr : found->second;
}

QString MainWindow::message() const
{
    return messages_->message();
}

void MainWindow::report(const Error& error)
{
    messages_->say(QString::fromStdString(error.sentence()));
}

void MainWindow::showTitle()
{
    setWindowTitle(tr("%1[*] - Knotspan").arg(document_.title()));
    setWindowModified(document_.isModified());
    setWindowFilePath(QString::fromStdString(document_.file().string()));
}

bool MainWindow::mayDropDocument()
{
    if (!document_.isModified())
        return true;
    switch (questions_.saveChanges(this, document_.title())) {
    case SaveAnswer::save:
        return save();
    case SaveAnswer::discard:
        return true;
    case SaveAnswer::cancel:
        break;
    }
    return false;
}

void MainWindow::openFiles(const std::vector<fs::path>& files)
{
    if (files.empty() || !mayDropDocument())
        return;
    messages_->dismiss();
    if (openFile(files.front()))
        addFiles({files.begin() + 1, files.end()}, 0);
}

bool MainWindow::openFile(const fs::path& path)
{
    const Busy busy;
    if (const Result<void> opened = document_.open(path); !opened) {
        recentFiles::forget(QString::fromStdString(path.string()));
        report(opened.error());
        return false;
    }
    recentFiles::remember(path);
    return true;
}

void MainWindow::addFiles(const std::vector<fs::path>& files, std::ptrdiff_t trimmedBefore)
{
    const Busy busy;
    QStringList wrong;  // said at the end: a file that works would clear the message
    for (const fs::path& path : files)
        if (const Result<void> added = document_.add(path); !added)
            wrong << QString::fromStdString(added.error().sentence());
    QStringList lines = wrong;
    if (trimmedFaces(document_.scene()) > trimmedBefore)
        lines << tr("Trimmed faces are shown whole: this version keeps their trim loops but does not draw "
                    "them yet.");
    if (!wrong.isEmpty())
        messages_->say(lines.join('\n'));
    else if (!lines.isEmpty())
        messages_->note(lines.join('\n'));
}

void MainWindow::openSample(const std::string& name)
{
    const Sample* sample = findSample(name);
    if (sample == nullptr || !mayDropDocument())
        return;
    messages_->dismiss();
    const Busy busy;
    document_.reset(sample->make(), tr("Sample: %1").arg(QString::fromStdString(name)));
}

void MainWindow::askAndOpen()
{
    std::vector<fs::path> files;
    for (const QString& name : questions_.filesToOpen(this, tr("Open a model"), readFilters()))
        files.push_back(toPath(name));
    openFiles(files);
}

void MainWindow::askAndAdd()
{
    std::vector<fs::path> files;
    for (const QString& name : questions_.filesToOpen(this, tr("Add to this model"), readFilters()))
        files.push_back(toPath(name));
    if (files.empty())
        return;
    messages_->dismiss();
    addFiles(files, trimmedFaces(document_.scene()));
}

bool MainWindow::save()
{
    if (document_.file().empty())
        return saveAs();
    messages_->dismissTrouble();
    const Busy busy;
    if (const Result<void> saved = document_.save(); !saved) {
        report(saved.error());
        return false;
    }
    return true;
}

bool MainWindow::saveAs()
{
    const fs::path known = document_.file();
    QString proposal = QString::fromStdString(known.string());
    if (known.empty())
        proposal = QFileInfo(document_.title().section(": ", -1)).completeBaseName() + ".knotspan";
    const QString name = questions_.fileToSave(this, proposal, writeFilters());
    if (name.isEmpty())
        return false;
    fs::path path = toPath(name);
    if (!path.has_extension())
        path += ".knotspan";
    messages_->dismissTrouble();
    const Busy busy;
    if (const Result<void> saved = document_.saveAs(path); !saved) {
        report(saved.error());
        return false;
    }
    recentFiles::remember(path);
    return true;
}

void MainWindow::undo()
{
    if (!viewport_->cancelDrag())
        document_.undo();
}

void MainWindow::redo()
{
    document_.redo();
}

void MainWindow::escape()
{
    if (!viewport_->cancelDrag())
        selection_.clear();
}

void MainWindow::selectAll()
{
    std::set<ObjectId> visible;
    for (const auto& [id, object] : document_.scene().objects())
        if (object->visible)
            visible.insert(id);
    selection_.setObjects(std::move(visible));
}

void MainWindow::deleteSelected()
{
    Edit edit;
    for (const ObjectId id : selection_.objects())
        edit.set(id, nullptr);
    const int count = static_cast<int>(selection_.objects().size());
    document_.apply(edit, count == 1 ? tr("Delete an object") : tr("Delete %1 objects").arg(count));
}

void MainWindow::setOrthographic(bool on)
{
    Frame frame = viewport_->frame();
    frame.camera.orthographic = on;
    viewport_->setFrame(frame);
}

void MainWindow::setControlNets(bool on)
{
    Frame frame = viewport_->frame();
    frame.overlays.controlNets = on;
    viewport_->setFrame(frame);
}

void MainWindow::setKnotLines(bool on)
{
    Frame frame = viewport_->frame();
    frame.overlays.knotLines = on;
    viewport_->setFrame(frame);
}

void MainWindow::changeUniformCells(int by)
{
    constexpr int kFirst = 8;  // where the rule was another
    constexpr int kMost = 64;
    Frame frame = viewport_->frame();
    SamplingRule& rule = frame.sampling;
    const bool fixed = rule.kind == SamplingRule::Kind::fixed;
    rule = {SamplingRule::Kind::fixed, std::clamp(fixed ? rule.count + by : kFirst, 1, kMost)};
    viewport_->setFrame(frame);
}

void MainWindow::showSpeed()
{
    if (speed_ == nullptr)
        speed_ = new SpeedDialog(document_, *viewport_, this);
    speed_->show();
    speed_->raise();
    speed_->activateWindow();
    if (!speed_->hasFindings() && !speed_->isMeasuring())
        speed_->measure();
}

void MainWindow::showKeys()
{
    if (keys_.isNull()) {
        keys_ = new KeysDialog(this);
        keys_->setAttribute(Qt::WA_DeleteOnClose);
    }
    keys_->show();
    keys_->raise();
    keys_->activateWindow();
}

void MainWindow::showAbout()
{
    auto* box = new QMessageBox(this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(tr("About Knotspan"));
    box->setText(tr("<b>Knotspan</b><p>Shape free-form surfaces and see the exact NURBS: the graphics device "
                    "evaluates the surfaces themselves.</p>"));
    const Renderer* renderer = viewport_->renderer();
    box->setInformativeText(renderer == nullptr
                                ? tr("No graphics device draws at the moment.")
                                : tr("Drawing on %1.").arg(QString::fromStdString(renderer->deviceName())));
    box->open();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!mayDropDocument()) {
        event->ignore();
        return;
    }
    QSettings settings;
    settings.setValue("geometry", saveGeometry());
    settings.setValue("layout", saveState());
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!localFiles(*event->mimeData()).empty())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    event->acceptProposedAction();
    openFiles(localFiles(*event->mimeData()));
}

}  // namespace knotspan
