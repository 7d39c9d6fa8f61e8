// An orbit around a model, drawn with several sets of culling modes: what each set is worth.
//
// Each set has a Renderer of its own, and every view is drawn by all of them, one after the other, before the
// next one. So ratios are of the same moments, and culling by occlusion finds what the last view of the same
// set saw.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/core/spread.h"
#include "model/scene/deformation.h"
#include "renderer/renderer.h"

namespace knotspan::benchmarks {

struct NamedCulling {
    std::string name;  // as asked for
    CullSet set;
};

struct OrbitRequest {
    std::vector<std::string> samples;
    std::vector<PathId> paths;
    std::vector<NamedCulling> cullings;  // ratios are to the first
    std::vector<Deformation> motions;
    int width = 1280;
    int height = 800;
    int views = 64;
    double tolerancePx = 0.5;
    RendererOptions renderer;
};

// Of one set on one orbit. Spreads are over the views.
struct OrbitRow {
    std::string sample;
    PathId path{};
    Deformation motion{};
    std::string culling;
    std::string unavailable;                     // why there are no figures, as a sentence
    bool failed = false;                         // though the device can run the path
    std::vector<std::string> inForce;            // the modes that could run
    Spread gpuMs;                                // drawing, by the device's clock
    std::array<Spread, kGpuStageCount> stageMs;  // parts of it
    Spread cpuMs;                                // the model's changes taken over, preparing and recording
    Spread gpuShare;                             // of the first set's, view by view
    Spread frameShare;                           // the same of both together
    std::uint64_t ksquads = 0;
    Spread ksquadsDrawn;
    Spread culled[kCullModeCount];
    Spread evaluations;
    Spread triangles;
};

class OrbitBenchmark {
public:
    // Fails where there is no device.
    [[nodiscard]] static Result<OrbitBenchmark> open(OrbitRequest request);

    [[nodiscard]] const std::string& deviceName() const { return renderers_.front()->deviceName(); }
    [[nodiscard]] const OrbitRequest& request() const { return request_; }

    // A row for each set, in the order of the request.
    [[nodiscard]] std::vector<OrbitRow> measure(const std::string& sample, PathId path, Deformation motion);

private:
    using Views = std::vector<FrameStats>;  // of one set

    explicit OrbitBenchmark(OrbitRequest request) : request_(std::move(request)) {}
    [[nodiscard]] Frame frameOf(const Scene& rest, PathId path) const;
    [[nodiscard]] Result<std::vector<Views>> draw(const Scene& rest, const Frame& first, Deformation motion);
    [[nodiscard]] Result<FrameStats> drawView(size_t set, const DeformedScene& moved, Frame frame);

    OrbitRequest request_;
    std::vector<std::unique_ptr<Renderer>> renderers_;  // one a set
};

}  // namespace knotspan::benchmarks
