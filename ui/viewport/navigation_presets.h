// Which buttons and modifiers turn the view: this program's own way, and those of programs that hands know.
#pragma once

#include <optional>
#include <vector>

#include <QString>
#include <Qt>

namespace knotspan {

enum class ViewTurn { orbit, pan, zoom };

struct NavigationGrip {
    Qt::MouseButton button;
    Qt::KeyboardModifier key;  // others may be down as well
    ViewTurn turn;
};

struct NavigationPreset {
    const char* name;                   // "blender"; for the settings
    const char* title;                  // with its mnemonic, to be translated like an action
    const char* tip;                    // likewise
    std::vector<NavigationGrip> grips;  // the first that fits counts
    // What a left drag does that no tool takes: orbits, or selects by a box.
    bool leftOrbits;
};

// The first is the one that a new user gets.
[[nodiscard]] const std::vector<NavigationPreset>& navigationPresets();
// The first where none has that name.
[[nodiscard]] const NavigationPreset& findNavigation(const QString& name);

// None: the button is left to the tools.
[[nodiscard]] std::optional<ViewTurn> turnBy(const NavigationPreset& preset, Qt::MouseButton button,
                                             Qt::KeyboardModifiers keys);

// "Right drag, Shift + middle drag", in the user's language; without the left drag that no tool takes.
[[nodiscard]] QString gesturesFor(const NavigationPreset& preset, ViewTurn turn);

}  // namespace knotspan
