#include <algorithm>
#include <iostream>
#include <memory>
#include <sstream>

#include <QIODevice>
#include <QImage>

#include "app/commands.h"
#include "app/compared_units.h"
#include "app/output.h"
#include "app/render_options.h"
#include "model/mesh/deviation_map.h"
#include "renderer/leak_count.h"
#include "renderer/measurement/closed_model.h"
#include "renderer/renderer.h"
#include "ui/viewport/friend_lines.h"

namespace knotspan::app {
namespace {

// How far the model is from the other one, told in a sentence and for the picture.
Result<SharedSurfaceNumbers> deviationsOf(const RenderTexts& texts, const Scene& scene)
{
    const auto reference = readModel(texts.against);
    if (!reference)
        return tl::unexpected(reference.error());
    const ComparedUnits units = comparedUnits(texts.file, scene, texts.against, *reference);
    const auto map = deviationMap(scene, *reference, units.scale);
    if (!map)
        return tl::unexpected(map.error());
    for (const std::string& note : map->notes)
        tell(note);
    std::ostringstream said;
    const MeshDistance& found = map->figures;
    said << "largest distance " << found.largest << " at (" << found.at.x << ", " << found.at.y << ", "
         << found.at.z << "), mean " << found.mean << ", to within " << map->uncertainty() << ' '
         << units.name << "; colours to within about " << map->accuracy << ' ' << units.name;
    tell(said.str());
    return map->distances;
}

struct Drawn {
    Picture picture;
    FrameStats stats;
};

// As `scene` has them before anything moves.
std::vector<EdgeLine> friendLinesOf(const Scene& scene)
{
    SceneFriends friends;
    friends.follow(scene);
    return friendLines(friends);
}

Frame frameFor(const RenderTexts& texts, const RenderRequest& request, const Scene& scene, PathId path)
{
    Frame frame;
    frame.camera = cameraFor(texts, request, scene);
    frame.width = request.size.width;
    frame.height = request.size.height;
    frame.path = path;
    frame.culling = request.culling;
    frame.countWrongCulls = texts.countWrong;
    frame.sampling = request.sampling;
    frame.evaluator = request.evaluator;
    frame.tolerancePx = texts.tolerance.value_or(frame.tolerancePx);
    frame.shading = request.shading;
    frame.look = request.look;
    frame.overlays.controlNets = texts.net;
    frame.overlays.knotLines = texts.knots;
    frame.overlays.outlines = texts.outlines;
    frame.smoothEdges = !texts.sharpEdges;
    if (texts.friends)
        frame.overlays.edgeLines = friendLinesOf(scene);
    return frame;
}

Result<Drawn> draw(Renderer& renderer, const Scene& scene, Frame frame, const RenderRequest& request,
                   int count)
{
    std::vector<FrameStats> stats;
    for (int k = 0; k < count; ++k) {
        const DeformedScene moved =
            deformedFor(pathInfo(frame.path).drawsFromDevice, scene, request.deformation, k);
        if (auto synced = renderer.sync(moved.scene, moved.joins); !synced)
            return tl::unexpected(synced.error());
        frame.wave = moved.wave;
        auto drawn = renderer.draw(frame);
        if (!drawn)
            return tl::unexpected(drawn.error());
        stats.push_back(std::move(*drawn));
    }
    auto picture = renderer.capture();
    if (!picture)
        return tl::unexpected(picture.error());
    Drawn drawn{std::move(*picture), combined(stats)};
    if (frame.shading == Shading::error && isClosedModel(scene)) {
        const auto shown = renderer.captureKsQuads();
        if (!shown)
            return tl::unexpected(shown.error());
        const double error = std::max(frame.tolerancePx, drawn.stats.errorPxMax.value_or(0));
        drawn.stats.leakPixels =
            countLeaks(deformed(scene, request.deformation, count - 1), frame, *shown, error);
    }
    return drawn;
}

Result<Drawn> render(const RenderTexts& texts, const RenderRequest& request)
{
    const auto scene = readModel(texts.file);
    if (!scene)
        return tl::unexpected(scene.error());
    if (scene->bounds().isEmpty())
        return tl::unexpected<Error>({"The model holds nothing to show", texts.file, "Choose another model"});
    auto renderer = Renderer::create({texts.device, false});
    if (!renderer)
        return tl::unexpected(renderer.error());
    const PathId path = request.path.value_or((*renderer)->bestPath());
    if (const std::string why = (*renderer)->whyUnavailable(path); !why.empty())
        return tl::unexpected<Error>({why.back() == '.' ? why.substr(0, why.size() - 1) : why,
                                      "--path " + pathInfo(path).name, "Choose another path"});
    if (texts.tolerance && !pathInfo(path).followsTolerance)
        tell("The tolerance changes nothing here: " + pathInfo(path).name + " is " +
             pathInfo(path).description + ". The path tessellation follows it.");
    Frame frame = frameFor(texts, request, *scene, path);
    if (!texts.against.empty()) {
        auto deviations = deviationsOf(texts, *scene);
        if (!deviations)
            return tl::unexpected(deviations.error());
        frame.deviations = *std::move(deviations);
    }
    return draw(**renderer, *scene, frame, request, texts.frames);
}

Result<void> write(const RenderTexts& texts, const Drawn& drawn)
{
    const Picture& picture = drawn.picture;
    const QImage image(picture.rgba.data(), picture.width, picture.height, picture.width * 4,
                       QImage::Format_RGBA8888);
    const std::string json = toJson(drawn.stats) + "\n";
    std::vector<OutputFile> files{
        {texts.output, [&](QIODevice& device) { return image.save(&device, "PNG"); }}};
    if (!texts.stats.empty() && texts.stats != "-")
        files.push_back({texts.stats, [&](QIODevice& device) {
                             const auto size = static_cast<qint64>(json.size());
                             return device.write(json.data(), size) == size;
                         }});
    if (auto written = writeFiles(files); !written)
        return written;
    if (texts.stats == "-")
        std::cout << json;
    return {};
}

int run(const RenderTexts& texts)
{
    const RenderRequest request = parse(texts);
    const auto drawn = render(texts, request);
    if (!drawn)
        return failed(drawn.error());
    const auto written = write(texts, *drawn);
    return written ? kDone : failed(written.error());
}

}  // namespace

void addRenderCommand(CLI::App& app, int& exitCode)
{
    const auto texts = std::make_shared<RenderTexts>();
    CLI::App* command = app.add_subcommand("render", "Draw a model to a picture, without a display");
    addRenderOptions(*command, *texts);
    command->callback([texts, &exitCode] { exitCode = run(*texts); });
}

}  // namespace knotspan::app
