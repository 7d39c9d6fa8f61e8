#include "renderer/sampling/sampling_pass.h"

#include <algorithm>

#include "shaders/shared/layouts.h"

namespace knotspan {

namespace {

constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkAccessFlags2 kReadWrite =
    VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;

}  // namespace

SamplingPass::SamplingPass(const Device& device, Bindings& bindings)
    : device_(device),
      bindings_(bindings),
      count_(makeComputePipeline(device, bindings, "tile_count.comp")),
      scan_(makeComputePipeline(device, bindings, "tile_scan.comp")),
      write_(makeComputePipeline(device, bindings, "tile_write.comp"))
{
}

void SamplingPass::prepare(std::uint32_t ksquads, std::uint32_t tilesPerDraw,
                           const Specialization& specialization)
{
    specialization_ = specialization;
    if (sampling_.count(specialization) == 0)
        sampling_[specialization] = makeComputePipeline(device_, bindings_, "sampling.comp", specialization);
    if (ksquads != ksquads_)
        tileCapacity_ = std::max(ksquads, 1U);
    ksquads_ = ksquads;
    const VkDeviceSize count = ksquads;
    const VkDeviceSize groups = (ksquads + LIST_KSQUADS - 1) / LIST_KSQUADS;
    bindings_.provide(BINDING_GRIDS, grids_, count * sizeof(gpu::GridRecord));
    bindings_.provide(BINDING_TILE_COUNTS, tileCounts_, count * sizeof(std::uint32_t));
    bindings_.provide(BINDING_TILE_GROUPS, groups_, groups * 2 * sizeof(std::uint32_t));
    bindings_.provide(BINDING_TILES, tiles_, VkDeviceSize{tileCapacity_} * sizeof(gpu::TileRecord));
    const std::uint32_t perDraw = std::min(tilesPerDraw, tileCapacity_);
    drawCount_ = perDraw == 0 ? 1 : (tileCapacity_ + perDraw - 1) / perDraw;
    bindings_.provide(BINDING_DRAWS, draws_, VkDeviceSize{drawCount_} * sizeof(gpu::DrawRecord));
}

void SamplingPass::makeRoomFor(std::uint32_t tiles)
{
    tileCapacity_ = tiles + tiles / 4;
}

void SamplingPass::record(VkCommandBuffer commands, const GroupsOnDevice& asking,
                          const GroupsOnDevice& visible, bool keepsGrids) const
{
    // Waits for the frame before, whose stages read both.
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
    if (!keepsGrids)
        vkCmdFillBuffer(commands, grids_.get(), 0, VK_WHOLE_SIZE, 0);
    vkCmdFillBuffer(commands, groups_.get(), 0, VK_WHOLE_SIZE, 0);
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT | kCompute,
                  VK_ACCESS_2_TRANSFER_WRITE_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                  kCompute | VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT,
                  kReadWrite | VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT);
    bindings_.bind(commands, VK_PIPELINE_BIND_POINT_COMPUTE);
    computeStep(commands, sampling_.at(specialization_), asking);
    computeStep(commands, count_, visible);
    computeStep(commands, scan_, {1, 1});
    computeStep(commands, write_, visible);
    memoryBarrier(commands, kCompute, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_2_ALL_GRAPHICS_BIT,
                  VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT | kReadWrite);
}

void SamplingPass::listMemory(std::vector<HeldMemory>& to) const
{
    to.push_back({"grids", grids_.bytes()});
    to.push_back({"tile counts", tileCounts_.bytes() + groups_.bytes()});
    to.push_back({"tiles", tiles_.bytes()});
    to.push_back({"draws", draws_.bytes()});
}

}  // namespace knotspan
