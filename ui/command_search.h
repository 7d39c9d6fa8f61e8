// Which commands someone means by a few words: pure functions.
#pragma once

#include <optional>
#include <vector>

#include <QString>

namespace knotspan {

struct CommandWords {
    QString name;  // "view.fit"
    QString text;
    QString menu;
    QString tip;
};

// How far off the words are from the command, 0 for what it begins with; none where a word is nowhere in it.
// Words in any order, of any case.
[[nodiscard]] std::optional<int> farOff(const CommandWords& command, const QString& filter);

// The indices of those that match, the nearest first. What was used last (`recent`, names, the last first)
// comes before others that are as near.
[[nodiscard]] std::vector<size_t> commandsFor(const std::vector<CommandWords>& commands,
                                              const QString& filter, const QStringList& recent);

}  // namespace knotspan
