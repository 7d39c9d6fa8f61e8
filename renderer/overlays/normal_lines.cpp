#include "renderer/overlays/normal_lines.h"

namespace knotspan {

void NormalLines::prepare(const Specialization& specialization)
{
    specialization_ = specialization;
    if (pipelines_.count(specialization) == 0)
        pipelines_[specialization] = makeGraphicsPipeline(device_, bindings_,
                                                          {.stages = {"normal.vert", "edge_line.frag"},
                                                           .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP,
                                                           .overlay = true,
                                                           .lines = true,
                                                           .specialization = specialization});
}

void NormalLines::draw(VkCommandBuffer commands, std::uint32_t ksquads) const
{
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.at(specialization_).get());
    vkCmdSetDepthCompareOp(commands, VK_COMPARE_OP_GREATER_OR_EQUAL);
    vkCmdDraw(commands, 4, ksquads, 0, 0);
}

}  // namespace knotspan
