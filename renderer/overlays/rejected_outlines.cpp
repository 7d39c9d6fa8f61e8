#include "renderer/overlays/rejected_outlines.h"

#include "shaders/shared/layouts.h"

namespace knotspan {

namespace {

constexpr float kHiddenOpacity = 0.15F;  // there are many, and the model is to be seen behind them

}  // namespace

void RejectedOutlines::prepare(const Specialization& specialization)
{
    specialization_ = specialization;
    if (pipelines_.count(specialization) == 0)
        pipelines_[specialization] = makeGraphicsPipeline(device_, bindings_,
                                                          {.stages = {"rejected.vert", "rejected.frag"},
                                                           .topology = VK_PRIMITIVE_TOPOLOGY_LINE_STRIP,
                                                           .overlay = true,
                                                           .lines = true,
                                                           .specialization = specialization});
}

void RejectedOutlines::draw(VkCommandBuffer commands, std::uint32_t ksquads) const
{
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.at(specialization_).get());
    for (const bool hidden : {true, false}) {
        gpu::OverlayConstants constants{};
        constants.colour.w = hidden ? kHiddenOpacity : 1.0F;
        bindings_.push(commands, &constants, sizeof(constants));
        vkCmdSetDepthCompareOp(commands, hidden ? VK_COMPARE_OP_LESS : VK_COMPARE_OP_GREATER_OR_EQUAL);
        vkCmdDraw(commands, 4 * OUTLINE_SEGMENTS + 1, ksquads, 0, 0);
    }
}

}  // namespace knotspan
