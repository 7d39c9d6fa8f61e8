#include "renderer/overlays/trim_edges.h"

#include "shaders/shared/trim_tiles.h"

namespace knotspan {

TrimEdges::TrimEdges(const Device& device, Bindings& bindings)
    : bindings_(bindings),
      tiles_(makeComputePipeline(device, bindings, "trim_edge_tiles.comp")),
      picture_(makeGraphicsPipeline(device, bindings,
                                    {.stages = {"trim_edges.vert", "trim_edges.frag"},
                                     .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP,
                                     .overlay = true,
                                     .opaque = true,
                                     .specialization = {}}))
{
}

void TrimEdges::prepare(VkExtent2D extent)
{
    const auto tiles = [](std::uint32_t pixels) { return (pixels + TRIM_TILE - 1) / TRIM_TILE; };
    depthsFrom_ = VkDeviceSize{4} * extent.width * extent.height;
    tileCount_ = tiles(extent.width) * tiles(extent.height);
    bindings_.provide(BINDING_DRAWN, pixels_, 2 * depthsFrom_ + sizeof(std::uint32_t) * tileCount_);
}

void TrimEdges::find(VkCommandBuffer commands) const
{
    vkCmdFillBuffer(commands, pixels_.get(), 2 * depthsFrom_, sizeof(std::uint32_t) * tileCount_, 0);
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                  VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
    bindings_.bind(commands, VK_PIPELINE_BIND_POINT_COMPUTE);
    computeStep(commands, tiles_, groupsFor(tileCount_, 1));
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_ALL_GRAPHICS_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT);
}

void TrimEdges::draw(VkCommandBuffer commands) const
{
    bindings_.bind(commands, VK_PIPELINE_BIND_POINT_GRAPHICS);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, picture_.get());
    vkCmdSetDepthCompareOp(commands, VK_COMPARE_OP_ALWAYS);
    vkCmdDraw(commands, 4, tileCount_, 0, 0);
}

void TrimEdges::listMemory(std::vector<HeldMemory>& to) const
{
    to.push_back({"picture for trim edges", pixels_.bytes()});
}

}  // namespace knotspan
