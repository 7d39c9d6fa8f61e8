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

    // Makes room for a scene of that many KSQuads, with stages for `specialization`. `anew`: they are others
    // than in the last frame.
    void prepare(std::uint32_t ksquads, const Specialization& specialization, bool byOcclusion, bool anew);

    // Records the steps and the barriers around them. The scene and the frame are uploaded. By occlusion: the
    // list of what the last frame saw.
    void record(VkCommandBuffer commands);
    // By occlusion, after that was drawn and the depth pyramid made: the list of the rest.
    void recordRest(VkCommandBuffer commands) const;
    // The groups for the list that was made last, on the device.
    [[nodiscard]] GroupsOnDevice visibleGroups() const;
    [[nodiscard]] GroupsOnDevice askingGroups() const;
    void listMemory(std::vector<HeldMemory>& to) const;

private:
    void recordLists(VkCommandBuffer commands) const;

    const Device& device_;
    Bindings& bindings_;
    std::map<Specialization, Pipeline> cull_;  // made when first needed
    Specialization specialization_;
    Pipeline rest_;
    Pipeline asking_;
    Pipeline scan_;
    Pipeline compact_;
    Buffer visible_;
    Buffer askingList_;
    Buffer groups_;
    Buffer lists_;
    std::uint32_t ksquads_ = 0;
    // By occlusion.
    bool byOcclusion_ = false;
    std::map<Specialization, Pipeline> occlusion_;
    Buffer candidates_;
    Buffer seen_;
    Buffer seenNow_;
    bool sawNothing_ = true;  // seen_ is to be cleared
};

}  // namespace knotspan
