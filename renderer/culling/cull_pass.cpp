#include "renderer/culling/cull_pass.h"

#include "shaders/shared/layouts.h"

namespace knotspan {

namespace {

constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags2 kTransfer = VK_PIPELINE_STAGE_2_TRANSFER_BIT;

}  // namespace

CullPass::CullPass(const Device& device, Bindings& bindings)
    : device_(device),
      bindings_(bindings),
      rest_(makeComputePipeline(device, bindings, "cull_rest.comp")),
      asking_(makeComputePipeline(device, bindings, "cull_asking.comp")),
      scan_(makeComputePipeline(device, bindings, "cull_scan.comp")),
      compact_(makeComputePipeline(device, bindings, "cull_compact.comp"))
{
}

void CullPass::prepare(std::uint32_t ksquads, const Specialization& specialization, bool byOcclusion,
                       bool anew)
{
    specialization_ = specialization;
    if (cull_.count(specialization) == 0)
        cull_[specialization] = makeComputePipeline(device_, bindings_, "cull.comp", specialization);
    if (byOcclusion && occlusion_.count(specialization) == 0)
        occlusion_[specialization] =
            makeComputePipeline(device_, bindings_, "occlusion.comp", specialization);
    const VkDeviceSize groups = (ksquads + CULL_KSQUADS - 1) / CULL_KSQUADS;
    bindings_.provide(BINDING_VISIBLE, visible_, VkDeviceSize{ksquads} * sizeof(std::uint32_t));
    bindings_.provide(BINDING_ASKING, askingList_, VkDeviceSize{ksquads} * sizeof(std::uint32_t));
    bindings_.provide(BINDING_CULL_GROUPS, groups_, groups * sizeof(gpu::CullGroup));
    bindings_.provide(BINDING_LISTS, lists_, sizeof(gpu::ListGroups));
    const VkDeviceSize bits = byOcclusion ? groups * 2 * sizeof(std::uint32_t) : 0;
    bindings_.provide(BINDING_CANDIDATES, candidates_, bits);
    bindings_.provide(BINDING_SEEN, seen_, bits);
    bindings_.provide(BINDING_SEEN_NOW, seenNow_, bits);
    sawNothing_ = sawNothing_ || anew || !byOcclusion_ || ksquads != ksquads_;
    byOcclusion_ = byOcclusion;
    ksquads_ = ksquads;
}

void CullPass::record(VkCommandBuffer commands)
{
    if (byOcclusion_) {
        memoryBarrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                      VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT, kTransfer,
                      VK_ACCESS_2_TRANSFER_WRITE_BIT);
        vkCmdFillBuffer(commands, candidates_.get(), 0, VK_WHOLE_SIZE, 0);
        vkCmdFillBuffer(commands, seenNow_.get(), 0, VK_WHOLE_SIZE, 0);
        if (sawNothing_)
            vkCmdFillBuffer(commands, seen_.get(), 0, VK_WHOLE_SIZE, 0);
        sawNothing_ = false;
    }
    // Waits for the frame before, whose compaction read the groups.
    memoryBarrier(commands, kCompute, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, kTransfer,
                  VK_ACCESS_2_TRANSFER_WRITE_BIT);
    vkCmdFillBuffer(commands, groups_.get(), 0, VK_WHOLE_SIZE, 0);
    memoryBarrier(commands, kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT, kCompute,
                  VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
    bindings_.bind(commands, VK_PIPELINE_BIND_POINT_COMPUTE);
    computeStep(commands, cull_.at(specialization_), groupsFor(ksquads_, CULL_KSQUADS));
    recordLists(commands);
}

void CullPass::recordRest(VkCommandBuffer commands) const
{
    bindings_.bind(commands, VK_PIPELINE_BIND_POINT_COMPUTE);
    const std::uint32_t groups = (ksquads_ + CULL_KSQUADS - 1) / CULL_KSQUADS;
    computeStep(commands, rest_, groupsFor(groups, CULL_KSQUADS));
    computeStep(commands, occlusion_.at(specialization_), groupsFor(ksquads_, CULL_KSQUADS));
    recordLists(commands);
    memoryBarrier(commands, kCompute,
                  VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, kTransfer,
                  VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT);
    const VkBufferCopy all{0, 0, seenNow_.bytes()};
    vkCmdCopyBuffer(commands, seenNow_.get(), seen_.get(), 1, &all);
    memoryBarrier(commands, kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT, kCompute,
                  VK_ACCESS_2_SHADER_STORAGE_READ_BIT);
}

void CullPass::recordLists(VkCommandBuffer commands) const
{
    const GroupCount groups = groupsFor(ksquads_, CULL_KSQUADS);
    computeStep(commands, asking_, groups);
    computeStep(commands, scan_, {1, 1});
    computeStep(commands, compact_, groups);
}

GroupsOnDevice CullPass::visibleGroups() const
{
    return {lists_.get(), offsetof(gpu::ListGroups, visible)};
}

GroupsOnDevice CullPass::askingGroups() const
{
    return {lists_.get(), offsetof(gpu::ListGroups, asking)};
}

void CullPass::listMemory(std::vector<HeldMemory>& to) const
{
    to.push_back({"visible list", visible_.bytes() + askingList_.bytes()});
    to.push_back({"culling groups", groups_.bytes() + lists_.bytes()});
    to.push_back({"occlusion", candidates_.bytes() + seen_.bytes() + seenNow_.bytes()});
}

}  // namespace knotspan
