#include "app/measure_options.h"

#include "app/drawing_options.h"

namespace knotspan::app {
namespace {

// Results of 4 million points in double are about 1 GB, on the device and here.
constexpr int kMostPoints = 4'000'000;
constexpr PixelSize kDefaultSize{640, 480};

const std::vector<std::string>& parts()
{
    static const std::vector<std::string> names{"paths", "evaluators"};
    return names;
}

// The coarsest first, as in the curves.
std::vector<double> parseTolerances(const std::string& text)
{
    constexpr double kFinest = 0.01;
    constexpr double kCoarsest = 1000;
    std::vector<double> values;
    for (const std::string& word : splitAtCommas(text)) {
        values.push_back(parseNumber("--tolerances", word));
        if (!(values.back() >= kFinest && values.back() <= kCoarsest))
            throw CLI::ValidationError("--tolerances", "'" + word + "' should be from 0.01 to 1000 pixels");
    }
    std::sort(values.begin(), values.end(), std::greater<>());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::vector<Evaluator> parseEvaluators(const std::string& text)
{
    if (text == "all") {
        std::vector<Evaluator> all;
        for (const EvaluatorInfo& info : evaluators())
            if (info.id != Evaluator::automatic)
                all.push_back(info.id);
        return all;
    }
    auto known = namesOf(evaluators());
    known.insert(known.begin(), "all");
    return parseNames("--evaluators", text, known, findEvaluator);
}

std::vector<PathId> allPaths()
{
    std::vector<PathId> ids;
    for (const PathInfo& path : paths())
        ids.push_back(path.id);
    return ids;
}

}  // namespace

void addMeasureOptions(CLI::App& command, MeasureTexts& texts)
{
    const auto text = [&](const char* name, std::string& value, const std::string& help, const char* type) {
        addText(command, name, value, help, type);
    };
    addModel(command, texts.file);
    addJson(command, texts.json);
    command.add_option("--plot", texts.plot, "Drawing of error against time to write, a curve a path")
        ->type_name("OUT.svg");
    text("--only", texts.only, "Measure one part: " + joined(parts(), ", ") + " (default both)", "PART");
    text("--paths", texts.paths, "Which paths (default all): " + listed(paths()), "A,B");
    text("--tolerances", texts.tolerances, "Paths: at which tolerances in pixels (default 4,2,1,0.5,0.25)",
         "PX,PX");
    text("--evaluators", texts.evaluators,
         "Paths: with which evaluators: all, " + listed(evaluators()) + " (default auto)", "A,B");
    text("--deform", texts.deform,
         "Paths: what moves between frames: " + joined(deformationNames(), ", ") + " (default none,all)",
         "A,B");
    text("--sampling", texts.sampling, "Paths: how finely, as in render (default: the path's own rule)", "S");
    text("--size", texts.size, "Paths: size of the picture in pixels (default 640x480)", "WxH");
    text("--view", texts.view, "Paths: from where: " + joined(namedViews(), ", ") + " (default iso)", "VIEW");
    command
        .add_option(
            "--flight", texts.flight,
            "Paths: fly around the model, N views of it in place of --view, as the window's benchmark does")
        ->check(wholeWithin(1, 1000))
        ->type_name("N");
    command
        .add_option("--frames", texts.frames,
                    "Paths: how many frames are timed for a row, after one that is not; fewer where they "
                    "take long")
        ->capture_default_str()
        ->check(wholeWithin(1, 1000))
        ->type_name("N");
    addDevice(command, texts.device);
    command
        .add_option("--points", texts.points, "Evaluators: how many random points, over all visible surfaces")
        ->capture_default_str()
        ->check(wholeWithin(1, kMostPoints))
        ->type_name("N");
    command.footer(
        "A software driver takes a minute or two for a small model, and much longer for a large one. "
        "Fewer\n--paths, --tolerances or --frames and a smaller --size take less.");
}

MeasureRequest parse(const MeasureTexts& texts)
{
    MeasureRequest request;
    if (!texts.only.empty()) {
        if (std::find(parts().begin(), parts().end(), texts.only) == parts().end())
            refuseName("--only", texts.only, parts());
        request.paths = texts.only == "paths";
        request.evaluators = !request.paths;
    }
    PathMeasurementRequest& ofPaths = request.ofPaths;
    ofPaths.frames = texts.frames;
    ofPaths.tolerances = parseTolerances(texts.tolerances.empty() ? "4,2,1,0.5,0.25" : texts.tolerances);
    ofPaths.paths =
        texts.paths.empty() ? allPaths() : parseNames("--paths", texts.paths, namesOf(paths()), findPath);
    if (!texts.evaluators.empty())
        ofPaths.evaluators = parseEvaluators(texts.evaluators);
    if (!texts.deform.empty())
        ofPaths.motions = parseNames("--deform", texts.deform, deformationNames(), findDeformation);
    if (!texts.sampling.empty())
        ofPaths.frame.sampling = parseSampling(texts.sampling);
    if (!texts.view.empty()) {
        checkView(texts.view);
        request.view = texts.view;
    }
    request.flight = texts.flight;
    const PixelSize size = texts.size.empty() ? kDefaultSize : parseSize("--size", texts.size);
    ofPaths.frame.width = size.width;
    ofPaths.frame.height = size.height;
    ofPaths.frame.culling = defaultCulling();
    return request;
}

}  // namespace knotspan::app
