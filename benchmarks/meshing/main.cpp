// Our meshes beside OpenCASCADE's at equal measured deviation, on one core: how many triangles, how fast.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include <CLI/CLI.hpp>

#include "benchmarks/meshing/occt_mesh.h"
#include "model/core/spread.h"
#include "model/samples/sample_list.h"

namespace knotspan::benchmarks {
namespace {

struct Options {
    std::vector<std::string> samples;
    std::vector<double> deviations{1e-2, 1e-3, 1e-4};
    int repeats = 3;
};

struct Ours {
    double deviation = 0;  // asked
    double bound = 0;
    double measured = 0;
    size_t triangles = 0;
    double seconds = 0;
};

Ours meshed(const Scene& scene, double deviation)
{
    const auto start = std::chrono::steady_clock::now();
    const auto mesh = tessellate(scene, {.deviation = deviation});
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!mesh)
        return {deviation, INFINITY, INFINITY, 0, seconds};
    return {deviation, mesh->bound, measuredDeviation(*mesh, scene, false, Threads::one).largest,
            mesh->mesh.triangles.size(), seconds};
}

// The coarsest found that measures no more: what is asked is searched for, between the measured deviation and
// eight times that.
Ours noWorseThan(const Scene& scene, double measured, int repeats)
{
    double works = measured;
    double fails = 8 * measured;
    Ours best = meshed(scene, works);
    for (int step = 0; step < 12; ++step) {
        const double between = std::sqrt(works * fails);
        const Ours tried = meshed(scene, between);
        if (tried.measured <= measured) {
            works = between;
            if (tried.triangles <= best.triangles)
                best = tried;
        } else {
            fails = between;
        }
    }
    for (int k = 1; k < repeats; ++k)
        best.seconds = std::min(best.seconds, meshed(scene, best.deviation).seconds);
    return best;
}

void compare(const Options& options)
{
    std::printf("%-10s %10s %10s | %10s %10s | %10s %10s %10s %10s | %6s %7s\n", "sample", "deflection",
                "measured", "OCCT: tri", "ms", "ours: tri", "ms", "asked", "bound", "tri x", "speed x");
    std::vector<double> ratios;
    std::vector<double> speeds;
    for (const Sample& sample : samples()) {
        if (!options.samples.empty() &&
            std::find(options.samples.begin(), options.samples.end(), sample.name) == options.samples.end())
            continue;
        const Scene scene = sample.make();
        const double size = scene.bounds().diagonal();
        OcctMesh occt(scene);
        for (const double part : options.deviations) {
            double seconds = occt.make(part * size);
            for (int k = 1; k < options.repeats && seconds < 5; ++k)
                seconds = std::min(seconds, occt.make(part * size));
            const double measured = occt.measured();
            const Ours ours = noWorseThan(scene, measured, options.repeats);
            const double triangles = static_cast<double>(occt.triangleCount());
            ratios.push_back(static_cast<double>(ours.triangles) / triangles);
            speeds.push_back(seconds / ours.seconds);
            std::printf("%-10s %10.3g %10.3g | %10zu %10.2f | %10zu %10.2f %10.3g %10.3g | %6.2f %7.0f\n",
                        sample.name.c_str(), part, measured / size, occt.triangleCount(), 1e3 * seconds,
                        ours.triangles, 1e3 * ours.seconds, ours.deviation / size, ours.bound / size,
                        ratios.back(), speeds.back());
            std::fflush(stdout);
            if (measured > 4 * part * size) {
                std::printf("%-10s misses what it was asked by far: it is asked no finer\n", "OCCT");
                break;
            }
        }
    }
    if (ratios.empty())
        return;
    const Spread triangles = spreadOf(ratios);
    const Spread speed = spreadOf(speeds);
    std::printf(
        "triangles: median %.2f (%.2f to %.2f) times OCCT's; speed: median %.0f (%.0f to %.0f) times\n",
        triangles.median, triangles.min, triangles.max, speed.median, speed.min, speed.max);
}

}  // namespace
}  // namespace knotspan::benchmarks

int main(int argc, char** argv)
{
    knotspan::benchmarks::Options options;
    CLI::App app("Meshes of the samples beside OpenCASCADE's, on one core; lengths are shares of the model's "
                 "diagonal");
    app.add_option("--samples", options.samples, "Which, separated by commas; all unless given")
        ->delimiter(',');
    app.add_option("--deviations", options.deviations, "Deflections that OpenCASCADE is asked for")
        ->delimiter(',');
    app.add_option("--repeats", options.repeats, "The fastest of so many runs counts");
    CLI11_PARSE(app, argc, argv);
    knotspan::benchmarks::compare(options);
    return 0;
}
