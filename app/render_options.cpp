#include "app/render_options.h"

#include <glm/geometric.hpp>

#include "app/drawing_options.h"
#include "renderer/scene/framed_points.h"

namespace knotspan::app {
namespace {

CullSet parseCulling(const std::string& text)
{
    if (text.empty())
        return defaultCulling();
    if (const auto set = parseCullSet(text))
        return *set;
    auto known = namesOf(cullModes());
    known.insert(known.begin(), "none");
    refuseName("--culling", text, known);
}

void parseEye(const RenderTexts& texts, RenderRequest& request)
{
    if (texts.eye.empty()) {
        if (!texts.target.empty() || !texts.up.empty())
            throw CLI::ValidationError(texts.target.empty() ? "--up" : "--target", "needs --eye");
        return;
    }
    request.eye = parseVec3("--eye", texts.eye);
    if (!texts.target.empty())
        request.target = parseVec3("--target", texts.target);
    if (request.target && *request.target == *request.eye)
        throw CLI::ValidationError("--target", "is where the eye is");
    if (!texts.up.empty())
        request.up = parseVec3("--up", texts.up);
    if (request.up && glm::length(*request.up) == 0)
        throw CLI::ValidationError("--up", "is no direction");
}

bool areAlong(const Vec3& a, const Vec3& b)
{
    return glm::length(glm::cross(a, b)) <= 1e-9 * glm::length(a) * glm::length(b);
}

}  // namespace

void addRenderOptions(CLI::App& command, RenderTexts& texts)
{
    const auto text = [&](const char* name, std::string& value, const std::string& help, const char* type) {
        return addText(command, name, value, help, type);
    };
    addModel(command, texts.file);
    text("-o,--output", texts.output, "Picture to write", "OUT.png")->required();
    text("--size", texts.size, "Size in pixels (default 1280x800)", "WxH");
    text("--path", texts.path, "How triangles are made: " + listed(paths()), "P");
    text("--culling", texts.culling, "What is dropped unseen: none, " + listed(cullModes()), "A,B");
    text("--sampling", texts.sampling,
         "How finely: " + joined(samplingNames(), ", ") + " (default: the path's own)", "S");
    command
        .add_option("--tolerance", texts.tolerance, "How far the picture may be off, in pixels (default 0.5)")
        ->check(within(0.01, 1000))
        ->type_name("PX");
    text("--evaluator", texts.evaluator,
         "How surface points are computed: " + listed(evaluators()) + " (default auto)", "E");
    auto* view =
        text("--view", texts.view, "From where: " + joined(namedViews(), ", ") + " (default iso)", "VIEW");
    text("--eye", texts.eye, "Where the eye is", "X,Y,Z")->excludes(view);
    text("--target", texts.target, "What it looks at (default: the model's middle)", "X,Y,Z");
    text("--up", texts.up, "What is up (default: z)", "X,Y,Z");
    command.add_flag("--orthographic", texts.orthographic, "Without perspective");
    command.add_option("--fov", texts.fov, "Vertical angle of view in degrees")
        ->capture_default_str()
        ->check(within(0.1, 170))
        ->type_name("DEG");
    text("--shading", texts.shading, "What colours say: " + listed(shadings()), "S");
    text("--against", texts.against, "Of deviation: the model from which distances are taken", "FILE");
    addLookOptions(command, texts.look);
    command.add_flag("--net", texts.net, "Draw the control nets, too");
    command.add_flag("--knots", texts.knots, "Draw the borders of the KSQuads, too");
    command.add_flag("--outlines", texts.outlines,
                     "Draw the borders of the surfaces, too: of trimmed ones of what is left");
    command.add_flag("--sharp-edges", texts.sharpEdges,
                     "Draw borders of trimmed surfaces by whole pixels: faster than smooth ones");
    command.add_flag("--friends", texts.friends,
                     "Draw the edges where surfaces meet, too, in colours that say how smoothly");
    command.add_option("--frames", texts.frames, "Frames to draw; the last one is written")
        ->capture_default_str()
        ->check(within(1, 1e6))
        ->type_name("N");
    text("--deform", texts.deform, "What moves between frames: " + joined(deformationNames(), ", "), "WHAT");
    auto* stats =
        text("--stats", texts.stats, "Where to write the figures as JSON; - is standard output", "FILE");
    command
        .add_flag("--count-wrong", texts.countWrong, "Count in --stats what culling drops though it shows")
        ->needs(stats);
    addDevice(command, texts.device);
}

RenderRequest parse(const RenderTexts& texts)
{
    checkOutput("--output", texts.output, ".png", texts.file);
    for (const std::string& other : {texts.file, texts.output, texts.against})
        if (texts.stats != "-" && isSameFile(texts.stats, other))
            throw CLI::ValidationError("--stats",
                                       "'" + texts.stats + "' would be written over; choose another file");
    RenderRequest request;
    if (!texts.size.empty())
        request.size = parseSize("--size", texts.size);
    if (!texts.path.empty())
        request.path = parseName("--path", texts.path, namesOf(paths()), findPath);
    request.culling = parseCulling(texts.culling);
    if (!texts.sampling.empty())
        request.sampling = parseSampling(texts.sampling);
    if (!texts.evaluator.empty())
        request.evaluator = parseName("--evaluator", texts.evaluator, namesOf(evaluators()), findEvaluator);
    if (!texts.shading.empty())
        request.shading = parseName("--shading", texts.shading, namesOf(shadings()), findShading);
    if (texts.against.empty() == (request.shading == Shading::deviation))
        throw CLI::ValidationError("--against", "goes with --shading deviation, and that with it");
    if (!texts.against.empty() && !texts.deform.empty())
        throw CLI::ValidationError("--deform", "moves what --against would measure");
    request.look = parseLook(texts.look, request.shading);
    if (!texts.deform.empty())
        request.deformation = parseName("--deform", texts.deform, deformationNames(), findDeformation);
    if (!texts.view.empty())
        checkView(texts.view);
    parseEye(texts, request);
    return request;
}

Camera cameraFor(const RenderTexts& texts, const RenderRequest& request, const Scene& scene)
{
    if (!request.eye) {
        const double aspect = static_cast<double>(request.size.width) / request.size.height;
        const std::string view = texts.view.empty() ? "iso" : texts.view;
        return *namedView(view, framedPoints(scene), aspect, texts.orthographic, texts.fov);
    }
    Camera camera;
    camera.eye = *request.eye;
    camera.target = request.target.value_or(scene.bounds().centre());
    if (camera.target == camera.eye)
        camera.target += Vec3(0, 1, 0);
    camera.up = request.up.value_or(Vec3(0, 0, 1));
    // Looking straight up or down: any other direction will do.
    if (areAlong(camera.up, camera.target - camera.eye))
        camera.up = areAlong(Vec3(0, 1, 0), camera.target - camera.eye) ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    camera.orthographic = texts.orthographic;
    camera.verticalFovDegrees = texts.fov;
    return camera;
}

}  // namespace knotspan::app
