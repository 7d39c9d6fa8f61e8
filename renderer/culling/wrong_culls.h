// Counting what culling drops though it shows: shaders/culling/wrong_culls.comp, which is made and run only
// when asked for, because it evaluates points all over each KSQuad that was dropped.
#pragma once

#include <map>

#include "renderer/vulkan/pipeline.h"

namespace knotspan {

class WrongCulls {
public:
    WrongCulls(const Device& device, Bindings& bindings) : device_(device), bindings_(bindings) {}

    void prepare(const Specialization& specialization);
    // Counts into gpu::Counters::wronglyCulled, once the scene and the frame are uploaded.
    void record(VkCommandBuffer commands, std::uint32_t ksquads, const Specialization& specialization) const;

private:
    const Device& device_;
    const Bindings& bindings_;
    std::map<Specialization, Pipeline> count_;
};

}  // namespace knotspan
