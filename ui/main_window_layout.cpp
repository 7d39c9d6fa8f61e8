// How the window is put together: menus and tool bar from the list of actions, docks from the list of panels,
// the status line.
#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

#include "model/core/check.h"
#include "ui/actions.h"
#include "ui/command_keys.h"
#include "ui/command_text.h"
#include "ui/file_menus.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/panel_list.h"
#include "ui/picture_settings_store.h"
#include "ui/picture_taker.h"
#include "ui/reading_line.h"
#include "ui/recovery_bar.h"
#include "ui/start_page.h"
#include "ui/tool_settings_store.h"
#include "ui/tools/tool_list.h"
#include "ui/viewport/described.h"
#include "ui/viewport/navigation_presets.h"

namespace knotspan {

namespace {

// "{view.nets}" becomes the key that the action has now, or its name where it has none.
QString withKeys(QString sentence, const MainWindow& window)
{
    static const QRegularExpression kPlace("\\{([A-Za-z.]+)\\}");
    for (auto place = kPlace.match(sentence); place.hasMatch(); place = kPlace.match(sentence)) {
        const QAction* named = window.action(place.captured(1).toStdString());
        check(named != nullptr, "a sentence names actions that there are");
        const QString key = named->shortcut().toString(QKeySequence::NativeText);
        const QString shown = key.isEmpty() ? QString("\"%1\"").arg(plainTextOf(*named)) : key;
        sentence.replace(place.capturedStart(), place.capturedLength(), shown);
    }
    return sentence;
}

}  // namespace

void MainWindow::makeCentre()
{
    auto* centre = new QWidget(this);
    messages_ = new MessageBar(centre);
    readingLine_ = new ReadingLine(centre);
    recoveryBar_ = new RecoveryBar(centre);
    viewport_ = new Viewport(document_, selection_, centre);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(recoveryBar_);
    column->addWidget(messages_);
    column->addWidget(readingLine_);
    column->addWidget(viewport_, 1);
    setCentralWidget(centre);
    viewport_->setFriends(shownFriends_);
    connect(viewport_, &Viewport::failed, messages_, &MessageBar::say);
    connect(viewport_, &Viewport::frameDrawn, this, &MainWindow::showFrameLine);
}

void MainWindow::makeStartPage()
{
    startPage_ = new StartPage(*files_, centralWidget());
    startPage_->hide();
    static_cast<QVBoxLayout*>(centralWidget()->layout())->addWidget(startPage_, 1);
    const auto leave = [this] {
        if (isStartPageShown())
            showStartPage(false);
    };
    connect(&document_, &Document::sceneChanged, startPage_, leave);
    connect(&document_, &Document::documentReplaced, startPage_, leave);
    new PictureTaker(document_, *viewport_, centralWidget());
}

void MainWindow::makeActions()
{
    for (const ActionInfo& info : actionList()) {
        auto* made = new QAction(translatedAction(info.text), this);
        made->setObjectName(info.id);
        QList<QKeySequence> keys(info.shortcuts.begin(), info.shortcuts.end());
        made->setShortcuts(keys);
        made->setStatusTip(translatedAction(info.tip));
        made->setCheckable(info.isChecked != nullptr);
        connect(made, &QAction::triggered, this, [this, &info](bool checked) {
            if (viewport_->isDragging() && !info.whileDragging)
                statusBar()->showMessage(tr("First let go of what you drag, or press Escape"));
            else
                info.run(*this, checked);
            showActionStates();  // Qt has checked or unchecked it, whatever came of it
        });
        addAction(made);  // so that its keys work whatever menu is open
        actions_[info.id] = made;
    }
}

void MainWindow::makePanels()
{
    for (const PanelInfo& info : panelList()) {
        const QString title = QCoreApplication::translate("knotspan::Panels", info.title);
        auto* dock = new QDockWidget(title, this);
        dock->setObjectName(info.name);
        dock->setWidget(info.make(*this));
        dock->toggleViewAction()->setObjectName(QString("view.%1").arg(info.name));
        dock->toggleViewAction()->setStatusTip(tr("Show or hide the panel \"%1\"").arg(title));
        if (info.shortcut != nullptr)
            dock->toggleViewAction()->setShortcut(QKeySequence(info.shortcut));
        addDockWidget(info.area, dock);
        if (info.tabbedWith != nullptr)
            tabifyDockWidget(findChild<QDockWidget*>(info.tabbedWith), dock);
        connect(dock->toggleViewAction(), &QAction::triggered, dock, &QDockWidget::raise);  // among tabs
        dock->setHidden(info.hiddenAtFirst);
        panels_.push_back(dock);
    }
}

void MainWindow::makeMenus()
{
    for (const MenuInfo& shown : menuList()) {
        const std::string_view menuName = shown.name;
        QMenu& menu = *menuBar()->addMenu(translatedAction(shown.title));
        if (menuName == "file")
            addSamplesMenu(menu, *files_);
        QMenu* submenu = nullptr;
        for (const ActionInfo& info : actionList()) {
            if (menuOf(info) != menuName)
                continue;
            if (info.separated)
                menu.addSeparator();
            if (info.submenu == nullptr)
                submenu = nullptr;
            else if (const QString title = translatedAction(info.submenu);
                     submenu == nullptr || submenu->title() != title)
                submenu = menu.addMenu(title);
            (submenu == nullptr ? menu : *submenu).addAction(action(info.id));
            if (std::string_view(info.id) == "file.open")
                addRecentMenu(menu, *files_);
        }
        if (menuName == "view") {
            menu.addSeparator();
            QMenu& panels = *menu.addMenu(tr("&Panels"));  // so that the menu is no taller than small screens
            for (QDockWidget* panel : panels_)
                panels.addAction(panel->toggleViewAction());
            panels.addAction(toolBar_->toggleViewAction());
        }
    }
}

void MainWindow::makeToolBar()
{
    toolBar_ = addToolBar(tr("Tool bar"));
    toolBar_->setObjectName("tool-bar");
    toolBar_->setToolButtonStyle(Qt::ToolButtonTextOnly);
    toolBar_->toggleViewAction()->setObjectName("view.tool-bar");
    toolBar_->toggleViewAction()->setStatusTip(tr("Show or hide the tool bar"));
    const std::vector<std::vector<const char*>> groups = {
        {"file.open", "file.save"},
        {"edit.undo", "edit.redo"},
        {"tools.select", "tools.box", "tools.weight", "tools.knot", "tools.grab", "tools.smooth"},
        {"edit.keepFriends", "edit.matchEdge"},
        {"view.fit", "view.iso", "view.front", "view.right", "view.top"},
        {"view.orthographic", "view.nets", "view.knots", "view.friends"}};
    for (const auto& group : groups) {
        if (&group != &groups.front())
            toolBar_->addSeparator();
        for (const char* id : group)
            toolBar_->addAction(action(id));
    }
}

// How to turn the view while that is the tool, and where to read more.
QString MainWindow::navigationHint(const ToolInfo& tool) const
{
    const NavigationPreset& navigation = viewport_->navigation();
    const QString gesture = navigation.leftOrbits && !tool.takesAll
                                ? tr("Left drag elsewhere")
                                : gesturesFor(navigation, ViewTurn::orbit);
    return withKeys(tr("%1 turns the view, {help.keys} lists the keys.").arg(gesture), *this);
}

void MainWindow::makeStatusBar()
{
    auto* hint = new QLabel;
    hint->setObjectName("hint");
    hint->setContentsMargins(6, 0, 6, 0);
    const auto showHint = [this, hint] {
        for (const ToolInfo& tool : tools())
            if (tool.name == viewport_->tool())
                hint->setText(withKeys(translatedAction(tool.hint), *this) + ' ' + navigationHint(tool));
        hint->setToolTip(hint->text());
    };
    showHint();
    connect(viewport_, &Viewport::toolChanged, hint, showHint);
    connect(viewport_, &Viewport::navigationChanged, hint, showHint);
    connect(commandKeys_, &CommandKeys::changed, hint, showHint);
    hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a narrow window cuts it off
    statusBar()->addWidget(hint, 1);
    auto* reading = new QLabel;
    describe(reading, "ramp-reading", tr("Under the pointer"),
             tr("What the surface's colour under the pointer stands for"));
    reading->setContentsMargins(6, 0, 6, 0);
    reading->hide();
    statusBar()->addPermanentWidget(reading);
    connect(viewport_, &Viewport::rampRead, reading, [reading](const QString& text) {
        reading->setText(text);
        reading->setVisible(!text.isEmpty());
    });
    frameLine_ = new QLabel;
    frameLine_->setAccessibleName(tr("The last frame"));
    frameLine_->setContentsMargins(6, 0, 6, 0);
    statusBar()->addPermanentWidget(frameLine_);
    const auto preparing = [this] {
        frameLine_->setText(tr("Preparing the picture; the first time this can take a while"));
        statusBar()->repaint();  // no event comes before the picture
    };
    connect(viewport_, &Viewport::preparing, this, preparing);
    connect(viewport_, &Viewport::hint, this, [this](const QString& sentence) {
        if (sentence.isEmpty())
            statusBar()->clearMessage();
        else
            statusBar()->showMessage(sentence);
    });
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
    for (const ActionInfo& info : actionList()) {
        QAction& shown = *action(info.id);
        if (info.isEnabled != nullptr)
            shown.setEnabled(info.isEnabled(*this));
        if (info.isChecked != nullptr)
            shown.setChecked(info.isChecked(*this));
        if (info.step == nullptr)
            continue;
        const QString verb = translatedAction(info.text);
        const QString step = info.step(*this);
        shown.setText(step.isEmpty() ? verb : QString("%1: %2").arg(verb, step));
        shown.setIconText(QString(verb).remove('&'));  // on the tool bar
    }
}

void MainWindow::restoreLayout()
{
    resize(1280, 800);
    const QSettings settings;
    restoreGeometry(settings.value("geometry").toByteArray());
    restoreState(settings.value("layout").toByteArray());
    viewport_->setToolSettings(storedToolSettings());
    restorePicture(*viewport_);
    shownFriends_.showLines(settings.value("friendEdges", false).toBool());
    viewport_->showCube(settings.value("viewCube", true).toBool());
    viewport_->setNavigation(findNavigation(settings.value("navigation").toString()));
    connect(viewport_, &Viewport::navigationChanged, this, [this] {
        QSettings().setValue("navigation", viewport_->navigation().name);
        showActionStates();
    });
}

}  // namespace knotspan
