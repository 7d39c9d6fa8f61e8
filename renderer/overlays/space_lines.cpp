#include "renderer/overlays/space_lines.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace knotspan {

void SpaceLinesOverlay::prepare(const std::vector<SharedSpaceLines>& lines)
{
    if (lines == held_)
        return;
    Box box;
    for (const SharedSpaceLines& some : lines)
        for (const SpaceLine& line : some->lines)
            if (std::isfinite(glm::dot(line.from, line.from)))
                box.add(line.from);
    origin_ = box.isEmpty() ? Vec3(0) : box.centre();
    std::vector<gpu::SpaceLineRecord> records;
    for (const SharedSpaceLines& some : lines)
        for (const SpaceLine& line : some->lines) {
            const gpu::vec3 from(line.from - origin_);
            const gpu::vec3 to(line.to - origin_);
            const float length = glm::length(to - from);
            if (length > 0 && std::isfinite(length))
                records.push_back({from, to, some->colour, 0.5F * some->widthPx});
        }
    if (!records.empty() && pipeline_.get() == VK_NULL_HANDLE)
        pipeline_ = makeGraphicsPipeline(device_, bindings_,
                                         {.stages = {"space_line.vert", "edge_line.frag"},
                                          .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP,
                                          .overlay = true,
                                          .lines = true,
                                          .specialization = {}});
    records_.send(std::move(records));
    held_ = lines;
}

void SpaceLinesOverlay::draw(VkCommandBuffer commands, const Camera& camera) const
{
    if (records_.isEmpty())
        return;
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
    vkCmdSetDepthCompareOp(commands, VK_COMPARE_OP_GREATER_OR_EQUAL);
    const gpu::SpaceLineConstants constants{gpu::mat4x3(glm::dmat4x3(camera.viewFrom(Mat4(1), origin_)))};
    bindings_.push(commands, &constants, sizeof(constants));
    vkCmdDraw(commands, 4, records_.count(), 0, 0);
}

}  // namespace knotspan
