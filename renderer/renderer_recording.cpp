// The commands of one frame.
#include <algorithm>

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
        targets->pause(commands, FrameTargets::Copied::depths);
        targets->copy(commands, {0, targets->extent().height, pyramid.pixels(), 0, 0, 0});
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
    meshes.draw(commands, frame.camera, frame.overlays.highlighted);
    if (hasTrimEdges(frame)) {
        targets->pause(commands, FrameTargets::Copied::all);
        const TrimEdges::Colours smooth = trimEdges.record(commands, [&](const TrimEdges::Rows& rows) {
            targets->copy(commands, {rows.first, rows.count, rows.to, rows.depths, rows.colours, rows.shown});
        });
        targets->put(commands, smooth.buffer, smooth.offset);
        targets->resume(commands);
    }
    if (anything && frame.cullingCamera)
        rejectedOutlines.draw(commands, scene.ksquadCount());
    drawOverlays(commands, frame);
    targets->end(commands);
    if (frame.pane)
        sheet->put(commands, targets->colour(), *frame.pane);
    clock.stop(commands);
    if (anything && frameRecord_->judgedBits != 0)
        wrongCulls.record(commands, scene.ksquadCount(), specializationFor(scene.evaluator()));
    counters.fetch(commands);
}

// Error shading has figures for colours.
bool Renderer::Parts::hasTrimEdges(const Frame& frame) const
{
    return scene.isTrimmed() && frame.smoothEdges && frame.shading != Shading::error;
}

void Renderer::Parts::prepareOverlays(const Overlays& overlays)
{
    const Specialization specialization = specializationFor(scene.evaluator());
    edgeLines.prepare(overlays, scene.residents(), specialization);
    marks.prepare(overlays.marks, scene.residents());
    spaceLines.prepare(overlays.spaceLines);
    strokes.prepare(overlays.patches, overlays.strokes);
    if (overlays.normals)
        normalLines.prepare(specialization, scene.isTrimmed());
}

// What was prepared may be of another frame than one that shows none of it.
void Renderer::Parts::drawOverlays(VkCommandBuffer commands, const Frame& frame) const
{
    const Overlays& overlays = frame.overlays;
    if (overlays.normals && scene.ksquadCount() > 0)
        normalLines.draw(commands, scene.ksquadCount());
    if (overlays.outlines || !overlays.edgeLines.empty() || !overlays.isoLines.empty())
        edgeLines.draw(commands);
    if (!overlays.spaceLines.empty())
        spaceLines.draw(commands, frame.camera);
    for (const Resident* resident : shownNets(overlays))
        controlNet.draw(commands, scene.indexOf(*resident), resident->object->surface,
                        {overlays.points, overlays.hulls});
    if (!overlays.marks.empty())
        marks.draw(commands);
    if (!overlays.patches.empty() || !overlays.strokes.empty())
        strokes.draw(commands);
}

std::vector<const Resident*> Renderer::Parts::shownNets(const Overlays& overlays) const
{
    std::vector<const Resident*> shown;
    const auto add = [&](const Resident& resident) {
        if (!resident.object->locked)
            shown.push_back(&resident);
    };
    if (overlays.controlNets) {
        std::for_each(scene.residents().begin(), scene.residents().end(), add);
    } else {
        for (const ObjectId id : overlays.netsOf)
            if (const auto* resident = scene.find(id))
                add(*resident);
    }
    return shown;
}

}  // namespace knotspan
