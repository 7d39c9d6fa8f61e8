// Smooths the borders of trimmed surfaces in a picture, by how much of each pixel they cover.
#pragma once

#include <functional>
#include <map>

#include "renderer/scene/held_memory.h"
#include "renderer/vulkan/pipeline.h"

namespace knotspan {

class TrimEdges {
public:
    TrimEdges(const Device& device, Bindings& bindings);

    void prepare(VkExtent2D extent, Specialization specialization);

    // Some rows of the picture, and where in a buffer each pixel's colour is wanted (4 bytes), its depth (4
    // bytes) and what it shows (8 bytes).
    struct Rows {
        std::uint32_t first;
        std::uint32_t count;
        VkBuffer to;
        VkDeviceSize colours;
        VkDeviceSize depths;
        VkDeviceSize shown;
    };
    // Outside of rendering. Large pictures are smoothed some rows at a time, each of which `copy` is asked
    // for. The colours of the whole picture are then ready to be copied.
    struct Colours {
        VkBuffer buffer;
        VkDeviceSize offset;
    };
    Colours record(VkCommandBuffer commands, const std::function<void(const Rows&)>& copy) const;
    // How many rows at a time.
    [[nodiscard]] static std::uint32_t rowsAtOnce(VkExtent2D extent);

    void listMemory(std::vector<HeldMemory>& to) const;

private:
    void smoothRows(VkCommandBuffer commands, const Rows& rows,
                    const std::function<void(const Rows&)>& copy) const;

    const Device& device_;
    Bindings& bindings_;
    Pipeline find_;
    std::map<Specialization, Pipeline> codes_;
    Specialization specialization_;
    Pipeline blend_;
    Pipeline put_;
    VkExtent2D extent_{};
    Buffer pixels_;    // as drawn_pixels.glsl has them
    Buffer smoothed_;  // the whole picture's colours, where not all rows are done at once
};

}  // namespace knotspan
