#include <algorithm>
#include <iostream>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/compared_units.h"
#include "app/output.h"
#include "model/mesh/scene_distance.h"

namespace knotspan::app {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string a;
    std::string b;
    bool json = false;
};

void tellHidden(const std::string& file, const Scene& scene)
{
    const auto isHidden = [](const auto& entry) { return !entry.second->visible; };
    const auto hidden = std::count_if(scene.objects().begin(), scene.objects().end(), isHidden) +
                        std::count_if(scene.meshes().begin(), scene.meshes().end(), isHidden);
    if (hidden > 0)
        tell(file + ": " + std::to_string(hidden) + (hidden == 1 ? " object is" : " objects are") +
             " hidden and left out");
}

Json describe(const MeshDistance& distance)
{
    return {{"largest", distance.largest}, {"mean", distance.mean}};
}

int run(const Options& options)
{
    const auto a = readModel(options.a);
    if (!a)
        return failed(a.error());
    const auto b = readModel(options.b);
    if (!b)
        return failed(b.error());
    const ComparedUnits units = comparedUnits(options.a, *a, options.b, *b);
    tellHidden(options.a, *a);
    tellHidden(options.b, *b);
    const auto found = distanceBetween(*a, *b, units.scale);
    if (!found)
        return failed(found.error());
    for (const std::string& note : found->notes)
        tell(note);
    const MeshDistance& larger = found->larger();
    if (options.json) {
        const Json json{{"a", options.a},
                        {"b", options.b},
                        {"largest", larger.largest},
                        {"mean", found->mean()},
                        {"largest_at", {larger.at.x, larger.at.y, larger.at.z}},
                        {"a_to_b", describe(found->aToB)},
                        {"b_to_a", describe(found->bToA)},
                        {"uncertainty", found->uncertainty()},
                        {"units", units.name}};
        std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
        return kDone;
    }
    std::cout << "largest distance " << larger.largest << " at (" << larger.at.x << ", " << larger.at.y
              << ", " << larger.at.z << "), mean " << found->mean() << ", to within " << found->uncertainty()
              << ' ' << units.name << "; from the first to the second " << found->aToB.largest << ", back "
              << found->bToA.largest << '\n';
    return kDone;
}

}  // namespace

void addCompareCommand(CLI::App& app, int& exitCode)
{
    const auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("compare", "Say how far two models are from each other, surfaces or meshes");
    command->add_option("A", options->a, "Model to read")->required()->type_name("");
    command->add_option("B", options->b, "Model to compare it with")->required()->type_name("");
    addJson(*command, options->json);
    command->callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace knotspan::app
