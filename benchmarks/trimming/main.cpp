// What trimming costs: the time of a frame of a model, against the same model without its trim loops.
//
// Both are drawn in turns, from six views each, in the same run. Compared is the median.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <sstream>

#include <CLI/CLI.hpp>

#include "model/formats/format_list.h"
#include "renderer/renderer.h"

namespace {

using namespace knotspan;

struct Request {
    std::string file;
    std::string paths;
    std::string size = "1280x800";
    std::string shading = "shaded";
    bool sharpEdges = false;
    int frames = 3;
    int rounds = 3;
    double tolerancePx = 0.5;
    int width = 0;
    int height = 0;
};

// A sheet with as many holes as asked for, where no file is named.
Scene sheets(int count)
{
    Scene scene;
    const auto knots = KnotVector::clampedUniform(1, 1);
    const double half = std::sqrt(0.5);
    std::vector<TrimPoint> points;
    const Vec2 corners[] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    for (int k = 0; k < 9; ++k)
        points.push_back({Vec2(0.5) + 0.3 * corners[k], k % 2 == 0 ? 1 : half});
    const TrimLoop hole{
        false,
        {TrimCurve::create(KnotVector::create(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}).value(), points)
             .value()}};
    const int side = static_cast<int>(std::ceil(std::sqrt(count)));
    for (int k = 0; k < count; ++k) {
        const Vec3 at(k % side, k / side, 0);
        SceneObject object{
            .surface =
                NurbsSurface::create(
                    knots, knots,
                    {{at, 1}, {at + Vec3(0, 1, 0), 1}, {at + Vec3(1, 0, 0), 1}, {at + Vec3(1, 1, 0), 1}})
                    .value()};
        object.trimLoops = {hole};
        scene.add(std::move(object));
    }
    return scene;
}

Scene withoutLoops(const Scene& scene)
{
    Scene whole = scene;
    for (const auto& [id, object] : scene.objects()) {
        SceneObject copy = *object;
        copy.trimLoops.clear();
        whole.exchange(id, std::make_shared<const SceneObject>(std::move(copy)));
    }
    return whole;
}

int fail(const Error& error)
{
    std::fprintf(stderr, "benchmark_trimming: %s\n", error.sentence().c_str());
    return EXIT_FAILURE;
}

struct Times {
    std::vector<double> ms;
    double processorMs = 0;  // of all threads, the software driver's too
    FrameStats stats;

    [[nodiscard]] double median() const
    {
        std::vector<double> sorted = ms;
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
    }
};

// From each view once untimed: shaders are compiled, and culling by occlusion has a frame to start from.
Result<void> drawRound(Renderer& renderer, const Scene& scene, Frame frame, const Request& request, Times& to)
{
    if (const auto synced = renderer.sync(scene); !synced)
        return synced;
    for (const char* view : {"iso", "front", "back", "left", "right", "top"}) {
        frame.camera =
            namedView(view, scene.hullPoints(), static_cast<double>(frame.width) / frame.height, false)
                .value();
        for (int k = 0; k <= request.frames; ++k) {
            const auto start = std::chrono::steady_clock::now();
            const std::clock_t worked = std::clock();
            auto stats = renderer.draw(frame);
            if (!stats)
                return tl::unexpected(stats.error());
            if (k > 0) {
                to.ms.push_back(
                    std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                        .count());
                to.processorMs += 1e3 * static_cast<double>(std::clock() - worked) / CLOCKS_PER_SEC;
            }
            to.stats = std::move(*stats);
        }
    }
    return {};
}

Result<void> measure(Renderer& renderer, const Scene& scene, const Request& request)
{
    const Scene whole = withoutLoops(scene);
    std::printf("%zu faces on %s, %d x %d, %g px\n", scene.objects().size(), renderer.deviceName().c_str(),
                request.width, request.height, request.tolerancePx);
    std::printf("%-22s %10s %10s %10s %8s %10s\n", "path", "trimmed", "whole ms", "trimmed ms", "ratio",
                "processor");
    for (const PathInfo& path : paths()) {
        const std::string& asked = request.paths;
        if ((!asked.empty() && ("," + asked + ",").find("," + path.name + ",") == std::string::npos) ||
            !renderer.whyUnavailable(path.id).empty())
            continue;
        Frame frame;
        frame.width = request.width;
        frame.height = request.height;
        frame.tolerancePx = request.tolerancePx;
        frame.path = path.id;
        frame.culling = defaultCulling();
        frame.smoothEdges = !request.sharpEdges;
        frame.shading = findShading(request.shading).value_or(Shading::shaded);
        Times times[2];
        for (int round = 0; round < request.rounds; ++round)
            for (const int trimmed : {0, 1})
                if (auto drawn =
                        drawRound(renderer, trimmed == 0 ? whole : scene, frame, request, times[trimmed]);
                    !drawn)
                    return drawn;
        std::printf("%-22s %10llu %10.2f %10.2f %8.2f %10.2f\n", path.name.c_str(),
                    static_cast<unsigned long long>(times[1].stats.surfacesTrimmed), times[0].median(),
                    times[1].median(), times[1].median() / times[0].median(),
                    times[1].processorMs / times[0].processorMs);
        std::fflush(stdout);
    }
    return {};
}

}  // namespace

int main(int argc, char** argv)
{
    Request request;
    CLI::App app("What trimming costs: each path's time with a model's trim loops, against without.");
    app.add_option("file", request.file, "Model to read; default: 1,024 sheets with a hole in each");
    app.add_option("--paths", request.paths, "Names with commas between them; default: all");
    app.add_option("--size", request.size, "Of the picture")->capture_default_str();
    app.add_option("--shading", request.shading, "As in render")->capture_default_str();
    app.add_flag("--sharp-edges", request.sharpEdges, "As in render");
    app.add_option("--frames", request.frames, "For each of six views in a round")->capture_default_str();
    app.add_option("--rounds", request.rounds, "Of both in turns")->capture_default_str();
    app.add_option("--tolerance", request.tolerancePx, "Pixels")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    if (std::sscanf(request.size.c_str(), "%5dx%5d", &request.width, &request.height) != 2)
        return fail({"'" + request.size + "' should be like 1280x800", {}, {}});
    Scene scene = request.file.empty() ? sheets(1024) : Scene();
    if (!request.file.empty()) {
        auto read = formats::read(request.file);
        if (!read)
            return fail(read.error());
        scene = std::move(*read);
    }
    const auto renderer = Renderer::create({});
    if (!renderer)
        return fail(renderer.error());
    const auto measured = measure(**renderer, scene, request);
    return measured ? EXIT_SUCCESS : fail(measured.error());
}
