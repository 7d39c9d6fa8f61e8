#include "renderer/culling/depth_pyramid.h"

namespace knotspan {

namespace {

constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags2 kTransfer = VK_PIPELINE_STAGE_2_TRANSFER_BIT;
constexpr VkAccessFlags2 kReadWrite =
    VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;

}  // namespace

DepthPyramid::DepthPyramid(const Device& device, Bindings& bindings)
    : bindings_(bindings),
      reduce_(makeComputePipeline(device, bindings, "depth_pyramid.comp"))
{
}

void DepthPyramid::prepare(VkExtent2D extent)
{
    levels_ = {extent};
    VkDeviceSize texels = VkDeviceSize{extent.width} * extent.height;
    while (levels_.back().width > 1 || levels_.back().height > 1) {
        const VkExtent2D below = levels_.back();
        levels_.push_back({(below.width + 1) / 2, (below.height + 1) / 2});
        texels += VkDeviceSize{levels_.back().width} * levels_.back().height;
    }
    bindings_.provide(BINDING_DEPTHS, depths_, texels * sizeof(float));
}

void DepthPyramid::record(VkCommandBuffer commands, VkBuffer counters, VkDeviceSize level) const
{
    for (std::uint32_t k = 1; k < levels_.size(); ++k) {
        memoryBarrier(commands, kCompute | kTransfer, kReadWrite | VK_ACCESS_2_TRANSFER_WRITE_BIT, kTransfer,
                      VK_ACCESS_2_TRANSFER_WRITE_BIT);
        vkCmdFillBuffer(commands, counters, level, sizeof(std::uint32_t), k);
        memoryBarrier(commands, kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT, kCompute, kReadWrite);
        computeStep(commands, reduce_, groupsFor(levels_[k].width * levels_[k].height, PYRAMID_TEXELS));
    }
}

void DepthPyramid::listMemory(std::vector<HeldMemory>& to) const
{
    to.push_back({"depth pyramid", depths_.bytes()});
}

}  // namespace knotspan
