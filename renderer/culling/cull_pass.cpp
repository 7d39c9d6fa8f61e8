#include "renderer/culling/cull_pass.h"

#include "shaders/shared/layouts.h"

namespace knotspan {

namespace {

void computeBarrier(VkCommandBuffer commands)
{
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                  VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
}

}  // namespace

CullPass::CullPass(const Device& device, Bindings& bindings)
    : device_(device),
      bindings_(bindings),
      scan_(makeComputePipeline(device, bindings, "cull_scan.comp")),
      compact_(makeComputePipeline(device, bindings, "cull_compact.comp"))
{
}

void CullPass::prepare(std::uint32_t ksquads, const Specialization& specialization)
{
    specialization_ = specialization;
    if (cull_.count(specialization) == 0)
        cull_[specialization] = makeComputePipeline(device_, bindings_, "cull.comp", specialization);
    ksquads_ = ksquads;
    const VkDeviceSize groups = (ksquads + CULL_KSQUADS - 1) / CULL_KSQUADS;
    bindings_.provide(BINDING_VISIBLE, visible_, VkDeviceSize{ksquads} * sizeof(std::uint32_t));
    bindings_.provide(BINDING_CULL_GROUPS, groups_, groups * 3 * sizeof(std::uint32_t));
}

void CullPass::record(VkCommandBuffer commands) const
{
    // Waits for the frame before, whose compaction read the groups.
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
    vkCmdFillBuffer(commands, groups_.get(), 0, VK_WHOLE_SIZE, 0);
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                  VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
    bindings_.bind(commands, VK_PIPELINE_BIND_POINT_COMPUTE);
    const GroupCount groups = groupsFor(ksquads_, CULL_KSQUADS);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, cull_.at(specialization_).get());
    vkCmdDispatch(commands, groups.x, groups.y, 1);
    computeBarrier(commands);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, scan_.get());
    vkCmdDispatch(commands, 1, 1, 1);
    computeBarrier(commands);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, compact_.get());
    vkCmdDispatch(commands, groups.x, groups.y, 1);
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                  VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
}

void CullPass::listMemory(std::vector<HeldMemory>& to) const
{
    to.push_back({"visible list", visible_.bytes()});
    to.push_back({"culling groups", groups_.bytes()});
}

}  // namespace knotspan
