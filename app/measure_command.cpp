#include <algorithm>
#include <iostream>
#include <memory>

#include <QIODevice>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "app/commands.h"
#include "app/evaluator_report.h"
#include "app/measure_options.h"
#include "app/output.h"
#include "app/path_report.h"
#include "model/geometry/ksquad.h"
#include "model/geometry/simd_targets.h"
#include "renderer/measurement/flight.h"
#include "renderer/scene/framed_points.h"
#include "ui/plots/plot_svg.h"

namespace knotspan::app {
namespace {

// One line that is written over, only where a person looks on.
class Progress {
public:
    explicit Progress(std::string what) : what_(std::move(what)) {}

    void operator()(size_t row, size_t rows) const
    {
        if (shown_)
            std::cerr << "\rMeasuring " << what_ << ": " << row + 1 << " of " << rows << std::flush;
    }
    void clear() const
    {
        if (shown_)
            std::cerr << '\r' << std::string(60, ' ') << '\r' << std::flush;
    }

private:
    std::string what_;
    bool shown_ = ::isatty(STDERR_FILENO) != 0;
};

// The model, and the device where there is one.
struct Subject {
    std::string file;
    Scene scene;
    Result<std::unique_ptr<Renderer>> renderer;

    [[nodiscard]] std::string device() const { return renderer ? (*renderer)->deviceName() : ""; }
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

Result<EvaluatorReport> measureEvaluators(const Subject& subject, size_t count)
{
    EvaluatorReport report;
    describe(subject.scene, report);
    if (subject.renderer)
        if (auto synced = (*subject.renderer)->sync(subject.scene); !synced)
            return tl::unexpected(synced.error());
    report.file = subject.file;
    report.device = subject.device();
    report.simd = simdTargetInUse();
    report.points = count;
    const MeasuredPoints points = measuredPoints(subject.scene, report.points);
    report.exactPoints = points.exact;
    const Progress progress("evaluators");
    report.rows = app::measureEvaluators(
        {points, report.highestDegree, subject.renderer ? subject.renderer->get() : nullptr,
         subject.renderer ? "" : subject.renderer.error().sentence(), progress});
    progress.clear();
    return report;
}

PathReport measurePaths(const Subject& subject, const MeasureRequest& request)
{
    PathReport report{subject.file, {}, request.ofPaths, {}, visibleKsQuads(subject.scene)};
    if (subject.renderer)
        report.device = (*subject.renderer)->deviceInfo();
    Frame& frame = report.request.frame;
    frame.camera = *namedView(request.view, framedPoints(subject.scene),
                              static_cast<double>(frame.width) / frame.height, false);
    report.request.flight = flightAround(subject.scene, static_cast<size_t>(request.flight),
                                         static_cast<double>(frame.width) / frame.height);
    if (!subject.renderer) {
        report.rows =
            plannedRows(report.request, [&](PathId) { return subject.renderer.error().sentence(); });
        return report;
    }
    PathMeasurement measurement(**subject.renderer, subject.scene, report.request);
    const Progress progress("paths");
    do
        progress(std::min(measurement.rowsDone(), measurement.rows().size() - 1), measurement.rows().size());
    while (measurement.step());
    progress.clear();
    report.rows = measurement.rows();
    return report;
}

// Without a device the rows of the GPU say why; a device that was asked for must be there.
Result<Subject> subjectOf(const MeasureTexts& texts)
{
    auto scene = readModel(texts.file);
    if (!scene)
        return tl::unexpected(scene.error());
    const auto isVisible = [](const auto& entry) { return entry.second->visible; };
    if (std::none_of(scene->objects().begin(), scene->objects().end(), isVisible))
        return tl::unexpected<Error>(
            {"The model holds no surface to measure", texts.file, "Choose another model"});
    Subject subject{std::filesystem::path(texts.file).filename().string(), std::move(*scene),
                    Renderer::create({texts.device, false})};
    if (!subject.renderer && texts.device)
        return tl::unexpected(subject.renderer.error());
    return subject;
}

// What was measured, in every form.
struct Findings {
    std::string tables;
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    std::vector<Plot> plots;
};

Result<Findings> measure(const MeasureTexts& texts, const MeasureRequest& request)
{
    const auto subject = subjectOf(texts);
    if (!subject)
        return tl::unexpected(subject.error());
    Findings findings;
    if (request.paths) {
        const PathReport report = measurePaths(*subject, request);
        findings.tables = tableOf(report) + (request.evaluators ? "\n" : "");
        findings.json = jsonOf(report);
        findings.plots = plotsOf(report);
    }
    if (request.evaluators) {
        const auto report = measureEvaluators(*subject, static_cast<size_t>(texts.points));
        if (!report)
            return tl::unexpected(report.error());
        findings.tables += tableOf(*report);
        findings.json.update(jsonOf(*report));
        findings.plots.push_back(plotOf(*report));
    }
    return findings;
}

Result<void> checkPlot(const MeasureTexts& texts)
{
    if (!texts.plot)
        return {};
    checkOutput("--plot", *texts.plot, ".svg", texts.file);
    return checkPlace(*texts.plot);
}

int run(const MeasureTexts& texts)
{
    const MeasureRequest request = parse(texts);
    if (const auto place = checkPlot(texts); !place)
        return failed(place.error());
    const auto findings = measure(texts, request);
    if (!findings)
        return failed(findings.error());
    if (texts.plot)
        if (const auto written = writeFiles(
                {{*texts.plot, [&](QIODevice& device) { return writeSvg(findings->plots, device); }}});
            !written)
            return failed(written.error());
    std::cout << (texts.json ? textOf(findings->json) : findings->tables);
    return kDone;
}

}  // namespace

void addMeasureCommand(CLI::App& app, int& exitCode)
{
    const auto texts = std::make_shared<MeasureTexts>();
    CLI::App* command = app.add_subcommand(
        "measure", "Measure on this machine what each path and each evaluator costs and how far it is off");
    addMeasureOptions(*command, *texts);
    command->callback([texts, &exitCode] { exitCode = run(*texts); });
}

}  // namespace knotspan::app
