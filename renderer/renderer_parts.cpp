#include "renderer/renderer_parts.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glm/trigonometric.hpp>

#include "model/core/check.h"

namespace knotspan {

namespace {

// The area rule's KSDie at a tolerance: half a pixel of tolerance gives the papers' 8 pixels.
constexpr double kDiePxPerTolerance = 16.0;

double pixelsPerUnit(const Camera& camera, int height)
{
    const double half = std::tan(glm::radians(camera.verticalFovDegrees) * 0.5);
    return 0.5 * height / (camera.orthographic ? half * camera.distance() : half);
}

// A counter of two words.
std::uint64_t wide(const gpu::uint (&words)[2])
{
    return words[0] + (std::uint64_t{words[1]} << 32U);
}

double millisecondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Renderer::Parts::Parts(std::unique_ptr<Instance> madeInstance, const RendererOptions& options)
    : instance(std::move(madeInstance)),
      device(*instance, options.device),
      bindings(device),
      uploader(device),
      counters(device, bindings),
      clock(device),
      scene(bindings, uploader),
      culling(device, bindings),
      controlNet(device, bindings)
{
    bindings.provide(BINDING_FRAME, frameBuffer_, sizeof(gpu::FrameRecord));
}

void Renderer::Parts::sync(const Scene& wanted)
{
    wanted_ = wanted;
    largestDegree_ = largestDegree(visibleObjects(wanted_));
    sceneIsHeld_ = false;
    scene.useEvaluator(chosenEvaluator(wish_, largestDegree_, Precision::float32));
    scene.sync(wanted_);
    sceneIsHeld_ = true;
}

SurfacePath& Renderer::Parts::pathFor(PathId id, Evaluator evaluator)
{
    const PathFactory& factory = pathFactory(id);
    if (const std::string reason = factory.whyUnavailable(device); !reason.empty())
        throw VulkanError(
            {"The path " + factory.info.name + " cannot run here. " + reason, {}, "Choose another path"});
    auto& path = paths[{id, evaluator}];
    if (!path)
        path = factory.create(device, bindings, evaluator);
    return *path;
}

void Renderer::Parts::checkFrame(const Frame& frame) const
{
    const auto most = static_cast<int>(std::min(device.limits().maxImageDimension2D, 16384U));
    if (frame.width < 1 || frame.height < 1 || frame.width > most || frame.height > most)
        throw VulkanError({"A picture of " + std::to_string(frame.width) + " by " +
                               std::to_string(frame.height) + " pixels cannot be drawn",
                           {},
                           "Choose sizes from 1 to " + std::to_string(most)});
}

void Renderer::Parts::fitTargets(const Frame& frame)
{
    const VkExtent2D extent{static_cast<std::uint32_t>(frame.width),
                            static_cast<std::uint32_t>(frame.height)};
    if (!targets || targets->extent().width != extent.width || targets->extent().height != extent.height) {
        lastFrame.reset();  // its picture goes
        targets.reset();
        targets = std::make_unique<FrameTargets>(device, extent);
    }
    if (!(frame.tolerancePx > 0.0 && frame.tolerancePx < 1e6))
        throw VulkanError({"A tolerance of " + std::to_string(frame.tolerancePx) + " pixels means nothing",
                           {},
                           "Choose one above 0, such as 0.5"});
}

void Renderer::Parts::uploadRecord(const gpu::FrameRecord& record)
{
    if (frameRecord_ && std::memcmp(&*frameRecord_, &record, sizeof(record)) == 0)
        return;
    frameRecord_ = record;
    uploader.write(frameBuffer_, 0, std::span(&record, 1));
}

void Renderer::Parts::updateFrameRecord(const Frame& frame, const SurfacePath& path, SamplingRule sampling,
                                        bool capture)
{
    gpu::FrameRecord record{};
    record.projection =
        gpu::mat4(frame.camera.projection(static_cast<double>(frame.width) / frame.height, scene.bounds()));
    record.pixelsPerUnit = static_cast<float>(pixelsPerUnit(frame.camera, frame.height));
    record.diePx = static_cast<float>(kDiePxPerTolerance * frame.tolerancePx);
    record.fixedDice =
        sampling.kind == SamplingRule::Kind::fixed ? static_cast<std::uint32_t>(sampling.count) : 0;
    record.maxDice = device.abilities().maxTessellationLevel;
    record.cullBits = frame.culling.bits;
    record.ksquadCount = scene.ksquadCount();
    record.shading = static_cast<std::uint32_t>(frame.shading);
    record.flags = (frame.overlays.knotLines ? FRAME_KNOT_LINES : 0U) | (capture ? FRAME_CAPTURE : 0U) |
                   (frame.camera.orthographic ? FRAME_ORTHOGRAPHIC : 0U);
    record.patchesPerDraw = std::min(path.ksquadsPerDraw(sampling), std::max(record.ksquadCount, 1U));
    record.captureCapacity = counters.captureCapacity();
    uploadRecord(record);
}

FrameStats Renderer::Parts::draw(const Frame& frame, bool capture)
{
    const auto started = std::chrono::steady_clock::now();
    checkFrame(frame);
    wish_ = frame.evaluator;
    const Evaluator evaluator = chosenEvaluator(wish_, largestDegree_, Precision::float32);
    SurfacePath& path = pathFor(frame.path, evaluator);
    const SamplingRule sampling =
        frame.sampling.kind == SamplingRule::Kind::pathDefault ? path.defaultSampling() : frame.sampling;
    if (!path.supports(sampling))
        throw VulkanError(
            {"The path " + pathInfo(frame.path).name + " cannot sample by the rule " + name(sampling),
             {},
             "Leave the rule out, or use " + name(path.defaultSampling())});
    VkDeviceSize uploaded = 0;
    double cpuMs = 0;
    try {
        if (!sceneIsHeld_)
            sync(Scene(wanted_));
        scene.useEvaluator(evaluator);
        fitTargets(frame);
        scene.updateViews(frame.camera, frame.overlays.highlighted);
        updateFrameRecord(frame, path, sampling, capture);
        if (path.takesVisibleList())
            culling.prepare(scene.ksquadCount(), frameRecord_->patchesPerDraw, evaluator);
        device.execute([&](VkCommandBuffer commands) {
            uploaded = uploader.record(commands);
            record(commands, frame, path);
            cpuMs = millisecondsSince(started);
        });
        uploader.sent();
    } catch (...) {
        // Nobody knows what arrived: the next frame sends everything again.
        uploader.forgetAll();
        scene.forget();
        sceneIsHeld_ = false;
        frameRecord_.reset();
        lastFrame.reset();
        throw;
    }
    lastFrame = frame;
    lastObjects.clear();
    for (const Resident& resident : scene.residents())
        lastObjects.push_back(resident.id);
    FrameStats stats = statsOf(frame, sampling, uploaded);
    stats.cpuMs = {cpuMs, cpuMs, cpuMs};
    return stats;
}

void Renderer::Parts::record(VkCommandBuffer commands, const Frame& frame, const SurfacePath& path)
{
    const bool anything = scene.ksquadCount() > 0;
    counters.clear(commands);
    clock.start(commands);
    if (anything && path.takesVisibleList())
        culling.record(commands);
    targets->begin(commands);
    bindings.bind(commands, VK_PIPELINE_BIND_POINT_GRAPHICS);
    if (anything)
        path.draw(commands, scene.ksquadCount(), {culling.draws(), culling.drawCount()});
    drawOverlays(commands, frame.overlays);
    targets->end(commands);
    clock.stop(commands);
    counters.fetch(commands);
}

FrameStats Renderer::Parts::statsOf(const Frame& frame, SamplingRule sampling, VkDeviceSize uploaded)
{
    FrameStats stats;
    stats.device = device.name();
    stats.path = pathInfo(frame.path).name;
    stats.culling = names(frame.culling);
    stats.sampling = name(sampling);
    stats.evaluator = evaluatorInfo(scene.evaluator()).name;
    stats.tolerancePx = frame.tolerancePx;
    stats.width = frame.width;
    stats.height = frame.height;
    stats.surfaces = scene.residents().size();
    stats.ksquads = scene.ksquadCount();
    const gpu::Counters counted = counters.read();
    stats.ksquadsDrawn = counted.drawn;
    std::copy(std::begin(counted.culled), std::end(counted.culled), stats.ksquadsCulled.begin());
    stats.ksdice = wide(counted.ksdice);
    stats.triangles = wide(counted.triangles);
    stats.evaluations = wide(counted.evaluations);
    const double gpuMs = clock.milliseconds();
    stats.gpuMs = {gpuMs, gpuMs, gpuMs};
    if (scene.takeRebuilt())
        firstUpload_ = uploaded;
    else
        stats.uploadBytesPerFrame = uploaded;
    stats.uploadBytesFirst = firstUpload_;
    stats.deviceBytes = device.allocatedBytes;
    return stats;
}

void Renderer::Parts::drawOverlays(VkCommandBuffer commands, const Overlays& overlays) const
{
    if (overlays.controlNets) {
        for (const Resident& resident : scene.residents())
            controlNet.drawNet(commands, scene.indexOf(resident), resident.object->surface);
    } else {
        for (const ObjectId id : overlays.netsOf)
            if (const auto* resident = scene.find(id))
                controlNet.drawNet(commands, scene.indexOf(*resident), resident->object->surface);
    }
    for (const ControlPointMark& mark : overlays.marks)
        if (const auto* resident = scene.find(mark.object)) {
            const NurbsSurface& net = resident->object->surface;
            const auto [i, j] = mark.index;
            if (i >= 0 && i < net.countU() && j >= 0 && j < net.countV())
                controlNet.drawMark(commands, scene.indexOf(*resident),
                                    static_cast<std::uint32_t>(i * net.countV() + j), mark.selected);
        }
}

}  // namespace knotspan
