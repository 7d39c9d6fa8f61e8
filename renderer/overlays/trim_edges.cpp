#include "renderer/overlays/trim_edges.h"

#include "shaders/shared/trim_tiles.h"

namespace knotspan {

namespace {

constexpr VkDeviceSize kWord = sizeof(std::uint32_t);
constexpr VkDeviceSize kWordsOfAPixel = 4;  // colour, depth, and two of what it shows

}  // namespace

TrimEdges::TrimEdges(const Device& device, Bindings& bindings)
    : device_(device),
      bindings_(bindings),
      find_(makeComputePipeline(device, bindings, "trim_edge_find.comp")),
      blend_(makeComputePipeline(device, bindings, "trim_edge_blend.comp")),
      put_(makeComputePipeline(device, bindings, "trim_edge_put.comp"))
{
}

void TrimEdges::prepare(VkExtent2D extent, Specialization specialization)
{
    const auto tiles = [](std::uint32_t pixels, std::uint32_t side) { return (pixels + side - 1) / side; };
    pixelCount_ = VkDeviceSize{extent.width} * extent.height;
    tileCount_ = tiles(extent.width, TRIM_TILE_WIDTH) * tiles(extent.height, TRIM_TILE_HEIGHT);
    bindings_.provide(BINDING_DRAWN, pixels_, kWord * ((kWordsOfAPixel + 1) * pixelCount_ + TRIM_LIST_HEAD));
    specialization.captures = false;
    specialization_ = specialization;
    if (codes_.count(specialization) == 0)
        codes_[specialization] =
            makeComputePipeline(device_, bindings_, "trim_edge_codes.comp", specialization);
}

void TrimEdges::record(VkCommandBuffer commands) const
{
    const GroupsOnDevice listed{pixels_.get(), kWord * kWordsOfAPixel * pixelCount_};
    const std::uint32_t head[TRIM_LIST_HEAD] = {0, 1, 1, 0};  // groups along x, y and z; how many are listed
    vkCmdUpdateBuffer(commands, listed.buffer, listed.offset, sizeof head, head);
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                  VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
    bindings_.bind(commands, VK_PIPELINE_BIND_POINT_COMPUTE);
    computeStep(commands, find_, groupsFor(tileCount_, 1));
    for (const Pipeline* step : {&codes_.at(specialization_), &blend_, &put_}) {
        memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                      VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT);
        computeStep(commands, *step, listed);
    }
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT);
}

void TrimEdges::listMemory(std::vector<HeldMemory>& to) const
{
    to.push_back({"picture for trim edges", pixels_.bytes()});
}

}  // namespace knotspan
