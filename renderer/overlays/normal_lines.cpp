#include "renderer/overlays/normal_lines.h"

namespace knotspan {

void NormalLines::prepare(const Specialization& specialization, bool trimmed)
{
    shown_ = {specialization, trimmed};
    if (pipelines_.count(shown_) == 0)
        pipelines_[shown_] = makeGraphicsPipeline(
            device_, bindings_,
            {.stages = {trimmed ? "normal_trimmed.vert" : "normal.vert", "edge_line.frag"},
             .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP,
             .overlay = true,
             .lines = true,
             .specialization = specialization});
}

void NormalLines::draw(VkCommandBuffer commands, std::uint32_t ksquads) const
{
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.at(shown_).get());
    vkCmdSetDepthCompareOp(commands, VK_COMPARE_OP_GREATER_OR_EQUAL);
    vkCmdDraw(commands, 4, ksquads, 0, 0);
}

}  // namespace knotspan
