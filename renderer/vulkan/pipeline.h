// The one descriptor set and pipeline layout that all pipelines share, and the making of pipelines from stage
// names.
#pragma once

#include <array>
#include <initializer_list>

#include "renderer/vulkan/buffer.h"
#include "shaders/shared/bindings.h"

namespace knotspan {

// One set of storage buffers, numbered by shaders/shared/bindings.h, and push constants for the overlays.
class Bindings {
public:
    explicit Bindings(const Device& device);

    // Binds the buffer, made anew where it is smaller than `bytes` or four times larger. Refuses, with a
    // sentence, what the device cannot bind; the binding then has no content. No frame may be in flight.
    void provide(int binding, Buffer& buffer, VkDeviceSize bytes);
    void bind(VkCommandBuffer commands, VkPipelineBindPoint point) const;
    void push(VkCommandBuffer commands, const void* data, std::uint32_t bytes) const;
    [[nodiscard]] VkPipelineLayout layout() const { return pipelineLayout_.get(); }

private:
    void allocateSet();
    void set(int binding, const Buffer& buffer);

    const Device& device_;
    DescriptorSetLayout setLayout_;
    PipelineLayout pipelineLayout_;
    DescriptorPool pool_;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    std::array<VkBuffer, BINDING_COUNT> bound_{};
    Buffer placeholder_;  // stands where nothing is bound yet
};

// What the renderer draws into: colour, the KSQuad's index + 1 and where in it (pixel_place.glsl), depth reversed (1 near, 0
// far).
constexpr VkFormat kColourFormat = VK_FORMAT_R8G8B8A8_UNORM;
constexpr VkFormat kIndexFormat = VK_FORMAT_R32G32_UINT;
constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;

// What stages are specialized for.
struct Specialization {
    std::uint32_t evaluator = 0;  // the number in evaluator_list.h
    bool captures = false;        // vertices are noted down
    std::uint32_t order = 16;     // as shaderOrderFor() gives it

    [[nodiscard]] auto operator<=>(const Specialization&) const = default;
};

// The smallest arrays that stages are compiled with and that hold degree + 1 numbers; degree at most 15.
[[nodiscard]] std::uint32_t shaderOrderFor(int degree);

struct GraphicsPipelineInfo {
    std::initializer_list<const char*> stages;  // file names: "surface.frag"
    VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    bool overlay = false;  // blended, writes neither depth nor the surface's index
    bool lines = false;    // for overlays
    Specialization specialization;
};

// Overlay pipelines set their depth comparison when they draw.
[[nodiscard]] Pipeline makeGraphicsPipeline(const Device& device, const Bindings& bindings,
                                            const GraphicsPipelineInfo& info);
[[nodiscard]] Pipeline makeComputePipeline(const Device& device, const Bindings& bindings, const char* stage,
                                           const Specialization& specialization = {});

// Groups for `count` items of work in two dimensions, because one holds only 65,535.
struct GroupCount {
    std::uint32_t x;
    std::uint32_t y;
};
[[nodiscard]] GroupCount groupsFor(std::uint32_t items, std::uint32_t itemsPerGroup);
// A dispatch, and what it wrote made visible to the compute stages after it. Bindings are set for compute.
void computeStep(VkCommandBuffer commands, const Pipeline& pipeline, const GroupCount& groups);
// The same for as many groups as a stage before wrote there, which is visible to indirect commands.
struct GroupsOnDevice {
    VkBuffer buffer;
    VkDeviceSize offset;
};
void computeStep(VkCommandBuffer commands, const Pipeline& pipeline, const GroupsOnDevice& groups);

}  // namespace knotspan
