// Between culling and drawing: each visible KSQuad says how finely it is to be drawn, edges take the most
// that anybody along them asks for, and the grids that follow are cut into the tiles that a path draws
// (shaders/shared/borders.glsl).
#pragma once

#include <map>

#include "renderer/scene/held_memory.h"
#include "renderer/vulkan/pipeline.h"

namespace knotspan {

class SamplingPass {
public:
    SamplingPass(const Device& device, Bindings& bindings);

    // Makes room for a scene of that many KSQuads, drawn in draws of `tilesPerDraw` tiles (0: by task
    // groups). No frame may be in flight.
    void prepare(std::uint32_t ksquads, std::uint32_t tilesPerDraw, const Specialization& specialization);
    // The last frame wanted more tiles than there was room for: makes it, for the next.
    void makeRoomFor(std::uint32_t tiles);

    // Records the steps and the barriers around them. The VisibleList is made, the frame uploaded.
    // Groups for the lists of KSQuads that choose a grid and of those that are drawn. `keepsGrids`: the
    // frame's second half, in which only those choose that had not been asked.
    void record(VkCommandBuffer commands, const GroupsOnDevice& asking, const GroupsOnDevice& visible,
                bool keepsGrids) const;
    void listMemory(std::vector<HeldMemory>& to) const;

    [[nodiscard]] std::uint32_t tileCapacity() const { return tileCapacity_; }
    [[nodiscard]] VkBuffer draws() const { return draws_.get(); }
    [[nodiscard]] std::uint32_t drawCount() const { return drawCount_; }

private:
    const Device& device_;
    Bindings& bindings_;
    std::map<Specialization, Pipeline> sampling_;  // made when first needed
    Specialization specialization_;
    Pipeline count_;
    Pipeline scan_;
    Pipeline write_;
    Buffer grids_;
    Buffer tileCounts_;
    Buffer groups_;
    Buffer tiles_;
    Buffer draws_;
    std::uint32_t ksquads_ = 0;
    std::uint32_t tileCapacity_ = 0;
    std::uint32_t drawCount_ = 0;
};

}  // namespace knotspan
