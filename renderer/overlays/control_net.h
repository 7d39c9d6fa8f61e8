// Control nets: lines and points straight from the bound control points, dimmer where the surface hides them.
#pragma once

#include "renderer/scene/gpu_scene.h"

namespace knotspan {

class ControlNet {
public:
    ControlNet(const Device& device, const Bindings& bindings);

    struct Parts {
        bool points = true;
        bool hulls = true;  // the lines between them
    };
    // Inside a rendering, with viewport and bindings set. `surface` is the number of the record.
    void draw(VkCommandBuffer commands, std::uint32_t surface, const NurbsSurface& net, Parts parts) const;

private:
    void drawPart(VkCommandBuffer commands, const Pipeline& pipeline, gpu::OverlayConstants constants,
                  bool hidden, std::uint32_t vertices) const;

    const Bindings& bindings_;
    Pipeline lines_;
    Pipeline points_;
};

}  // namespace knotspan
