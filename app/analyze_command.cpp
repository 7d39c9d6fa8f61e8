#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/analyze_report.h"
#include "app/arguments.h"
#include "app/commands.h"
#include "app/output.h"

namespace knotspan::app {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string file;
    std::optional<double> gap;
    std::optional<double> angle;
    std::string require = "G1";
    bool closed = false;
    int rows = 0;
    bool json = false;
};

Requirement requirementOf(const Options& options)
{
    for (const Continuity continuity : {Continuity::g0, Continuity::g1, Continuity::g2})
        if (options.require == continuityName(continuity))
            return {continuity, options.closed};
    refuseName("--require", options.require, {"G0", "G1", "G2"});
}

FriendTolerances tolerancesOf(const Options& options)
{
    const formats::Format* format = formats::find(options.file);
    FriendTolerances tolerances = defaultTolerances(format != nullptr && format->name != "Knotspan");
    tolerances.gap = options.gap.value_or(tolerances.gap);
    tolerances.angleDeg = options.angle.value_or(tolerances.angleDeg);
    return tolerances;
}

std::string areOrIs(size_t count, const char* one, const char* many)
{
    return std::to_string(count) + (count == 1 ? one : many);
}

// What the verdicts say nothing about.
void tellWhatIsLeftOut(const Scene& scene, const AnalyzeReport& report)
{
    const auto hidden =
        static_cast<size_t>(std::count_if(scene.objects().begin(), scene.objects().end(),
                                          [](const auto& entry) { return !entry.second->visible; }));
    if (hidden > 0)
        tell(report.file + ": " + areOrIs(hidden, " surface is", " surfaces are") + " hidden and left out");
    if (const size_t count = report.creases.size(); count > 0)
        tell(report.file + ": " +
             areOrIs(count, " crease lies inside a surface", " creases lie inside surfaces") +
             "; only where surfaces meet counts");
    if (!scene.meshes().empty())
        tell(report.file + ": meshes have no part in this; only surfaces are looked at");
    if (const size_t count = report.friends.shortEdges().size(); count > 0)
        tell(report.file + ": " + areOrIs(count, " edge is", " edges are") +
             " no longer than three gap tolerances and left out; a smaller --gap would look at them");
}

int run(const Options& options)
{
    const Requirement requirement = requirementOf(options);
    const FriendTolerances tolerances = tolerancesOf(options);
    const auto scene = readModel(options.file);
    if (!scene)
        return failed(scene.error());
    AnalyzeReport report = analyzed(*scene, tolerances, requirement);
    report.file = std::filesystem::path(options.file).filename().string();
    tellWhatIsLeftOut(*scene, report);
    if (options.json)
        std::cout << jsonOf(report).dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    else
        std::cout << tableOf(report, static_cast<size_t>(options.rows));
    return report.passes() ? kDone : kToleranceMissed;
}

}  // namespace

void addAnalyzeCommand(CLI::App& app, int& exitCode)
{
    const auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "analyze", "Say where surfaces meet and how smoothly; exit code 3 where a tolerance is missed");
    addModel(*command, options->file);
    command
        ->add_option("--gap", options->gap,
                     "How far edges that meet may be apart, in model units; 0.001 if not given")
        ->check(within(0, 1e12))
        ->type_name("D");
    command
        ->add_option("--angle", options->angle,
                     "How far tangent planes may differ; if not given 0.1 for .knotspan, 0.5 for imports")
        ->check(within(1e-6, 90))
        ->type_name("DEG");
    command
        ->add_option("--require", options->require,
                     "G0, G1 or G2: an edge that meets another less smoothly misses; G1 if not given")
        ->type_name("G");
    command->add_flag("--closed", options->closed, "Naked edges miss too");
    command
        ->add_option("--rows", options->rows,
                     "At most so many lines of edges, those that miss first, and of naked edges")
        ->check(wholeWithin(1, 1'000'000'000))
        ->type_name("N");
    addJson(*command, options->json);
    command->callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace knotspan::app
