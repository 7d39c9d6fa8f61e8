// Control nets: lines and points straight from the bound control points, dimmer where the surface hides them.
#pragma once

#include "renderer/scene/gpu_scene.h"

namespace knotspan {

class ControlNet {
public:
    ControlNet(const Device& device, const Bindings& bindings);

    // Inside a rendering, with viewport and bindings set. `surface` is the number of the record.
    void drawNet(VkCommandBuffer commands, std::uint32_t surface, const NurbsSurface& net) const;
    void drawMark(VkCommandBuffer commands, std::uint32_t surface, std::uint32_t point, bool selected) const;

private:
    const Bindings& bindings_;
    Pipeline lines_;
    Pipeline points_;
};

}  // namespace knotspan
