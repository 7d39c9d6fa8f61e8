// The scene's meshes in the picture: opaque, flat triangles that hide what is behind them, and that no pick
// finds. They are sent when others show than before; where they stand and their colours go with each draw.
#pragma once

#include "model/scene/scene.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/held_memory.h"
#include "renderer/vulkan/pipeline.h"

namespace knotspan {

class ReferenceMeshes {
public:
    ReferenceMeshes(const Device& device, Bindings& bindings, Uploader& uploader)
        : device_(device),
          bindings_(bindings),
          uploader_(uploader)
    {
    }

    // Refuses, with a sentence, what exceeds the device's buffers; nothing is held then.
    void sync(const Scene& scene);
    // What was written may not have arrived.
    void forget() { meshes_.clear(); }
    // Inside a rendering, with viewport and bindings set.
    void draw(VkCommandBuffer commands, const Camera& camera, const std::vector<ObjectId>& highlighted) const;
    void listMemory(std::vector<HeldMemory>& to) const;

private:
    struct Held {
        ObjectId id{};
        SharedMesh object;
        Vec3 origin{0};  // that vertices count from, in the mesh's own coordinates
        std::uint32_t firstCorner = 0;
    };
    [[nodiscard]] bool holdsMeshesOf(const std::vector<Held>& wanted) const;
    void send();

    const Device& device_;
    Bindings& bindings_;
    Uploader& uploader_;
    Pipeline pipeline_;  // made when first needed
    std::vector<Held> meshes_;
    Buffer vertices_;
    Buffer corners_;
};

}  // namespace knotspan
