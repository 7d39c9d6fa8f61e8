// The commands of one frame.
#include "renderer/renderer_parts.h"

namespace knotspan {

void Renderer::Parts::record(VkCommandBuffer commands, const Frame& frame, const SurfacePath& path)
{
    const bool anything = scene.ksquadCount() > 0;
    counters.clear(commands);
    if (frame.cullingCamera)
        waitForVerdicts(commands);
    clock.start(commands);
    const auto make = [&](bool rest) {
        if (path.tiles()) {
            sampling.record(commands, culling.askingGroups(), culling.visibleGroups(), rest);
            clock.lap(commands, GpuStage::sampling);
        }
        path.compute(commands);
    };
    const auto drawMade = [&] {
        bindings.bind(commands, VK_PIPELINE_BIND_POINT_GRAPHICS);
        path.draw(commands, scene.ksquadCount(), {sampling.draws(), sampling.drawCount()});
    };
    if (anything && usesCullPass(frame, path))
        culling.record(commands);
    if (!path.tiles() && usesCullPass(frame, path))
        waitForVerdicts(commands);
    clock.lap(commands, GpuStage::culling);
    if (anything)
        make(false);
    targets->begin(commands);
    if (anything)
        drawMade();
    if (anything && path.tiles() && isByOcclusion(frame)) {
        targets->pause(commands, pyramid.pixels());
        clock.lap(commands, GpuStage::drawing);
        bindings.bind(commands, VK_PIPELINE_BIND_POINT_COMPUTE);
        pyramid.record(commands, counters.buffer(), offsetof(gpu::Counters, pyramidLevel));
        culling.recordRest(commands);
        clock.lap(commands, GpuStage::culling);
        make(true);
        targets->resume(commands);
        drawMade();
    }
    bindings.bind(commands, VK_PIPELINE_BIND_POINT_GRAPHICS);
    if (anything && frame.cullingCamera)
        rejectedOutlines.draw(commands, scene.ksquadCount());
    drawOverlays(commands, frame.overlays);
    targets->end(commands);
    clock.stop(commands);
    if (anything && frameRecord_->judgedBits != 0)
        wrongCulls.record(commands, scene.ksquadCount(), specializationFor(scene.evaluator()));
    counters.fetch(commands);
}

void Renderer::Parts::drawOverlays(VkCommandBuffer commands, const Overlays& overlays) const
{
    if (!overlays.edgeLines.empty())
        edgeLines.draw(commands);
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
