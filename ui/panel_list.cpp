#include "ui/panel_list.h"

#include "ui/main_window.h"
#include "ui/panels/friends_panel.h"
#include "ui/panels/history_panel.h"
#include "ui/panels/measures_panel.h"
#include "ui/panels/objects_panel.h"
#include "ui/panels/rendering_panel.h"
#include "ui/panels/stats_panel.h"
#include "ui/panels/tool_panel.h"

namespace knotspan {

namespace {

// Marks a title for translation.
#define TITLE(text) QT_TRANSLATE_NOOP("knotspan::Panels", text)

QWidget* makeObjects(MainWindow& window)
{
    return new ObjectsPanel(window.document(), window.selection());
}

QWidget* makeFriends(MainWindow& window)
{
    return new FriendsPanel(window.document(), window.shownFriends(), window.viewport());
}

QWidget* makeRendering(MainWindow& window)
{
    return new RenderingPanel(window.viewport());
}

QWidget* makeTool(MainWindow& window)
{
    return new ToolPanel(window.document(), window.viewport());
}

QWidget* makeHistory(MainWindow& window)
{
    return new HistoryPanel(window.document());
}

QWidget* makeMeasures(MainWindow& window)
{
    return new MeasuresPanel(window.document(), window.selection(), window.viewport());
}

QWidget* makeStats(MainWindow& window)
{
    auto* panel = new StatsPanel;
    QObject::connect(&window.viewport(), &Viewport::frameDrawn, panel, &StatsPanel::setStats);
    return panel;
}

}  // namespace

const std::vector<PanelInfo>& panelList()
{
    static const std::vector<PanelInfo> kList = {
        {"objects-dock", TITLE("Objects"), Qt::LeftDockWidgetArea, makeObjects},
        {"rendering-dock", TITLE("Rendering"), Qt::RightDockWidgetArea, makeRendering},
        {"friends-dock", TITLE("Friends"), Qt::LeftDockWidgetArea, makeFriends, "Ctrl+F", true,
         "objects-dock"},
        {"tool-dock", TITLE("Tool settings"), Qt::LeftDockWidgetArea, makeTool, "D", true, "friends-dock"},
        {"history-dock", TITLE("History"), Qt::LeftDockWidgetArea, makeHistory, "Ctrl+H", true, "tool-dock"},
        {"measures-dock", TITLE("Measures"), Qt::LeftDockWidgetArea, makeMeasures, "Shift+O", true,
         "history-dock"},
        {"stats-dock", TITLE("Statistics"), Qt::RightDockWidgetArea, makeStats},
    };
    return kList;
}

}  // namespace knotspan
