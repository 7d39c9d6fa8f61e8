// How the window is put together: menus and tool bar from the list of actions, panels, status line.
#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

#include "model/samples/sample_list.h"
#include "ui/actions.h"
#include "ui/keys_dialog.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/panels/objects_panel.h"
#include "ui/panels/rendering_panel.h"
#include "ui/panels/stats_panel.h"
#include "ui/recent_files.h"

namespace knotspan {

namespace {

QString translated(const char* text)
{
    return QCoreApplication::translate("knotspan::Actions", text);
}

// "file.open" -> "file"
std::string_view menuOf(const ActionInfo& action)
{
    const std::string_view id = action.id;
    return id.substr(0, id.find('.'));
}

}  // namespace

void MainWindow::makeCentre()
{
    auto* centre = new QWidget(this);
    messages_ = new MessageBar(centre);
    viewport_ = new Viewport(document_, selection_, centre);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(messages_);
    column->addWidget(viewport_, 1);
    setCentralWidget(centre);
    connect(viewport_, &Viewport::failed, messages_, &MessageBar::say);
    connect(viewport_, &Viewport::frameDrawn, this, &MainWindow::showFrameLine);
}

void MainWindow::makeActions()
{
    for (const ActionInfo& info : actionList()) {
        auto* made = new QAction(translated(info.text), this);
        made->setObjectName(info.id);
        QList<QKeySequence> keys(info.shortcuts.begin(), info.shortcuts.end());
        made->setShortcuts(keys);
        made->setStatusTip(translated(info.tip));
        const QString key = keys.isEmpty() ? QString() : keys.first().toString(QKeySequence::NativeText);
        made->setToolTip(key.isEmpty() ? translated(info.tip)
                                       : QString("%1 (%2)").arg(translated(info.tip), key));
        made->setCheckable(info.kind == ActionInfo::Kind::checkable);
        connect(made, &QAction::triggered, this,
                [this, run = info.run](bool checked) { run(*this, checked); });
        addAction(made);  // so that its keys work whatever menu is open
        actions_[info.id] = made;
    }
}

void MainWindow::makePanels()
{
    stats_ = new StatsPanel;
    connect(viewport_, &Viewport::frameDrawn, stats_, &StatsPanel::setStats);
    addPanel(Qt::LeftDockWidgetArea, "objects-dock", tr("Objects"), new ObjectsPanel(document_, selection_));
    addPanel(Qt::RightDockWidgetArea, "rendering-dock", tr("Rendering"), new RenderingPanel(*viewport_));
    addPanel(Qt::RightDockWidgetArea, "stats-dock", tr("Statistics"), stats_);
}

void MainWindow::addPanel(Qt::DockWidgetArea area, const char* name, const QString& title, QWidget* content)
{
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(content);
    dock->toggleViewAction()->setStatusTip(tr("Show or hide the panel \"%1\"").arg(title));
    addDockWidget(area, dock);
    panels_.push_back(dock);
}

void MainWindow::makeMenus()
{
    const std::vector<std::pair<std::string_view, QString>> titles = {
        {"file", tr("&File")}, {"edit", tr("&Edit")}, {"view", tr("&View")}, {"help", tr("&Help")}};
    for (const auto& [menuName, title] : titles) {
        QMenu& menu = *menuBar()->addMenu(title);
        if (menuName == "file")
            fillSamples(*menu.addMenu(tr("&New from sample")));
        for (const ActionInfo& info : actionList()) {
            if (menuOf(info) != menuName)
                continue;
            if (info.separated)
                menu.addSeparator();
            menu.addAction(action(info.id));
            if (std::string_view(info.id) == "file.open") {
                QMenu* recent = menu.addMenu(tr("Open &recent"));
                connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecentFiles(*recent); });
            }
        }
        if (menuName == "view") {
            menu.addSeparator();
            for (QDockWidget* panel : panels_)
                menu.addAction(panel->toggleViewAction());
            menu.addAction(toolBar_->toggleViewAction());
        }
    }
}

void MainWindow::fillSamples(QMenu& menu)
{
    menu.setToolTipsVisible(true);
    for (const Sample& sample : samples()) {
        QAction* entry = menu.addAction(QString::fromStdString(sample.name));
        entry->setToolTip(QString::fromStdString(sample.description));
        entry->setStatusTip(entry->toolTip());
        connect(entry, &QAction::triggered, this, [this, name = sample.name] { openSample(name); });
    }
}

void MainWindow::fillRecentFiles(QMenu& menu)
{
    menu.clear();
    const QStringList files = recentFiles::all();
    for (const QString& file : files) {
        QAction* entry = menu.addAction(QFileInfo(file).fileName());
        entry->setStatusTip(file);
        entry->setToolTip(file);
        connect(entry, &QAction::triggered, this, [this, file] { openFiles({file.toStdString()}); });
    }
    menu.setToolTipsVisible(true);
    if (files.isEmpty()) {
        menu.addAction(tr("No files yet"))->setEnabled(false);
        return;
    }
    menu.addSeparator();
    connect(menu.addAction(tr("Forget these files")), &QAction::triggered, this,
            [] { recentFiles::clear(); });
}

void MainWindow::makeToolBar()
{
    toolBar_ = addToolBar(tr("Tool bar"));
    toolBar_->setObjectName("tool-bar");
    toolBar_->setToolButtonStyle(Qt::ToolButtonTextOnly);
    toolBar_->toggleViewAction()->setStatusTip(tr("Show or hide the tool bar"));
    const std::vector<std::vector<const char*>> groups = {
        {"file.open", "file.save"},
        {"edit.undo", "edit.redo"},
        {"view.fit", "view.iso", "view.front", "view.right", "view.top"},
        {"view.orthographic", "view.nets", "view.knots"}};
    for (const auto& group : groups) {
        if (&group != &groups.front())
            toolBar_->addSeparator();
        for (const char* id : group)
            toolBar_->addAction(action(id));
    }
}

void MainWindow::makeStatusBar()
{
    auto* hint =
        new QLabel(tr("Click a surface to see its control points (N: of all), drag one to pull the surface. "
                      "Left drag elsewhere turns the view, H lists the keys."));
    hint->setObjectName("hint");
    hint->setContentsMargins(6, 0, 6, 0);
    hint->setToolTip(hint->text());
    hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a narrow window cuts it off
    statusBar()->addWidget(hint, 1);
    frameLine_ = new QLabel;
    frameLine_->setAccessibleName(tr("The last frame"));
    frameLine_->setContentsMargins(6, 0, 6, 0);
    statusBar()->addPermanentWidget(frameLine_);
    const auto preparing = [this] {
        frameLine_->setText(tr("Preparing the picture; the first time this can take a while"));
    };
    connect(viewport_, &Viewport::preparing, this, preparing);
    if (viewport_->isDrawPending() && viewport_->renderer() != nullptr)
        preparing();
}

void MainWindow::showFrameLine(const FrameStats& stats)
{
    frameLine_->setText(tr("%L1 triangles, %2 ms")
                            .arg(static_cast<qulonglong>(stats.triangles))
                            .arg(stats.gpuMs.median, 0, 'f', 1));
    frameLine_->setToolTip(tr("Drawn by %1").arg(QString::fromStdString(stats.device)));
}

void MainWindow::showActionStates()
{
    action("edit.undo")->setEnabled(document_.canUndo());
    action("edit.redo")->setEnabled(document_.canRedo());
    const auto named = [](const QString& verb, const QString& step) {
        return step.isEmpty() ? verb : QString("%1: %2").arg(verb, step);
    };
    action("edit.undo")->setText(named(tr("&Undo"), document_.undoText()));
    action("edit.undo")->setIconText(tr("Undo"));
    action("edit.redo")->setText(named(tr("&Redo"), document_.redoText()));
    action("edit.redo")->setIconText(tr("Redo"));
    action("edit.delete")->setEnabled(!selection_.objects().empty());
    action("view.fitSelection")->setEnabled(!selection_.objects().empty());
    const Frame& frame = viewport_->frame();
    action("view.moreCells")->setEnabled(frame.path == PathId::cpu);
    action("view.fewerCells")->setEnabled(frame.path == PathId::cpu);
    action("view.orthographic")->setChecked(frame.camera.orthographic);
    action("view.nets")->setChecked(frame.overlays.controlNets);
    action("view.knots")->setChecked(frame.overlays.knotLines);
}

void MainWindow::restoreLayout()
{
    resize(1280, 800);
    const QSettings settings;
    restoreGeometry(settings.value("geometry").toByteArray());
    restoreState(settings.value("layout").toByteArray());
}

}  // namespace knotspan
