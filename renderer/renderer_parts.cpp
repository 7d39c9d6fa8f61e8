#include "renderer/renderer_parts.h"

#include <algorithm>

#include "model/core/check.h"

namespace knotspan {

namespace {

PathVariant::Fragments fragmentsFor(Shading shading)
{
    switch (shading) {
    case Shading::shaded:
    case Shading::ksquads:
        return PathVariant::Fragments::lit;
    case Shading::error:
        return PathVariant::Fragments::error;
    default:
        return PathVariant::Fragments::exact;
    }
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
      meshes(device, bindings, uploader),
      facing(bindings, uploader),
      culling(device, bindings),
      pyramid(device, bindings),
      wrongCulls(device, bindings),
      sampling(device, bindings),
      wave(device, bindings, uploader),
      controlNet(device, bindings),
      rejectedOutlines(device, bindings),
      edgeLines(device, bindings, uploader),
      normalLines(device, bindings),
      marks(device, bindings, uploader),
      spaceLines(device, bindings, uploader),
      strokes(device, bindings, uploader),
      trimEdges(device, bindings),
      spanPlaceRecords(bindings, uploader, BINDING_SPAN_PLACES),
      deviationRecords(bindings, uploader, BINDING_DEVIATIONS)
{
    bindings.provide(BINDING_FRAME, frameBuffer_, sizeof(gpu::FrameRecord));
}

void Renderer::Parts::sync(const Scene& wanted, Joins joins)
{
    const auto started = std::chrono::steady_clock::now();
    const double worked = processorMs();
    wanted_ = wanted;
    noted_.reset();
    if (!sceneIsHeld_)
        forgetScene();  // nobody knows how far the last one came
    if (scene.residents().empty() || !scene.isOfSameShape(wanted_))
        largestDegree_ = largestDegree(visibleObjects(wanted_));
    sceneIsHeld_ = false;
    scene.useEvaluator(chosenEvaluator(wish_, largestDegree_, Precision::float32));
    scene.sync(wanted_, joins);
    meshes.sync(wanted_);
    sceneIsHeld_ = true;
    syncMs_ += millisecondsSince(started);
    work_.sync += processorMs() - worked;
}

void Renderer::Parts::forgetScene()
{
    scene.forget();
    meshes.forget();
}

Specialization Renderer::Parts::specializationFor(Evaluator evaluator) const
{
    return {static_cast<std::uint32_t>(evaluator), false, shaderOrderFor(largestDegree_)};
}

SurfacePath& Renderer::Parts::pathFor(PathId id, const PathVariant& variant)
{
    const PathFactory& factory = pathFactory(id);
    if (const std::string reason = factory.whyUnavailable(device); !reason.empty())
        throw VulkanError(
            {"The path " + factory.info.name + " cannot run here. " + reason, {}, "Choose another path"});
    auto& path = paths[{id, variant}];
    if (!path)
        path = factory.create(device, bindings, variant);
    return *path;
}

PathVariant Renderer::Parts::variantOf(const Frame& frame, Evaluator evaluator) const
{
    const bool cullsDice = pathInfo(frame.path).cullsDice && (frame.culling.bits & CULL_DICE) != 0;
    return {specializationFor(evaluator), fragmentsFor(frame.shading), cullsDice, scene.isTrimmed()};
}

bool Renderer::Parts::isPrepared(const Frame& frame) const
{
    const Evaluator evaluator = chosenEvaluator(frame.evaluator, largestDegree_, Precision::float32);
    return paths.count({frame.path, variantOf(frame, evaluator)}) != 0;
}

void Renderer::Parts::checkFrame(const Frame& frame) const
{
    const auto most = static_cast<int>(std::min(device.limits().maxImageDimension2D, 16384U));
    const auto checkSize = [most](int width, int height) {
        if (width >= 1 && height >= 1 && width <= most && height <= most)
            return;
        throw VulkanError({"A picture of " + std::to_string(width) + " by " + std::to_string(height) +
                               " pixels cannot be drawn",
                           {},
                           "Choose sizes from 1 to " + std::to_string(most)});
    };
    checkSize(frame.width, frame.height);
    if (frame.pane)
        checkSize(frame.pane->sheetWidth, frame.pane->sheetHeight);
}

void Renderer::Parts::fitSheet(const Frame& frame)
{
    if (!frame.pane) {
        sheet.reset();
        return;
    }
    const VkExtent2D extent{static_cast<std::uint32_t>(frame.pane->sheetWidth),
                            static_cast<std::uint32_t>(frame.pane->sheetHeight)};
    if (!sheet || sheet->extent().width != extent.width || sheet->extent().height != extent.height) {
        lastFrame.reset();
        sheet.reset();
        sheet = std::make_unique<Sheet>(device, extent);
    }
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
    fitSheet(frame);
    if (!(frame.tolerancePx > 0.0 && frame.tolerancePx < 1e6))
        throw VulkanError({"A tolerance of " + std::to_string(frame.tolerancePx) + " pixels means nothing",
                           {},
                           "Choose one above 0, such as 0.5"});
}

FrameStats Renderer::Parts::draw(const Frame& wantedFrame, bool capture)
{
    checkFrame(wantedFrame);
    Frame frame = wantedFrame;
    if (!pathInfo(frame.path).drawsFromDevice)
        frame.wave.reset();
    wish_ = frame.evaluator;
    if (!sceneIsHeld_)
        sync(Scene(wanted_));
    const Evaluator evaluator = chosenEvaluator(wish_, largestDegree_, Precision::float32);
    if (!pathInfo(frame.path).cullsDice)
        frame.culling.bits &= ~CULL_DICE;
    PathVariant variant = variantOf(frame, evaluator);
    variant.specialization.captures = capture;
    SurfacePath& path = pathFor(frame.path, variant);
    const PathInfo& info = pathInfo(frame.path);
    const SamplingRule rule =
        frame.sampling.kind == SamplingRule::Kind::pathDefault ? info.rules.front() : frame.sampling;
    if (!info.follows(rule))
        throw VulkanError({"The path " + info.name + " cannot sample by the rule " + name(rule),
                           {},
                           "Leave the rule out, or use " + name(info.rules.front())});
    VkDeviceSize uploaded = 0;
    cpuMs_ = 0;
    const auto started = std::chrono::steady_clock::now();
    const double worked = processorMs();
    try {
        scene.useEvaluator(evaluator);
        scene.usePacking(path.packing(), frame.overlays.showNets());
        fitTargets(frame);
        if (path.asksForFriends(rule))
            scene.setFriends(friendSides.of(scene.residents(), &scene.changes()));
        uploaded = noteVerdicts(frame, variant, path, rule, started);
        prepareCulling(frame, path);
        if (frame.shading == Shading::checker)
            spanPlaceRecords.send(spanPlaces.of(scene.residents(), frame.look.checker, &scene.changes()));
        if (frame.shading == Shading::deviation &&
            deviations.follow(scene.residents(), frame.deviations, &scene.changes()))
            deviationRecords.send(deviations.words());
        prepareOverlays(frame.overlays);
        if (hasTrimEdges(frame))
            trimEdges.prepare(targets->extent(), variant.specialization);
        uploaded += drawWhole(frame, path, rule, capture, started);
    } catch (...) {
        // Nobody knows what arrived: the next frame sends everything again.
        uploader.forgetAll();
        path.forget();
        forgetScene();
        facing.forget();
        edgeLines.forget();
        marks.forget();
        spaceLines.forget();
        strokes.forget();
        spanPlaceRecords.forget();
        deviations.forget();
        deviationRecords.forget();
        sceneIsHeld_ = false;
        frameRecord_.reset();
        lastFrame.reset();
        noted_.reset();
        throw;
    }
    lastFrame = frame;
    const auto changed = scene.changes().since(std::exchange(lastResidentsAt_, scene.changes().now()));
    if (changed && lastResidents.size() == scene.residents().size())
        for (const std::uint32_t k : *changed)
            lastResidents[k] = scene.residents()[k];
    else
        lastResidents = scene.residents();
    FrameStats stats = statsOf(frame, path, rule, uploaded);
    stats.work = std::exchange(work_, {});
    stats.work.prepare = recordingFrom_ - worked;
    stats.work.finish = processorMs() - recordedAt_;
    return stats;
}

// What the culling modes read. A wave moves control points on the device, where nobody knows then which way
// they face nor what they enclose.
void Renderer::Parts::prepareCulling(Frame& frame, const SurfacePath& path)
{
    if (frame.cullingCamera) {
        // What that one saw of a body has holes from anywhere else, so that both sides show.
        frame.culling.bits &= CULL_DICE;
        sides_ = ShownSides::asTold(scene.residents());
        scene.updateViews(frame.camera, {frame.overlays.highlighted, frame.overlays.hovered}, sides_);
        return;
    }
    if (!path.tiles())
        frame.culling.bits &= ~CULL_BY_DEPTH;  // it draws all at once
    if (frame.wave)
        frame.culling.bits &= ~(CULL_BY_BOX | CULL_BY_RAYS);
    if (frame.wave) {
        sides_ = ShownSides::asTold(scene.residents());
    } else {
        const SideTables& sides =
            shownSides.of(scene.residents(), scene.edges(), frame.camera,
                          static_cast<double>(frame.width) / frame.height, scene.bounds(), &scene.changes());
        if (sides_.revision == 0 || sides_.revision != sides.revision)
            sides_ = sides;
    }
    FacingStrength strength = FacingStrength::none;
    if ((frame.culling.bits & CULL_BY_BOX) != 0)
        strength = FacingStrength::box;
    if ((frame.culling.bits & CULL_BY_RAYS) != 0)
        strength = FacingStrength::rays;
    if (sides_.anyShownAlone() && strength != FacingStrength::none)
        facing.update(scene.residents(),
                      scene.packing() == Packing::bezier ? FacingArrays::Origins::bezierNets
                                                         : FacingArrays::Origins::surfaceNets,
                      strength, scene.changes());
    scene.updateViews(frame.camera, {frame.overlays.highlighted, frame.overlays.hovered}, sides_);
}

VkDeviceSize Renderer::Parts::drawWhole(const Frame& frame, SurfacePath& path, SamplingRule rule,
                                        bool capture, std::chrono::steady_clock::time_point started)
{
    VkDeviceSize uploaded = 0;
    if (scene.isRebuilt())
        wave.forget();
    wave.prepare(scene, frame.wave);
    for (;;) {
        const Specialization specialization = specializationFor(scene.evaluator());
        if (usesCullPass(frame, path))
            culling.prepare(scene.ksquadCount(), specialization, isByOcclusion(frame), scene.isRebuilt());
        if (const auto limits = path.tiles()) {
            if (isByOcclusion(frame))
                pyramid.prepare(targets->extent());
            // It evaluates nothing.
            sampling.prepare(scene.ksquadCount(), limits->taskTiles != 0 ? 0 : limits->tilesPerDraw,
                             {.order = specialization.order});
        }
        updateFrameRecord(frame, path, rule, capture);
        if (frameRecord_->judgedBits != 0)
            wrongCulls.prepare(specializationFor(scene.evaluator()));
        device.execute([&](VkCommandBuffer commands) {
            recordingFrom_ = processorMs();
            wave.recordRest(commands);
            uploaded += uploader.record(commands);
            wave.recordWave(commands);
            record(commands, frame, path);
            cpuMs_ = millisecondsSince(started) + std::exchange(syncMs_, 0);
            recordedAt_ = processorMs();
            work_.record = recordedAt_ - recordingFrom_;
        });
        uploader.sent();
        counted_ = counters.read();
        path.count(counted_);
        bool room = path.hadRoom(counted_);
        if (path.tiles() && counted_.mostTiles > sampling.tileCapacity()) {
            sampling.makeRoomFor(counted_.mostTiles);
            room = false;
        }
        if (room)
            return uploaded;
    }
}

}  // namespace knotspan
