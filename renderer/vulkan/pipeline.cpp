#include "renderer/vulkan/pipeline.h"

#include <algorithm>
#include <string_view>

#include "model/core/check.h"
#include "shaders/shared/layouts.h"
#include "shaders/spirv.h"

namespace knotspan {

namespace {

VkShaderStageFlagBits stageOf(std::string_view file)
{
    constexpr std::pair<std::string_view, VkShaderStageFlagBits> kStages[] = {
        {".vert", VK_SHADER_STAGE_VERTEX_BIT},
        {".tesc", VK_SHADER_STAGE_TESSELLATION_CONTROL_BIT},
        {".tese", VK_SHADER_STAGE_TESSELLATION_EVALUATION_BIT},
        {".geom", VK_SHADER_STAGE_GEOMETRY_BIT},
        {".task", VK_SHADER_STAGE_TASK_BIT_EXT},
        {".mesh", VK_SHADER_STAGE_MESH_BIT_EXT},
        {".frag", VK_SHADER_STAGE_FRAGMENT_BIT},
        {".comp", VK_SHADER_STAGE_COMPUTE_BIT}};
    const auto stage = std::find_if(std::begin(kStages), std::end(kStages),
                                    [&](const auto& entry) { return file.ends_with(entry.first); });
    check(stage != std::end(kStages), "the shader's file name ends in its stage");
    return stage->second;
}

ShaderModule makeModule(const Device& device, const char* file, std::uint32_t order)
{
    const auto words = spirv(file, order);
    check(!words.empty(), "the shader is embedded");
    VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    info.codeSize = words.size_bytes();
    info.pCode = words.data();
    VkShaderModule module = VK_NULL_HANDLE;
    vkCheck(vkCreateShaderModule(device.get(), &info, nullptr, &module), "loading a shader");
    return {device.get(), module};
}

VkPipelineShaderStageCreateInfo stageInfo(VkShaderModule module, VkShaderStageFlagBits stage)
{
    VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    info.stage = stage;
    info.module = module;
    info.pName = "main";
    return info;
}

// The specialization constants, the same for all stages; a stage takes those that it names. It stays where it
// was made.
struct Constants {
    Constants(bool lines, const Specialization& wanted)
        : values{lines ? VK_TRUE : VK_FALSE, wanted.evaluator, wanted.captures ? VK_TRUE : VK_FALSE}
    {
    }
    Constants(const Constants&) = delete;
    Constants& operator=(const Constants&) = delete;

    static constexpr VkSpecializationMapEntry kEntries[] = {
        {KNOTSPAN_LINES_CONSTANT, 0, sizeof(std::uint32_t)},
        {KNOTSPAN_EVALUATOR_CONSTANT, sizeof(std::uint32_t), sizeof(std::uint32_t)},
        {KNOTSPAN_CAPTURE_CONSTANT, 2 * sizeof(std::uint32_t), sizeof(std::uint32_t)}};
    std::uint32_t values[3];
    VkSpecializationInfo info{3, kEntries, sizeof(values), values};
};

// The state that does not come from shaders. Its parts point at one another, so it stays where it was made.
struct FixedState {
    explicit FixedState(const GraphicsPipelineInfo& info)
    {
        assembly.topology = info.topology;
        tessellation.patchControlPoints = 1;  // a patch is the index of a KSQuad
        viewport.viewportCount = 1;
        viewport.scissorCount = 1;
        raster.cullMode = VK_CULL_MODE_NONE;
        raster.lineWidth = 1.0F;
        multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
        depth.depthTestEnable = VK_TRUE;
        depth.depthWriteEnable = info.overlay ? VK_FALSE : VK_TRUE;
        depth.depthCompareOp = VK_COMPARE_OP_GREATER;
        blends[0].colorWriteMask =
            VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT;
        if (!info.overlay)
            blends[0].colorWriteMask |= VK_COLOR_COMPONENT_A_BIT;
        if (info.overlay) {
            blends[0].blendEnable = VK_TRUE;
            blends[0].srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
            blends[0].dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
        } else {
            blends[1].colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT;
        }
        blend.attachmentCount = static_cast<std::uint32_t>(blends.size());
        blend.pAttachments = blends.data();
        dynamic.dynamicStateCount = info.overlay ? 3 : 2;
        dynamic.pDynamicStates = kDynamicStates;
        rendering.colorAttachmentCount = 2;
        rendering.pColorAttachmentFormats = kColourFormats;
        rendering.depthAttachmentFormat = kDepthFormat;
    }
    FixedState(const FixedState&) = delete;
    FixedState& operator=(const FixedState&) = delete;

    static constexpr VkDynamicState kDynamicStates[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                                        VK_DYNAMIC_STATE_DEPTH_COMPARE_OP};
    static constexpr VkFormat kColourFormats[] = {kColourFormat, kIndexFormat};
    std::array<VkPipelineColorBlendAttachmentState, 2> blends{};
    VkPipelineVertexInputStateCreateInfo vertexInput{
        VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    VkPipelineInputAssemblyStateCreateInfo assembly{
        VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    VkPipelineTessellationStateCreateInfo tessellation{
        VK_STRUCTURE_TYPE_PIPELINE_TESSELLATION_STATE_CREATE_INFO};
    VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    VkPipelineMultisampleStateCreateInfo multisample{
        VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
    VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
    VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
};

}  // namespace

std::uint32_t shaderOrderFor(int degree)
{
    const auto order = std::find_if(std::begin(kShaderOrders), std::end(kShaderOrders),
                                    [&](std::uint32_t size) { return static_cast<int>(size) > degree; });
    check(order != std::end(kShaderOrders), "degrees are at most 15");
    return *order;
}

Bindings::Bindings(const Device& device) : device_(device), placeholder_(device, 256, Buffer::Place::device)
{
    VkShaderStageFlags stages = VK_SHADER_STAGE_ALL_GRAPHICS | VK_SHADER_STAGE_COMPUTE_BIT;
    if (device.abilities().noMeshStages.empty())
        stages |= VK_SHADER_STAGE_TASK_BIT_EXT | VK_SHADER_STAGE_MESH_BIT_EXT;
    std::array<VkDescriptorSetLayoutBinding, BINDING_COUNT> bindings{};
    for (std::uint32_t i = 0; i < BINDING_COUNT; ++i)
        bindings[i] = {i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, stages, nullptr};
    VkDescriptorSetLayoutCreateInfo setInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    setInfo.bindingCount = BINDING_COUNT;
    setInfo.pBindings = bindings.data();
    VkDescriptorSetLayout setLayout = VK_NULL_HANDLE;
    vkCheck(vkCreateDescriptorSetLayout(device.get(), &setInfo, nullptr, &setLayout), "making a layout");
    setLayout_ = {device.get(), setLayout};

    const VkPushConstantRange range{VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                                    std::max(sizeof(gpu::OverlayConstants), sizeof(gpu::MeshConstants))};
    VkPipelineLayoutCreateInfo layoutInfo{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    layoutInfo.setLayoutCount = 1;
    layoutInfo.pSetLayouts = &setLayout;
    layoutInfo.pushConstantRangeCount = 1;
    layoutInfo.pPushConstantRanges = &range;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    vkCheck(vkCreatePipelineLayout(device.get(), &layoutInfo, nullptr, &layout), "making a layout");
    pipelineLayout_ = {device.get(), layout};

    allocateSet();
    for (int binding = 0; binding < BINDING_COUNT; ++binding)
        set(binding, placeholder_);
}

void Bindings::allocateSet()
{
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, BINDING_COUNT};
    VkDescriptorPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    poolInfo.maxSets = 1;
    poolInfo.poolSizeCount = 1;
    poolInfo.pPoolSizes = &size;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    vkCheck(vkCreateDescriptorPool(device_.get(), &poolInfo, nullptr, &pool), "making a descriptor pool");
    pool_ = {device_.get(), pool};
    const VkDescriptorSetLayout setLayout = setLayout_.get();
    VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocate.descriptorPool = pool;
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = &setLayout;
    vkCheck(vkAllocateDescriptorSets(device_.get(), &allocate, &set_), "making a descriptor set");
}

void Bindings::set(int binding, const Buffer& buffer)
{
    bound_[static_cast<size_t>(binding)] = buffer.get();
    const VkDescriptorBufferInfo info{buffer.get(), 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set_;
    write.dstBinding = static_cast<std::uint32_t>(binding);
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    write.pBufferInfo = &info;
    vkUpdateDescriptorSets(device_.get(), 1, &write, 0, nullptr);
}

void Bindings::provide(int binding, Buffer& buffer, VkDeviceSize bytes)
{
    const VkDeviceSize most = device_.limits().maxStorageBufferRange;
    if (bytes > most)
        throw VulkanError({"The model needs a buffer of " + std::to_string(bytes >> 20U) + " MB and " +
                               device_.name() + " takes at most " + std::to_string(most >> 20U) + " MB",
                           {},
                           "Hide or remove some objects, or choose another device with --device"});
    constexpr VkDeviceSize kLeast = 256;
    const VkDeviceSize wanted = std::max(bytes, kLeast);
    if (buffer.bytes() >= wanted && buffer.bytes() / 4 <= wanted) {
        // What else is bound to this number by turns, as a path's buffers, may stand there now.
        if (bound_[static_cast<size_t>(binding)] != buffer.get())
            set(binding, buffer);
        return;
    }
    set(binding, placeholder_);
    buffer = {};  // first, so that both never live at once
    buffer = Buffer(device_, wanted, Buffer::Place::device);
    set(binding, buffer);
}

void Bindings::bind(VkCommandBuffer commands, VkPipelineBindPoint point) const
{
    vkCmdBindDescriptorSets(commands, point, pipelineLayout_.get(), 0, 1, &set_, 0, nullptr);
}

void Bindings::push(VkCommandBuffer commands, const void* data, std::uint32_t bytes) const
{
    vkCmdPushConstants(commands, pipelineLayout_.get(),
                       VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0, bytes, data);
}

Pipeline makeGraphicsPipeline(const Device& device, const Bindings& bindings,
                              const GraphicsPipelineInfo& info)
{
    const Constants constants(info.lines, info.specialization);
    std::vector<ShaderModule> modules;
    std::vector<VkPipelineShaderStageCreateInfo> stages;
    for (const char* file : info.stages) {
        modules.push_back(makeModule(device, file, info.specialization.order));
        stages.push_back(stageInfo(modules.back().get(), stageOf(file)));
        stages.back().pSpecializationInfo = &constants.info;
    }

    const FixedState state(info);
    VkGraphicsPipelineCreateInfo create{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
    create.pNext = &state.rendering;
    create.stageCount = static_cast<std::uint32_t>(stages.size());
    create.pStages = stages.data();
    if (stages.front().stage == VK_SHADER_STAGE_VERTEX_BIT) {
        create.pVertexInputState = &state.vertexInput;
        create.pInputAssemblyState = &state.assembly;
    }
    if (info.topology == VK_PRIMITIVE_TOPOLOGY_PATCH_LIST)
        create.pTessellationState = &state.tessellation;
    create.pViewportState = &state.viewport;
    create.pRasterizationState = &state.raster;
    create.pMultisampleState = &state.multisample;
    create.pDepthStencilState = &state.depth;
    create.pColorBlendState = &state.blend;
    create.pDynamicState = &state.dynamic;
    create.layout = bindings.layout();
    VkPipeline pipeline = VK_NULL_HANDLE;
    vkCheck(vkCreateGraphicsPipelines(device.get(), VK_NULL_HANDLE, 1, &create, nullptr, &pipeline),
            "preparing a drawing pipeline");
    return {device.get(), pipeline};
}

Pipeline makeComputePipeline(const Device& device, const Bindings& bindings, const char* stage,
                             const Specialization& specialization)
{
    const Constants constants(false, specialization);
    const ShaderModule module = makeModule(device, stage, specialization.order);
    VkComputePipelineCreateInfo create{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    create.stage = stageInfo(module.get(), stageOf(stage));
    create.stage.pSpecializationInfo = &constants.info;
    create.layout = bindings.layout();
    VkPipeline pipeline = VK_NULL_HANDLE;
    vkCheck(vkCreateComputePipelines(device.get(), VK_NULL_HANDLE, 1, &create, nullptr, &pipeline),
            "preparing a computing pipeline");
    return {device.get(), pipeline};
}

GroupCount groupsFor(std::uint32_t items, std::uint32_t itemsPerGroup)
{
    constexpr std::uint32_t kMostGroups = 65535;
    const std::uint32_t groups = (items + itemsPerGroup - 1) / itemsPerGroup;
    const std::uint32_t x = std::clamp(groups, 1U, kMostGroups);
    return {x, (groups + x - 1) / x};
}

namespace {

void showToCompute(VkCommandBuffer commands)
{
    constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    memoryBarrier(commands, kCompute, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, kCompute,
                  VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
}

}  // namespace

void computeStep(VkCommandBuffer commands, const Pipeline& pipeline, const GroupCount& groups)
{
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get());
    vkCmdDispatch(commands, groups.x, groups.y, 1);
    showToCompute(commands);
}

void computeStep(VkCommandBuffer commands, const Pipeline& pipeline, const GroupsOnDevice& groups)
{
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get());
    vkCmdDispatchIndirect(commands, groups.buffer, groups.offset);
    showToCompute(commands);
}

}  // namespace knotspan
