#include "renderer/culling/wrong_culls.h"

namespace knotspan {

void WrongCulls::prepare(const Specialization& specialization)
{
    if (count_.count(specialization) == 0)
        count_[specialization] = makeComputePipeline(device_, bindings_, "wrong_culls.comp", specialization);
}

void WrongCulls::record(VkCommandBuffer commands, std::uint32_t ksquads,
                        const Specialization& specialization) const
{
    bindings_.bind(commands, VK_PIPELINE_BIND_POINT_COMPUTE);
    computeStep(commands, count_.at(specialization), groupsFor(ksquads, CULL_KSQUADS));
}

}  // namespace knotspan
