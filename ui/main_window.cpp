#include "ui/main_window.h"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QCloseEvent>
#include <QDialog>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QSettings>
#include <QToolBar>

#include "ui/actions.h"
#include "ui/command_keys.h"
#include "ui/document_files.h"
#include "ui/message_bar.h"
#include "ui/picture_settings_store.h"
#include "ui/recovery.h"
#include "ui/start_page.h"
#include "ui/tool_settings_store.h"

namespace knotspan {
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> localFiles(const QMimeData& data)
{
    std::vector<fs::path> files;
    for (const QUrl& url : data.urls())
        if (url.isLocalFile())
            files.emplace_back(url.toLocalFile().toStdString());
    return files;
}

}  // namespace

MainWindow::MainWindow(Questions questions)
{
    setObjectName("main-window");
    setAcceptDrops(true);
    makeCentre();
    files_ =
        std::make_unique<DocumentFiles>(*this, document_, *messages_, *readingLine_, std::move(questions));
    makeStartPage();
    makeActions();
    makePanels();
    makeToolBar();
    makeMenus();
    commandKeys_ = new CommandKeys(commands(), menuBar()->actions(), this);
    makeStatusBar();
    restoreLayout();
    connect(&document_, &Document::fileChanged, this, &MainWindow::showTitle);
    connect(&document_, &Document::fileChanged, this, &MainWindow::showActionStates);
    connect(&document_, &Document::sceneChanged, this, &MainWindow::showActionStates);
    connect(&document_.undoStack(), &QUndoStack::indexChanged, this, &MainWindow::showActionStates);
    // Not at each move of a drag: the bar's going would move the picture under the hand.
    connect(&document_.undoStack(), &QUndoStack::indexChanged, messages_, &MessageBar::dismissTrouble);
    connect(&selection_, &Selection::changed, this, &MainWindow::showActionStates);
    connect(&selection_, &Selection::changed, this, [this, before = std::set<ObjectId>()]() mutable {
        if (std::exchange(before, selection_.objects()) != selection_.objects())
            letGoOfEdge();
    });
    connect(&document_, &Document::documentReplaced, this, [this] { shownFriends_.choose({}); });
    connect(&shownFriends_, &ShownFriends::changed, this, &MainWindow::showActionStates);
    connect(&viewport_->combs(), &ShownCombs::changed, this, &MainWindow::showActionStates);
    connect(&viewport_->section(), &ShownSection::changed, this, &MainWindow::showActionStates);
    connect(viewport_, &Viewport::frameChanged, this, &MainWindow::showActionStates);
    connect(viewport_, &Viewport::toolSettingsChanged, this, &MainWindow::showActionStates);
    connect(viewport_, &Viewport::toolChanged, this, &MainWindow::showActionStates);
    showTitle();
    showActionStates();
}

void MainWindow::keepForRecovery(const fs::path& folder, std::chrono::milliseconds interval)
{
    recovery_ = std::make_unique<Recovery>(document_, *files_, *messages_, *recoveryBar_, folder, interval);
}

MainWindow::~MainWindow()
{
    files_->dropReading();
    recovery_.reset();
    // What listens to the document goes before it; hidden first, so that nothing hears of a mouse that
    // leaves.
    hide();
    document_.disconnect();
    document_.undoStack().disconnect();
    selection_.disconnect();
    shownFriends_.disconnect();
    qDeleteAll(findChildren<QDialog*>(QString(), Qt::FindDirectChildrenOnly));
    qDeleteAll(panels_);
    delete takeCentralWidget();
}

QAction* MainWindow::action(std::string_view id) const
{
    const auto found = actions_.find(id);
    return found == actions_.end() ? nullptr : found->second;
}

QList<QAction*> MainWindow::commands() const
{
    QList<QAction*> commands;
    for (const MenuInfo& menu : menuList()) {
        for (const ActionInfo& info : actionList())
            if (menuOf(info) == menu.name)
                commands << action(info.id);
        if (std::string_view(menu.name) != "view")
            continue;
        for (const QDockWidget* panel : panels_)
            commands << panel->toggleViewAction();
        commands << toolBar_->toggleViewAction();
    }
    return commands;
}

void MainWindow::showStartPage(bool on)
{
    startPage_->hide();  // so that the column never has to hold both
    viewport_->setVisible(!on);
    startPage_->setVisible(on);
    if (on)
        frameLine_->clear();
    else
        viewport_->setFocus();
    showActionStates();
}

bool MainWindow::isStartPageShown() const
{
    return !startPage_->isHidden();
}

QString MainWindow::message() const
{
    return messages_->message();
}

// The chosen edge, once objects are selected that do not have it: the later choice counts.
void MainWindow::letGoOfEdge()
{
    const auto isSelected = [this](ObjectId id) { return selection_.contains(id); };
    const std::vector<ObjectId> having = shownFriends_.objects();
    if (!selection_.objects().empty() && std::none_of(having.begin(), having.end(), isSelected))
        shownFriends_.choose({});
}

void MainWindow::showTitle()
{
    setWindowTitle(tr("%1[*] - Knotspan").arg(document_.title()));
    setWindowModified(document_.isModified());
    setWindowFilePath(QString::fromStdString(document_.file().string()));
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!files_->mayDrop()) {
        event->ignore();
        return;
    }
    files_->dropReading();
    if (recovery_)
        recovery_->autosave().endInPeace();
    QSettings settings;
    settings.setValue("geometry", saveGeometry());
    settings.setValue("layout", saveState());
    storeToolSettings(viewport_->toolSettings());
    storePicture(*viewport_);
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
    files_->open(localFiles(*event->mimeData()));
}

}  // namespace knotspan
