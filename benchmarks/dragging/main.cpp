// What a frame costs the application while the hand drags one control point, in large models and small ones.
#include <cstdio>
#include <sstream>

#include <CLI/CLI.hpp>

#include "benchmarks/dragging/drags.h"
#include "model/samples/sample_list.h"

using namespace knotspan;
using namespace knotspan::benchmarks;

namespace {

struct Arguments {
    DragsRequest request;
    std::string samples = "knot,nine-16";
    std::string path;
    std::string culling;
    std::string size = "64x64";
    std::string at;
};

void take(Arguments& arguments)
{
    std::istringstream names(arguments.samples);
    for (std::string name; std::getline(names, name, ',');) {
        if (findSample(name) == nullptr)
            throw CLI::ValidationError("--samples", "'" + name + "' is not known");
        arguments.request.samples.push_back(name);
    }
    if (arguments.request.samples.empty())
        throw CLI::ValidationError("--samples", "there is none");
    if (!arguments.path.empty() && !(arguments.request.path = findPath(arguments.path)))
        throw CLI::ValidationError("--path", "'" + arguments.path + "' is not known");
    if (!arguments.culling.empty() && !(arguments.request.culling = parseCullSet(arguments.culling)))
        throw CLI::ValidationError("--culling", "'" + arguments.culling + "' is no set of modes");
    if (!arguments.at.empty())
        arguments.request.grips = {arguments.at == "inside" ? Grip::inside : Grip::border};
    char behind = 0;
    DragsRequest& request = arguments.request;
    if (std::sscanf(arguments.size.c_str(), "%5dx%5d%c", &request.width, &request.height, &behind) != 2 ||
        request.width < 1 || request.height < 1)
        throw CLI::ValidationError("--size", "'" + arguments.size + "' should be like 64x64");
}

std::optional<DragsRequest> parse(int argc, const char* const* argv, int& exitCode)
{
    Arguments arguments;
    CLI::App app("What a frame costs the application while one control point is dragged.");
    app.add_option("--samples", arguments.samples, "Names with commas between them; ratios are to the last")
        ->capture_default_str();
    app.add_option("--frames", arguments.request.frames, "Of each drag")
        ->capture_default_str()
        ->check(CLI::Range(1, 100000));
    app.add_option("--at", arguments.at, "Which control point; default: each in turn")
        ->check(CLI::IsMember({"inside", "border"}));
    app.add_option("--path", arguments.path, "Default: the best one here");
    app.add_option("--culling", arguments.culling, "A set of modes, as in render --culling");
    app.add_option("--size", arguments.size, "Of the picture")->capture_default_str();
    app.add_option("--device", arguments.request.renderer.device, "Which Vulkan device, counted from 0");
    try {
        app.parse(argc, argv);
        take(arguments);
    } catch (const CLI::ParseError& error) {
        exitCode = app.exit(error) == 0 ? 0 : 2;
        return std::nullopt;
    }
    return arguments.request;
}

const char* nameOf(Grip grip)
{
    return grip == Grip::inside ? "inside" : "on the border";
}

void print(const DragRow& row, const DragRow& last)
{
    std::printf("| %s | %s | %llu | %llu | %.0f | %.3f | %.3f | %.3f | %.3f | %.2f | %.3f | %.3f | %.2f |\n",
                row.sample.c_str(), nameOf(row.grip), static_cast<unsigned long long>(row.surfaces),
                static_cast<unsigned long long>(row.ksquads), row.uploadBytes.max, row.edit.median,
                row.sync.median, row.prepare.median, row.outside.median,
                row.outside.median / last.outside.median, row.record.median, row.before.median,
                row.before.median / last.before.median);
}

}  // namespace

int main(int argc, char** argv)
{
    int exitCode = 0;
    const auto request = parse(argc, argv, exitCode);
    if (!request)
        return exitCode;
    auto benchmark = DragsBenchmark::open(*request);
    auto rows = benchmark ? benchmark->measure(request->frames)
                          : Result<std::vector<DragRow>>(tl::unexpected(benchmark.error()));
    if (!rows) {
        std::fprintf(stderr, "%s\n", rows.error().sentence().c_str());
        return 1;
    }
    std::printf("%s, %s, %d by %d pixels, %d frames; processor time, ms, medians; bytes: the most\n\n",
                benchmark->deviceName().c_str(), benchmark->pathName().c_str(), request->width,
                request->height, request->frames);
    std::printf(
        "| sample | control point | surfaces | KSQuads | upload bytes | edit | sync | prepare | outside the "
        "driver | of the last | record | with recording | of the last |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    const size_t samples = request->samples.size();
    for (size_t k = 0; k < rows->size(); ++k)
        print((*rows)[k], (*rows)[(k / samples + 1) * samples - 1]);
    return 0;
}
