// The culling pass of paths without a task stage: the chain of tests over all KSQuads, compacted in order
// into the VisibleList.
#pragma once

#include <map>

#include "renderer/scene/held_memory.h"
#include "renderer/vulkan/pipeline.h"

namespace knotspan {

class CullPass {
public:
    CullPass(const Device& device, Bindings& bindings);

    // Makes room for a scene of that many KSQuads, with stages for `specialization`.
    void prepare(std::uint32_t ksquads, const Specialization& specialization);

    // Records the three steps and the barriers around them. The scene and the frame are uploaded.
    void record(VkCommandBuffer commands) const;
    void listMemory(std::vector<HeldMemory>& to) const;

private:
    const Device& device_;
    Bindings& bindings_;
    std::map<Specialization, Pipeline> cull_;  // made when first needed
    Specialization specialization_;
    Pipeline scan_;
    Pipeline compact_;
    Buffer visible_;
    Buffer groups_;
    std::uint32_t ksquads_ = 0;
};

}  // namespace knotspan
