// Culling by a camera that stands still (Frame::cullingCamera). Frames drawn from there note what they drop,
// whatever the path; those that the eye sees then read it, until the model or anything but the eye changes.
#include "renderer/renderer_parts.h"

namespace knotspan {

VkDeviceSize Renderer::Parts::noteVerdicts(const Frame& frame, const PathVariant& variant, SurfacePath& path,
                                           SamplingRule rule, std::chrono::steady_clock::time_point started)
{
    verdictFlag_ = 0;
    if (!frame.cullingCamera) {
        noted_.reset();
        provideVerdicts(0);
        return 0;
    }
    rejectedOutlines.prepare(specializationFor(scene.evaluator()));
    NotedVerdicts wanted{frame, variant, {}, {}};
    wanted.asked.camera = *frame.cullingCamera;
    wanted.asked.cullingCamera.reset();
    wanted.asked.overlays = {};
    VkDeviceSize uploaded = 0;
    if (!noted_ || noted_->asked != wanted.asked || noted_->variant != variant) {
        noted_.reset();
        provideVerdicts(scene.ksquadCount());
        verdictFlag_ = FRAME_NOTE_VERDICTS;
        Frame from = wanted.asked;
        prepareCulling(from, path);
        wanted.culling = from.culling;
        from.culling.bits = path.followed(from.culling.bits, rule);
        // By occlusion the first one makes the picture that the second decides by.
        for (int k = 0; k < (isByOcclusion(from) ? 2 : 1); ++k) {
            uploaded += drawWhole(from, path, rule, variant.specialization.captures, started);
            rebuiltForVerdicts_ = scene.takeRebuilt() || rebuiltForVerdicts_;
        }
        wanted.wronglyCulled = wronglyCulled(from, path, rule);
        noted_ = wanted;
    }
    verdictFlag_ = FRAME_KEEP_VERDICTS;
    return uploaded;
}

void Renderer::Parts::provideVerdicts(std::uint32_t ksquads)
{
    uploader.forget(verdicts_);
    bindings.provide(BINDING_VERDICTS, verdicts_, VkDeviceSize{ksquads} * sizeof(std::uint32_t));
}

void Renderer::Parts::waitForVerdicts(VkCommandBuffer commands)
{
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                  VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT);
}

bool Renderer::Parts::usesCullPass(const Frame& frame, const SurfacePath& path) const
{
    const bool notes = verdictFlag_ == FRAME_NOTE_VERDICTS;
    return path.tiles() || (notes && pathInfo(frame.path).drawsFromDevice);
}

}  // namespace knotspan
