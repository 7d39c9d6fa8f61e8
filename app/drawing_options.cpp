#include "app/drawing_options.h"

namespace knotspan::app {

CLI::Option* addText(CLI::App& command, const std::string& name, std::string& value, const std::string& help,
                     const std::string& type)
{
    const CLI::Validator notEmpty(
        [](const std::string& typed) { return typed.empty() ? "should not be empty" : ""; }, "");
    return command.add_option(name, value, help)->type_name(type)->check(notEmpty);
}

void addDevice(CLI::App& command, std::optional<int>& device)
{
    command.add_option("--device", device, "Which Vulkan device, counted from 0")
        ->check(wholeWithin(0, 255))
        ->type_name("N");
}

std::vector<std::string> samplingNames()
{
    auto names = namesOf(samplingRules());
    for (std::string& rule : names)
        if (rule == "fixed")
            rule = "fixed:1 to fixed:64";
    return names;
}

SamplingRule parseSampling(const std::string& text)
{
    return parseName("--sampling", text, samplingNames(), parseSamplingRule);
}

void checkView(const std::string& text)
{
    if (!namedView(text, {}, 1, false))
        refuseName("--view", text, namedViews());
}

}  // namespace knotspan::app
