// What a Renderer is made of, behind its border; here Vulkan failures are exceptions.
#pragma once

#include <chrono>
#include <map>

#include "renderer/culling/cull_pass.h"
#include "renderer/culling/depth_pyramid.h"
#include "renderer/culling/wrong_culls.h"
#include "renderer/frame_targets.h"
#include "renderer/overlays/control_net.h"
#include "renderer/overlays/edge_lines.h"
#include "renderer/overlays/marks.h"
#include "renderer/overlays/normal_lines.h"
#include "renderer/overlays/reference_meshes.h"
#include "renderer/overlays/rejected_outlines.h"
#include "renderer/overlays/space_lines.h"
#include "renderer/overlays/strokes.h"
#include "renderer/overlays/trim_edges.h"
#include "renderer/paths/surface_path.h"
#include "renderer/point_evaluation.h"
#include "renderer/sampling/sampling_pass.h"
#include "renderer/scene/curvature_range.h"
#include "renderer/scene/deviation_table.h"
#include "renderer/scene/facing_table.h"
#include "renderer/scene/friend_sides.h"
#include "renderer/scene/gpu_scene.h"
#include "renderer/scene/shown_sides.h"
#include "renderer/scene/span_places.h"
#include "renderer/scene/wave_pass.h"
#include "renderer/sheet.h"
#include "renderer/stats/gpu_clock.h"
#include "renderer/stats/gpu_counters.h"
#include "renderer/vulkan/window_images.h"

namespace knotspan {

[[nodiscard]] inline bool isByOcclusion(const Frame& frame)
{
    return (frame.culling.bits & CULL_BY_DEPTH) != 0;
}

struct Renderer::Parts {
    Parts(std::unique_ptr<Instance> madeInstance, const RendererOptions& options);

    void sync(const Scene& wanted, Joins joins = Joins::anew);
    FrameStats draw(const Frame& wantedFrame, bool capture);
    [[nodiscard]] bool isPrepared(const Frame& frame) const;
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
    ReferenceMeshes meshes;
    FacingTable facing;
    ShownSides shownSides;
    FriendSides friendSides;
    CurvatureRange curvatureRange;
    SpanPlaces spanPlaces;
    DeviationTable deviations;
    CullPass culling;
    DepthPyramid pyramid;
    WrongCulls wrongCulls;
    SamplingPass sampling;
    WavePass wave;
    ControlNet controlNet;
    RejectedOutlines rejectedOutlines;
    EdgeLines edgeLines;
    NormalLines normalLines;
    Marks marks;
    SpaceLinesOverlay spaceLines;
    Strokes strokes;
    TrimEdges trimEdges;
    SentRecords<float> spanPlaceRecords;
    SentRecords<std::uint32_t> deviationRecords;
    std::map<std::pair<PathId, PathVariant>, std::unique_ptr<SurfacePath>>
        paths;  // made when first drawn with
    std::unique_ptr<FrameTargets> targets;
    std::unique_ptr<Sheet> sheet;  // of frames that stand beside others
    // The last frame that was drawn whole, and the objects whose KSQuads its indices stand for.
    std::optional<Frame> lastFrame;
    std::vector<Resident> lastResidents;
    bool deviceLost = false;

    // What the last frame is shown in.
    [[nodiscard]] Image& shown() { return lastFrame->pane ? sheet->image() : targets->colour(); }

private:
    void forgetScene();
    [[nodiscard]] Specialization specializationFor(Evaluator evaluator) const;
    SurfacePath& pathFor(PathId id, const PathVariant& variant);
    [[nodiscard]] PathVariant variantOf(const Frame& frame, Evaluator evaluator) const;
    void checkFrame(const Frame& frame) const;
    void fitTargets(const Frame& frame);
    void fitSheet(const Frame& frame);
    void updateFrameRecord(const Frame& frame, SurfacePath& path, SamplingRule rule, bool capture);
    void prepareCulling(Frame& frame, const SurfacePath& path);
    // Where the frame's culling camera stands still: what it drops is noted then, and kept. Returns the bytes
    // that travelled.
    VkDeviceSize noteVerdicts(const Frame& frame, const PathVariant& variant, SurfacePath& path,
                              SamplingRule rule, std::chrono::steady_clock::time_point started);
    void provideVerdicts(std::uint32_t ksquads);
    static void waitForVerdicts(VkCommandBuffer commands);
    // Whether the culling pass runs: for the paths that draw its list, and to note what is dropped.
    [[nodiscard]] bool usesCullPass(const Frame& frame, const SurfacePath& path) const;
    void uploadRecord(const gpu::FrameRecord& record);
    [[nodiscard]] std::optional<ModeCounts> wronglyCulled(const Frame& frame, const SurfacePath& path,
                                                          SamplingRule rule) const;
    FrameStats statsOf(const Frame& frame, const SurfacePath& path, SamplingRule rule, VkDeviceSize uploaded);
    // Draws until the list of tiles had room. Returns the bytes that travelled.
    VkDeviceSize drawWhole(const Frame& frame, SurfacePath& path, SamplingRule rule, bool capture,
                           std::chrono::steady_clock::time_point started);
    void record(VkCommandBuffer commands, const Frame& frame, const SurfacePath& path);
    [[nodiscard]] bool hasTrimEdges(const Frame& frame) const;
    void prepareOverlays(const Overlays& overlays);
    void drawOverlays(VkCommandBuffer commands, const Frame& frame) const;
    // The objects on the device whose nets are shown.
    [[nodiscard]] std::vector<const Resident*> shownNets(const Overlays& overlays) const;
    [[nodiscard]] std::vector<CapturedVertex> named(const std::vector<gpu::CapturedRecord>& records) const;
    void pickControlPoint(const Vec2& pixel, double radiusPx, Pick& to) const;
    [[nodiscard]] std::optional<PickedPlace> pickedPlace(const Vec2& pixel) const;

    Buffer frameBuffer_;
    std::optional<gpu::FrameRecord> frameRecord_;  // what the device holds
    // What a culling camera that stands still said of each KSQuad, and for which frame from there.
    struct NotedVerdicts {
        Frame asked;
        PathVariant variant;
        CullSet culling;  // as applied
        std::optional<ModeCounts> wronglyCulled;
    };
    std::optional<NotedVerdicts> noted_;
    Buffer verdicts_;
    std::uint32_t verdictFlag_ = 0;    // of the frames that are drawn now: FRAME_..._VERDICTS or none
    bool rebuiltForVerdicts_ = false;  // the scene was, since the last frame
    std::unique_ptr<PointEvaluation> pointEvaluation_;  // made when first asked
    Scene wanted_;                                      // what the last sync() asked for
    int largestDegree_ = 1;                             // of it
    Evaluator wish_ = Evaluator::automatic;             // of the last frame
    bool sceneIsHeld_ = true;                           // the device has it
    std::uint64_t firstUpload_ = 0;
    // Of the last frame.
    gpu::Counters counted_{};
    SideTables sides_;
    double cpuMs_ = 0;          // preparing and recording, with the syncs since the frame before
    double syncMs_ = 0;         // of syncs since the last frame
    FrameWork work_;            // likewise
    double recordingFrom_ = 0;  // processorMs() before and after the last commands
    double recordedAt_ = 0;
    ResidentChanges::Moment lastResidentsAt_ = 0;
};

// The culling modes whose wrong decisions are counted.
[[nodiscard]] std::uint32_t judgedBits(const Frame& frame, const SurfacePath& path, SamplingRule rule);

struct Swapchain::Parts {
    WindowImages images;
};

}  // namespace knotspan
