#include "benchmarks/frames/arguments.h"

#include <cstdio>
#include <sstream>

#include <CLI/CLI.hpp>

#include "model/samples/sample_list.h"

namespace knotspan::benchmarks {

namespace {

struct Texts {
    std::string samples, paths, deform = "none,all", size = "1280x800";
    std::vector<std::string> culling;
};

// Where none are asked for.
const std::vector<std::string> kCullings{"none", "sqc", "sqc,frustum,small", "default"};

std::vector<std::string> split(const std::string& text, char separator)
{
    std::vector<std::string> parts;
    std::istringstream from(text);
    for (std::string part; std::getline(from, part, separator);)
        parts.push_back(part);
    return parts;
}

// "a,b": each by `find`; everything where the text is empty.
template <class Value, class Find>
std::vector<Value> listOf(const std::string& option, const std::string& text, const std::vector<Value>& all,
                          const Find& find)
{
    if (text.empty())
        return all;
    std::vector<Value> values;
    for (const std::string& word : split(text, ',')) {
        const auto value = find(word);
        if (!value)
            throw CLI::ValidationError(option, "'" + word + "' is not known");
        values.push_back(*value);
    }
    return values;
}

CullSet conservativeModes()
{
    CullSet set;
    for (int mode = 0; mode < kCullModeCount; ++mode)
        set.set(mode, cullModes()[static_cast<size_t>(mode)].conservative);
    return set;
}

std::optional<CullSet> cullingOf(const std::string& word)
{
    if (word == "default")
        return defaultCulling();
    return word == "all" ? conservativeModes() : parseCullSet(word);
}

std::vector<NamedCulling> cullingsOf(const std::vector<std::string>& texts)
{
    std::vector<NamedCulling> found;
    for (const std::string& text : texts)
        for (const std::string& word : split(text, ';')) {
            const auto set = cullingOf(word);
            if (!set)
                throw CLI::ValidationError("--culling", "'" + word + "' is no set of modes");
            found.push_back({word, *set});
        }
    return found;
}

std::vector<std::string> sampleNames()
{
    std::vector<std::string> names;
    for (const Sample& sample : samples())
        names.push_back(sample.name);
    return names;
}

std::vector<PathId> pathIds()
{
    std::vector<PathId> ids;
    for (const PathInfo& path : paths())
        ids.push_back(path.id);
    return ids;
}

void setSize(OrbitRequest& orbit, const std::string& text)
{
    char behind = 0;
    if (std::sscanf(text.c_str(), "%5dx%5d%c", &orbit.width, &orbit.height, &behind) != 2 ||
        orbit.width < 1 || orbit.height < 1)
        throw CLI::ValidationError("--size", "'" + text + "' should be like 1280x800");
}

void take(const Texts& texts, OrbitRequest& orbit)
{
    orbit.samples = listOf("--samples", texts.samples, sampleNames(), [](const std::string& name) {
        return findSample(name) != nullptr ? std::optional(name) : std::nullopt;
    });
    orbit.paths =
        listOf("--paths", texts.paths, pathIds(), [](const std::string& name) { return findPath(name); });
    orbit.cullings = cullingsOf(texts.culling.empty() ? kCullings : texts.culling);
    orbit.motions = listOf("--deform", texts.deform, std::vector<Deformation>{},
                           [](const std::string& name) { return findDeformation(name); });
    setSize(orbit, texts.size);
}

}  // namespace

std::optional<Arguments> parseArguments(int argc, const char* const* argv, int& exitCode)
{
    Arguments arguments;
    OrbitRequest& orbit = arguments.orbit;
    Texts texts;
    CLI::App app("What culling is worth: an orbit around each sample, by each path, with each set of modes.");
    app.add_option("--samples", texts.samples, "Names with commas between them; default: all");
    app.add_option("--paths", texts.paths, "Names with commas between them; default: all");
    app.add_option("--culling", texts.culling,
                   "Sets of modes, as in render --culling, with ; between them or given several times. "
                   "default: what is on unless asked otherwise; all: every conservative mode. Shares are of "
                   "the first's time. Default: none;sqc;sqc,frustum,small;default");
    app.add_option("--size", texts.size, "Of the picture")->capture_default_str();
    app.add_option("--views", orbit.views, "Of the orbit")
        ->capture_default_str()
        ->check(CLI::Range(1, 100000));
    app.add_option("--deform", texts.deform, "none,point,all")->capture_default_str();
    app.add_option("--tolerance", orbit.tolerancePx, "Pixels")
        ->capture_default_str()
        ->check(CLI::Range(1e-3, 1e3));
    app.add_option("--device", orbit.renderer.device, "Which Vulkan device, counted from 0");
    app.add_flag("--json", arguments.json, "As one JSON object");
    try {
        app.parse(argc, argv);
        take(texts, orbit);
    } catch (const CLI::ParseError& error) {
        exitCode = app.exit(error) == 0 ? 0 : 2;
        return std::nullopt;
    }
    return arguments;
}

}  // namespace knotspan::benchmarks
