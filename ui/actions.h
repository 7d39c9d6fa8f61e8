// Everything the window can be told to do: one row each, in the file of its menu (file_actions.cpp, …), from
// which the menus, the shortcuts, the list of keys and what is greyed or checked are made.
#pragma once

#include <string_view>
#include <vector>

#include <QKeySequence>
#include <QString>

namespace knotspan {

class MainWindow;
struct NavigationPreset;

struct ActionInfo {
    const char* id;    // "file.open"; the part before the dot names the menu
    const char* text;  // with its mnemonic
    std::vector<QKeySequence> shortcuts;
    const char* tip;  // one sentence without a full stop
    void (*run)(MainWindow& window, bool checked);
    // Asked again whenever document, selection or frame change. Without: always; not checkable; no step.
    bool (*isEnabled)(MainWindow& window) = nullptr;
    bool (*isChecked)(MainWindow& window) = nullptr;
    QString (*step)(MainWindow& window) = nullptr;  // what it would undo or redo, told behind the text
    bool separated = false;                         // a line above it
    bool whileDragging = false;                     // others wait until the hand lets go
    const char* submenu = nullptr;                  // its title, where neighbours share one
};

// The menus of the menu bar.
struct MenuInfo {
    const char* name;   // "file"
    const char* title;  // with its mnemonic
};
[[nodiscard]] const std::vector<MenuInfo>& menuList();

// Whose entry it is: "file.open" -> "file".
[[nodiscard]] std::string_view menuOf(const ActionInfo& action);

// In the order of the menus.
[[nodiscard]] const std::vector<ActionInfo>& actionList();
// Its parts.
[[nodiscard]] const std::vector<ActionInfo>& fileActions();
[[nodiscard]] const std::vector<ActionInfo>& editActions();
[[nodiscard]] const std::vector<ActionInfo>& toolActions();
[[nodiscard]] const std::vector<ActionInfo>& pointActions();
[[nodiscard]] const std::vector<ActionInfo>& objectActions();
[[nodiscard]] const std::vector<ActionInfo>& viewActions();
[[nodiscard]] const std::vector<ActionInfo>& helpActions();

// A text of the lists in the user's language.
[[nodiscard]] QString translatedAction(const char* text);

// What the mouse does over the picture, in the user's language: (gesture, meaning).
struct MouseInfo {
    QString gesture;
    QString meaning;
};
[[nodiscard]] std::vector<MouseInfo> mouseList(const NavigationPreset& navigation);

}  // namespace knotspan
