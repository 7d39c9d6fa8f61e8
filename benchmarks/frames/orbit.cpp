#include "benchmarks/frames/orbit.h"

#include <glm/gtc/constants.hpp>

#include "model/samples/sample_list.h"

namespace knotspan::benchmarks {

namespace {

template <class Value>
Spread spreadOver(const std::vector<FrameStats>& views, const Value& value)
{
    std::vector<double> values;
    for (size_t view = 0; view < views.size(); ++view)
        values.push_back(static_cast<double>(value(views[view], view)));
    return spreadOf(std::move(values));
}

double frameMs(const FrameStats& stats)
{
    return stats.gpuMs.median + stats.cpuMs.median;
}

double shareOf(double part, double whole)
{
    return whole > 0 ? part / whole : 0;
}

void fill(OrbitRow& row, const std::vector<FrameStats>& views, const std::vector<FrameStats>& first)
{
    row.inForce = views.back().culling;
    row.ksquads = views.back().ksquads;
    row.gpuMs = spreadOver(views, [](const FrameStats& stats, size_t) { return stats.gpuMs.median; });
    for (size_t stage = 0; stage < kGpuStageCount; ++stage)
        row.stageMs[stage] = spreadOver(
            views, [stage](const FrameStats& stats, size_t) { return stats.stageMs[stage].median; });
    row.cpuMs = spreadOver(views, [](const FrameStats& stats, size_t) { return stats.cpuMs.median; });
    row.gpuShare = spreadOver(views, [&](const FrameStats& stats, size_t view) {
        return shareOf(stats.gpuMs.median, first[view].gpuMs.median);
    });
    row.frameShare = spreadOver(views, [&](const FrameStats& stats, size_t view) {
        return shareOf(frameMs(stats), frameMs(first[view]));
    });
    row.ksquadsDrawn = spreadOver(views, [](const FrameStats& stats, size_t) { return stats.ksquadsDrawn; });
    row.evaluations = spreadOver(views, [](const FrameStats& stats, size_t) { return stats.evaluations; });
    row.triangles = spreadOver(views, [](const FrameStats& stats, size_t) { return stats.triangles; });
    for (size_t mode = 0; mode < kCullModeCount; ++mode)
        row.culled[mode] =
            spreadOver(views, [mode](const FrameStats& stats, size_t) { return stats.ksquadsCulled[mode]; });
}

}  // namespace

Result<OrbitBenchmark> OrbitBenchmark::open(OrbitRequest request)
{
    OrbitBenchmark benchmark(std::move(request));
    for (size_t set = 0; set < benchmark.request_.cullings.size(); ++set) {
        auto renderer = Renderer::create(benchmark.request_.renderer);
        if (!renderer)
            return tl::unexpected(renderer.error());
        benchmark.renderers_.push_back(std::move(*renderer));
    }
    return benchmark;
}

std::vector<OrbitRow> OrbitBenchmark::measure(const std::string& sample, PathId path, Deformation motion)
{
    std::vector<OrbitRow> rows;
    for (const NamedCulling& culling : request_.cullings) {
        OrbitRow row;
        row.sample = sample;
        row.path = path;
        row.motion = motion;
        row.culling = culling.name;
        row.unavailable = renderers_.front()->whyUnavailable(path);
        rows.push_back(std::move(row));
    }
    if (!rows.front().unavailable.empty())
        return rows;
    const Scene rest = findSample(sample)->make();
    const auto drawn = draw(rest, frameOf(rest, path), motion);
    for (size_t set = 0; set < rows.size(); ++set) {
        if (drawn) {
            fill(rows[set], (*drawn)[set], drawn->front());
            continue;
        }
        rows[set].unavailable = drawn.error().sentence();
        rows[set].failed = true;
    }
    return rows;
}

Frame OrbitBenchmark::frameOf(const Scene& rest, PathId path) const
{
    Frame frame;
    frame.width = request_.width;
    frame.height = request_.height;
    frame.tolerancePx = request_.tolerancePx;
    frame.path = path;
    const double aspect = static_cast<double>(frame.width) / frame.height;
    frame.camera = namedView("iso", rest.hullPoints(), aspect, false).value();
    return frame;
}

// Once round. The view before the first one is drawn, too, and not counted: it compiles shaders, and is what
// culling by occlusion saw last.
Result<std::vector<OrbitBenchmark::Views>> OrbitBenchmark::draw(const Scene& rest, const Frame& first,
                                                                Deformation motion)
{
    const size_t sets = renderers_.size();
    std::vector<Views> drawn(sets);
    for (int view = -1; view < request_.views; ++view) {
        Frame frame = first;
        frame.camera.orbit(glm::two_pi<double>() * view / request_.views, 0);
        const DeformedScene moved = deformedFor(pathInfo(frame.path).drawsFromDevice, rest, motion, view + 2);
        frame.wave = moved.wave;
        for (size_t turn = 0; turn < sets; ++turn) {
            // Nobody is always the first.
            const size_t set = (turn + static_cast<size_t>(view + 1)) % sets;
            auto stats = drawView(set, moved, frame);
            if (!stats)
                return tl::unexpected(stats.error());
            if (view >= 0)
                drawn[set].push_back(std::move(*stats));
        }
    }
    return drawn;
}

Result<FrameStats> OrbitBenchmark::drawView(size_t set, const DeformedScene& moved, Frame frame)
{
    frame.culling = request_.cullings[set].set;
    if (auto synced = renderers_[set]->sync(moved.scene, moved.joins); !synced)
        return tl::unexpected(synced.error());
    return renderers_[set]->draw(frame);
}

}  // namespace knotspan::benchmarks
