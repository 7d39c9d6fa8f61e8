// Everything the window can be told to do: one line each in actions.cpp, from which the menus, the shortcuts
// and the list of keys are made.
#pragma once

#include <string_view>
#include <vector>

#include <QKeySequence>
#include <QString>

namespace knotspan {

class MainWindow;

struct ActionInfo {
    const char* id;    // "file.open"; the part before the dot names the menu
    const char* text;  // with its mnemonic
    std::vector<QKeySequence> shortcuts;
    const char* tip;  // one sentence without a full stop
    void (*run)(MainWindow& window, bool checked);
    enum class Kind { plain, checkable } kind = Kind::plain;
    bool separated = false;  // a line above it
};

// In the order of the menus.
[[nodiscard]] const std::vector<ActionInfo>& actionList();

// What the mouse does over the picture: (gesture, meaning).
struct MouseInfo {
    const char* gesture;
    const char* meaning;
};
[[nodiscard]] const std::vector<MouseInfo>& mouseList();

}  // namespace knotspan
