// Moves the control points on the device by a wave, and back: a deforming model of which no byte travels.
#pragma once

#include <optional>

#include "model/scene/deformation.h"
#include "renderer/scene/gpu_scene.h"

namespace knotspan {

class WavePass {
public:
    WavePass(const Device& device, Bindings& bindings, Uploader& uploader);

    // Before the frame is recorded. `wave`: what the frame asks for; nothing: the model at rest.
    void prepare(const GpuScene& scene, const std::optional<Wave>& wave);
    // Before the frame's uploads: they change the model at rest.
    void recordRest(VkCommandBuffer commands);
    // After them.
    void recordWave(VkCommandBuffer commands);
    // The scene was packed anew, or what was recorded may not have run.
    void forget() { moved_ = false; }

private:
    const Device& device_;
    Bindings& bindings_;
    Uploader& uploader_;
    Pipeline pipeline_;  // made when first needed
    Buffer rest_;
    Buffer waves_;
    VkBuffer points_ = VK_NULL_HANDLE;
    VkDeviceSize bytes_ = 0;
    std::uint32_t count_ = 0;
    bool waving_ = false;
    bool moved_ = false;  // the device's points are not at rest
};

}  // namespace knotspan
