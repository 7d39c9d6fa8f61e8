#include "ui/command_search.h"

#include <algorithm>
#include <tuple>

#include <QStringList>

namespace knotspan {

namespace {

// 0: begins with it; 1: one of its words does; 2: it is inside; none: it is not.
std::optional<int> placeIn(const QString& text, const QString& word)
{
    bool inside = false;
    for (qsizetype at = 0; (at = text.indexOf(word, at, Qt::CaseInsensitive)) >= 0; ++at) {
        if (at == 0)
            return 0;
        if (!text[at - 1].isLetterOrNumber())
            return 1;
        inside = true;
    }
    return inside ? std::optional(2) : std::nullopt;
}

std::optional<int> farOffWord(const CommandWords& command, const QString& word)
{
    std::optional<int> least;
    int further = 0;
    for (const QString* text : {&command.text, &command.menu, &command.name, &command.tip}) {
        if (const auto place = placeIn(*text, word); place && (!least || *place + further < *least))
            least = *place + further;
        further += 3;  // whatever place in the text comes before any in the menu
    }
    return least;
}

}  // namespace

std::optional<int> farOff(const CommandWords& command, const QString& filter)
{
    int sum = 0;
    for (const QString& word : filter.simplified().split(' ', Qt::SkipEmptyParts)) {
        const auto off = farOffWord(command, word);
        if (!off)
            return std::nullopt;
        sum += *off;
    }
    return sum;
}

std::vector<size_t> commandsFor(const std::vector<CommandWords>& commands, const QString& filter,
                                const QStringList& recent)
{
    std::vector<std::tuple<int, qsizetype, size_t>> found;
    for (size_t k = 0; k < commands.size(); ++k)
        if (const auto off = farOff(commands[k], filter)) {
            const qsizetype used = recent.indexOf(commands[k].name);
            found.emplace_back(*off, used < 0 ? recent.size() : used, k);
        }
    std::sort(found.begin(), found.end());
    std::vector<size_t> indices;
    indices.reserve(found.size());
    for (const auto& [off, used, index] : found)
        indices.push_back(index);
    return indices;
}

}  // namespace knotspan
