// The culling pass of paths without a task stage: the chain of tests over all KSQuads, compacted in order
// into the VisibleList, and the indirect draws that go through it.
#pragma once

#include <map>

#include "model/geometry/basis_evaluators.h"
#include "renderer/vulkan/pipeline.h"

namespace knotspan {

class CullPass {
public:
    CullPass(const Device& device, Bindings& bindings);

    // Makes room for a scene of that many KSQuads drawn in draws of `patchesPerDraw`, evaluated by
    // `evaluator`.
    void prepare(std::uint32_t ksquads, std::uint32_t patchesPerDraw, Evaluator evaluator);

    // Records the three steps and the barriers around them. The scene and the frame are uploaded.
    void record(VkCommandBuffer commands) const;

    [[nodiscard]] VkBuffer draws() const { return draws_.get(); }
    [[nodiscard]] std::uint32_t drawCount() const { return drawCount_; }

private:
    const Device& device_;
    Bindings& bindings_;
    std::map<Evaluator, Pipeline> cull_;  // made when first needed
    Evaluator evaluator_ = Evaluator::triangular;
    Pipeline scan_;
    Pipeline compact_;
    Buffer visible_;
    Buffer groups_;
    Buffer draws_;
    std::uint32_t ksquads_ = 0;
    std::uint32_t drawCount_ = 0;
};

}  // namespace knotspan
