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
      scene(device, bindings, uploader),
      culling(device, bindings),
      controlNet(device, bindings),
      frameBuffer_(device, sizeof(gpu::FrameRecord), Buffer::Place::device)
{
    bindings.set(BINDING_FRAME, frameBuffer_);
}

SurfacePath& Renderer::Parts::pathFor(PathId id)
{
    const PathFactory& factory = pathFactory(id);
    if (const std::string reason = factory.whyUnavailable(device); !reason.empty())
        throw VulkanError(
            {"The path " + factory.info.name + " cannot run here. " + reason, {}, "Choose another path"});
    auto& path = paths[id];
    if (!path)
        path = factory.create(device, bindings);
    return *path;
}

void Renderer::Parts::checkSize(const Frame& frame) const
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
        targets.reset();
        targets = std::make_unique<FrameTargets>(device, extent);
    }
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
    record.viewport = {frame.width, frame.height};
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
    checkSize(frame);
    SurfacePath& path = pathFor(frame.path);
    const SamplingRule sampling =
        frame.sampling.kind == SamplingRule::Kind::pathDefault ? path.defaultSampling() : frame.sampling;
    if (!path.supports(sampling))
        throw VulkanError(
            {"The path " + pathInfo(frame.path).name + " cannot sample by the rule " + name(sampling),
             {},
             "Leave the rule out, or use " + name(path.defaultSampling())});
    fitTargets(frame);
    scene.updateViews(frame.camera, frame.overlays.highlighted);
    updateFrameRecord(frame, path, sampling, capture);
    const bool anything = scene.ksquadCount() > 0;
    const bool cullFirst = anything && path.takesVisibleList();
    if (cullFirst)
        culling.prepare(scene.ksquadCount(), frameRecord_->patchesPerDraw);

    VkDeviceSize uploaded = 0;
    double cpuMs = 0;
    device.execute([&](VkCommandBuffer commands) {
        uploaded = uploader.flush(commands);
        counters.clear(commands);
        clock.start(commands);
        if (cullFirst)
            culling.record(commands);
        targets->begin(commands);
        bindings.bind(commands, VK_PIPELINE_BIND_POINT_GRAPHICS);
        if (anything)
            path.draw(commands, scene.ksquadCount(), {culling.draws(), culling.drawCount()});
        drawOverlays(commands, frame.overlays);
        targets->end(commands);
        clock.stop(commands);
        counters.fetch(commands);
        cpuMs = millisecondsSince(started);
    });
    lastFrame = frame;

    FrameStats stats = statsOf(frame, sampling, uploaded);
    stats.cpuMs = {cpuMs, cpuMs, cpuMs};
    return stats;
}

FrameStats Renderer::Parts::statsOf(const Frame& frame, SamplingRule sampling, VkDeviceSize uploaded)
{
    FrameStats stats;
    stats.device = device.name();
    stats.path = pathInfo(frame.path).name;
    stats.culling = names(frame.culling);
    stats.sampling = name(sampling);
    stats.tolerancePx = frame.tolerancePx;
    stats.width = frame.width;
    stats.height = frame.height;
    stats.surfaces = scene.residents().size();
    stats.ksquads = scene.ksquadCount();
    const gpu::Counters counted = counters.read();
    stats.ksquadsDrawn = counted.drawn;
    std::copy(std::begin(counted.culled), std::end(counted.culled), stats.ksquadsCulled.begin());
    stats.ksdice = counted.ksdice;
    stats.triangles = counted.triangles;
    stats.evaluations = counted.evaluations;
    const double gpuMs = clock.milliseconds();
    stats.gpuMs = {gpuMs, gpuMs, gpuMs};
    if (firstUpload_ == 0)
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
        for (const GpuScene::Resident& resident : scene.residents())
            controlNet.drawNet(commands, scene.indexOf(resident), resident.object->surface);
    } else {
        for (const ObjectId id : overlays.netsOf)
            if (const auto* resident = scene.find(id))
                controlNet.drawNet(commands, scene.indexOf(*resident), resident->object->surface);
    }
    for (const ControlPointMark& mark : overlays.marks)
        if (const auto* resident = scene.find(mark.object)) {
            const int point = mark.index.i * resident->object->surface.countV() + mark.index.j;
            controlNet.drawMark(commands, scene.indexOf(*resident), static_cast<std::uint32_t>(point),
                                mark.selected);
        }
}

}  // namespace knotspan
