#include <iostream>
#include <memory>
#include <optional>

#include <QIODevice>
#include <unistd.h>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/evaluator_report.h"
#include "app/output.h"
#include "model/geometry/ksquad.h"
#include "model/geometry/simd_targets.h"

namespace knotspan::app {
namespace {

struct Options {
    std::string file;
    bool json = false;
    std::optional<std::string> plot;
    std::optional<int> device;
    int points = 200'000;
};

// Results of 4 million points in double are about 1 GB, on the device and here.
constexpr int kMostPoints = 4'000'000;

// One line that is written over, only where a person looks on.
class Progress {
public:
    void operator()(size_t row, size_t rows) const
    {
        if (shown_)
            std::cerr << "\rMeasuring " << row + 1 << " of " << rows << std::flush;
    }
    void clear() const
    {
        if (shown_)
            std::cerr << '\r' << std::string(40, ' ') << '\r' << std::flush;
    }

private:
    bool shown_ = ::isatty(STDERR_FILENO) != 0;
};

void describe(const Scene& scene, EvaluatorReport& report)
{
    report.lowestDegree = kMaxDegree;
    for (const auto& [id, object] : scene.objects()) {
        if (!object->visible)
            continue;
        const NurbsSurface& surface = object->surface;
        ++report.surfaces;
        report.ksquads += ksQuadCount(surface);
        report.lowestDegree = std::min({report.lowestDegree, surface.degreeU(), surface.degreeV()});
        report.highestDegree = std::max({report.highestDegree, surface.degreeU(), surface.degreeV()});
    }
}

// Without a device the rows of the GPU say why; a device that was asked for must be there.
Result<std::unique_ptr<Renderer>> rendererFor(const Scene& scene, const Options& options)
{
    auto renderer = Renderer::create({options.device, false});
    if (renderer)
        if (auto synced = (*renderer)->sync(scene); !synced)
            return tl::unexpected(synced.error());
    return renderer;
}

Result<EvaluatorReport> measure(const Options& options)
{
    const auto scene = readModel(options.file);
    if (!scene)
        return tl::unexpected(scene.error());
    EvaluatorReport report;
    describe(*scene, report);
    if (report.surfaces == 0)
        return tl::unexpected<Error>(
            {"The model holds nothing to measure", options.file, "Choose another model"});
    const auto renderer = rendererFor(*scene, options);
    if (!renderer && options.device)
        return tl::unexpected(renderer.error());
    report.file = std::filesystem::path(options.file).filename().string();
    report.device = renderer ? (*renderer)->deviceName() : "";
    report.simd = simdTargetInUse();
    report.points = static_cast<size_t>(options.points);
    const MeasuredPoints points = measuredPoints(*scene, report.points);
    report.exactPoints = points.exact;
    const Progress progress;
    report.rows = measureEvaluators({points, report.highestDegree, renderer ? renderer->get() : nullptr,
                                     renderer ? "" : renderer.error().sentence(), progress});
    progress.clear();
    return report;
}

int run(const Options& options)
{
    if (options.plot) {
        if (std::filesystem::path(*options.plot).extension() != ".svg")
            throw CLI::ValidationError("--plot", "'" + *options.plot + "' should end in .svg");
        if (isSameFile(*options.plot, options.file))
            throw CLI::ValidationError("--plot", "'" + *options.plot + "' is the model; choose another file");
        if (const auto place = checkPlace(*options.plot); !place)
            return failed(place.error());
    }
    const auto report = measure(options);
    if (!report)
        return failed(report.error());
    if (options.plot)
        if (const auto written = writeFiles(
                {{*options.plot, [&](QIODevice& device) { return writeSvg(plotOf(*report), device); }}});
            !written)
            return failed(written.error());
    std::cout << (options.json ? jsonOf(*report) : tableOf(*report));
    return kDone;
}

}  // namespace

void addMeasureCommand(CLI::App& app, int& exitCode)
{
    const auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "measure", "Measure on this machine what each evaluator costs and how far it is off, on CPU and GPU");
    command->add_option("FILE", options->file, "Model to measure on")->required();
    command->add_flag("--json", options->json, "As one JSON object");
    command->add_option("--plot", options->plot, "Drawing of error against time to write")
        ->type_name("OUT.svg");
    command->add_option("--device", options->device, "Which Vulkan device, counted from 0")
        ->check(wholeWithin(0, 255))
        ->type_name("N");
    command->add_option("--points", options->points, "How many random points, over all visible surfaces")
        ->capture_default_str()
        ->check(wholeWithin(1, kMostPoints))
        ->type_name("N");
    command->callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace knotspan::app
