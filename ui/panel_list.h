// The window's panels: one row each in panel_list.cpp, from which the docks and their lines in the menu View
// are made.
#pragma once

#include <vector>

#include <Qt>

class QWidget;

namespace knotspan {

class MainWindow;

struct PanelInfo {
    const char* name;  // of its dock, in saved layouts
    const char* title;
    Qt::DockWidgetArea area;  // at first
    // Wired to what it shows, all of which outlives it.
    QWidget* (*make)(MainWindow& window);
    const char* shortcut = nullptr;  // of its line in the menu
    bool hiddenAtFirst = false;
    const char* tabbedWith = nullptr;  // the dock before it that it shares its place with
};

// From the top down.
[[nodiscard]] const std::vector<PanelInfo>& panelList();

}  // namespace knotspan
