// What a Renderer is made of, behind its border; here Vulkan failures are exceptions.
#pragma once

#include <chrono>
#include <map>

#include "renderer/culling/cull_pass.h"
#include "renderer/frame_targets.h"
#include "renderer/overlays/control_net.h"
#include "renderer/paths/surface_path.h"
#include "renderer/point_evaluation.h"
#include "renderer/sampling/sampling_pass.h"
#include "renderer/scene/gpu_scene.h"
#include "renderer/scene/wave_pass.h"
#include "renderer/stats/gpu_clock.h"
#include "renderer/stats/gpu_counters.h"
#include "renderer/vulkan/window_images.h"

namespace knotspan {

struct Renderer::Parts {
    Parts(std::unique_ptr<Instance> madeInstance, const RendererOptions& options);

    void sync(const Scene& wanted, Joins joins = Joins::anew);
    FrameStats draw(const Frame& wantedFrame, bool capture);
    [[nodiscard]] std::vector<HeldMemory> memory() const;
    Pick pick(double x, double y, double radiusPx);
    std::vector<CapturedVertex> captureVertices(const Frame& frame);
    Evaluations evaluate(const std::vector<EvaluationPoint>& points, const EvaluationOptions& options);

    // In this order: each needs those above it.
    std::unique_ptr<Instance> instance;
    Device device;
    Bindings bindings;
    Uploader uploader;
    GpuCounters counters;
    GpuClock clock;
    GpuScene scene;
    CullPass culling;
    SamplingPass sampling;
    WavePass wave;
    ControlNet controlNet;
    std::map<std::pair<PathId, PathVariant>, std::unique_ptr<SurfacePath>>
        paths;  // made when first drawn with
    std::unique_ptr<FrameTargets> targets;
    // The last frame that was drawn whole, and the objects that its indices stand for.
    std::optional<Frame> lastFrame;
    std::vector<ObjectId> lastObjects;
    bool deviceLost = false;

private:
    [[nodiscard]] Specialization specializationFor(Evaluator evaluator) const;
    SurfacePath& pathFor(PathId id, const PathVariant& variant);
    void checkFrame(const Frame& frame) const;
    void fitTargets(const Frame& frame);
    void updateFrameRecord(const Frame& frame, SurfacePath& path, SamplingRule rule, bool capture);
    void uploadRecord(const gpu::FrameRecord& record);
    FrameStats statsOf(const Frame& frame, const SurfacePath& path, SamplingRule rule, VkDeviceSize uploaded);
    // Draws until the list of tiles had room. Returns the bytes that travelled.
    VkDeviceSize drawWhole(const Frame& frame, SurfacePath& path, SamplingRule rule, bool capture,
                           std::chrono::steady_clock::time_point started);
    void record(VkCommandBuffer commands, const Frame& frame, const SurfacePath& path);
    void drawOverlays(VkCommandBuffer commands, const Overlays& overlays) const;
    [[nodiscard]] std::vector<CapturedVertex> named(const std::vector<gpu::CapturedRecord>& records) const;
    [[nodiscard]] std::optional<PickedControlPoint> nearestControlPoint(const Vec2& pixel,
                                                                        double radiusPx) const;

    Buffer frameBuffer_;
    std::optional<gpu::FrameRecord> frameRecord_;       // what the device holds
    std::unique_ptr<PointEvaluation> pointEvaluation_;  // made when first asked
    Scene wanted_;                                      // what the last sync() asked for
    int largestDegree_ = 1;                             // of it
    Evaluator wish_ = Evaluator::automatic;             // of the last frame
    bool sceneIsHeld_ = true;                           // the device has it
    std::uint64_t firstUpload_ = 0;
    // Of the last frame.
    gpu::Counters counted_{};
    double cpuMs_ = 0;   // preparing and recording, with the syncs since the frame before
    double syncMs_ = 0;  // of syncs since the last frame
};

struct Swapchain::Parts {
    WindowImages images;
};

}  // namespace knotspan
