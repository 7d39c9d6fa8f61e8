// What the options of commands that draw have in common: how they are declared, and from names to values.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "renderer/frame.h"

namespace knotspan::app {

// An option whose value is read later; it may not be empty.
CLI::Option* addText(CLI::App& command, const std::string& name, std::string& value, const std::string& help,
                     const std::string& type);
// --device
void addDevice(CLI::App& command, std::optional<int>& device);

// Of a list of the renderer's, in its order.
template <class List>
[[nodiscard]] std::vector<std::string> namesOf(const List& list)
{
    std::vector<std::string> names;
    for (const auto& entry : list)
        names.push_back(entry.name);
    return names;
}
// As in a help text: "a, b, c".
template <class List>
[[nodiscard]] std::string listed(const List& list)
{
    return joined(namesOf(list), ", ");
}

// The sampling rules as they are typed.
[[nodiscard]] std::vector<std::string> samplingNames();

// What `find` knows by the name `word`; refuses others and says which are `known`.
template <class Find>
[[nodiscard]] auto parseName(const std::string& option, const std::string& word,
                             const std::vector<std::string>& known, const Find& find)
{
    const auto found = find(word);
    if (!found)
        refuseName(option, word, known);
    return *found;
}

// "a,b": each by parseName, in the order given, none twice.
template <class Find>
[[nodiscard]] auto parseNames(const std::string& option, const std::string& text,
                              const std::vector<std::string>& known, const Find& find)
{
    std::vector<typename decltype(find(text))::value_type> values;
    for (const std::string& word : splitAtCommas(text)) {
        const auto value = parseName(option, word, known, find);
        if (std::find(values.begin(), values.end(), value) != values.end())
            throw CLI::ValidationError(option, "'" + word + "' is there twice");
        values.push_back(value);
    }
    return values;
}

[[nodiscard]] SamplingRule parseSampling(const std::string& text);
// --view; refuses what is no named view.
void checkView(const std::string& text);

}  // namespace knotspan::app
