// A line from the middle of each KSQuad to its front, evaluated on the device: nothing is uploaded for them.
// Of KSQuads that are trimmed it starts at a place that is left, and is none where less than about a
// hundredth is.
#pragma once

#include <map>
#include <utility>

#include "renderer/vulkan/pipeline.h"

namespace knotspan {

class NormalLines {
public:
    NormalLines(const Device& device, const Bindings& bindings) : device_(device), bindings_(bindings) {}

    // With stages for `specialization`, whose evaluator and order are the scene's; which has trimmed surfaces
    // or not.
    void prepare(const Specialization& specialization, bool trimmed);
    // Inside a rendering, with viewport and bindings set.
    void draw(VkCommandBuffer commands, std::uint32_t ksquads) const;

private:
    const Device& device_;
    const Bindings& bindings_;
    std::map<std::pair<Specialization, bool>, Pipeline> pipelines_;  // made when first needed
    std::pair<Specialization, bool> shown_;
};

}  // namespace knotspan
