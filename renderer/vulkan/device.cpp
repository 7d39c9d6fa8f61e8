#include "renderer/vulkan/device.h"

#include <algorithm>
#include <cstring>

#include "shaders/shared/bindings.h"

namespace knotspan {

namespace {

int rank(VkPhysicalDevice device)
{
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(device, &properties);
    switch (properties.deviceType) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return 0;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return 1;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        return 2;
    default:
        return 3;
    }
}

VkPhysicalDevice choose(const std::vector<VkPhysicalDevice>& devices, std::optional<int> index)
{
    if (devices.empty())
        throw VulkanError(noDeviceError());
    if (!index)
        return *std::min_element(devices.begin(), devices.end(),
                                 [](auto a, auto b) { return rank(a) < rank(b); });
    if (*index < 0 || *index >= static_cast<int>(devices.size()))
        throw VulkanError({"There is no Vulkan device number " + std::to_string(*index),
                           {},
                           "Choose one from 0 to " + std::to_string(devices.size() - 1)});
    return devices[static_cast<size_t>(*index)];
}

bool hasExtension(VkPhysicalDevice device, const char* name)
{
    std::uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
    return std::any_of(extensions.begin(), extensions.end(), [&](const auto& extension) {
        return std::strcmp(extension.extensionName, name) == 0;
    });
}

std::vector<VkQueueFamilyProperties> queueFamilies(VkPhysicalDevice device)
{
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    return families;
}

// One queue does everything: graphics and compute.
std::uint32_t findQueueFamily(VkPhysicalDevice device)
{
    const auto families = queueFamilies(device);
    constexpr VkQueueFlags kNeeded = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (std::uint32_t family = 0; family < families.size(); ++family)
        if ((families[family].queueFlags & kNeeded) == kNeeded)
            return family;
    throw VulkanError({"The graphics device cannot draw", {}, "Choose another device with --device"});
}

}  // namespace

// Through the empty device, so that the destructor cleans up where something here fails.
Device::Device(const Instance& instance, std::optional<int> index) : Device()
{
    physical_ = choose(instance.devices(), index);
    vkGetPhysicalDeviceProperties(physical_, &properties_);
    vkGetPhysicalDeviceMemoryProperties(physical_, &memory_);
    name_ = properties_.deviceName;
    queueFamily_ = findQueueFamily(physical_);
    findAbilities();
    createLogicalDevice();

    VkCommandPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    poolInfo.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    poolInfo.queueFamilyIndex = queueFamily_;
    VkCommandPool pool = VK_NULL_HANDLE;
    vkCheck(vkCreateCommandPool(device_, &poolInfo, nullptr, &pool), "making a command pool");
    commandPool_ = {device_, pool};
    VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = pool;
    allocate.commandBufferCount = 1;
    vkCheck(vkAllocateCommandBuffers(device_, &allocate, &commands_), "making a command buffer");
    const VkFenceCreateInfo fenceInfo{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    VkFence fence = VK_NULL_HANDLE;
    vkCheck(vkCreateFence(device_, &fenceInfo, nullptr, &fence), "making a fence");
    done_ = {device_, fence};
}

Device::~Device()
{
    if (device_ == VK_NULL_HANDLE)
        return;
    vkDeviceWaitIdle(device_);
    done_ = {};
    commandPool_ = {};
    vkDestroyDevice(device_, nullptr);
}

void Device::findAbilities()
{
    VkPhysicalDeviceMeshShaderFeaturesEXT mesh{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MESH_SHADER_FEATURES_EXT};
    VkPhysicalDeviceVulkan12Features features12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
    features.pNext = &features12;
    const bool meshExtension = hasExtension(physical_, VK_EXT_MESH_SHADER_EXTENSION_NAME);
    if (meshExtension)
        features12.pNext = &mesh;
    vkGetPhysicalDeviceFeatures2(physical_, &features);
    // Every desktop driver has these, though Vulkan 1.3 does not promise them.
    if (features12.scalarBlockLayout == VK_FALSE || features.features.independentBlend == VK_FALSE ||
        features.features.fragmentStoresAndAtomics == VK_FALSE ||
        features.features.shaderCullDistance == VK_FALSE ||
        properties_.limits.maxPerStageDescriptorStorageBuffers < BINDING_COUNT)
        throw VulkanError({"The graphics device " + name_ + " lacks what Knotspan draws with",
                           {},
                           "Choose another device with --device, or update its driver"});

    if (!meshExtension || mesh.taskShader == VK_FALSE || mesh.meshShader == VK_FALSE)
        abilities_.noMeshStages =
            "This device (" + name_ + ") has no task and mesh stages. A newer driver may have them";
    if (features.features.tessellationShader == VK_FALSE ||
        features.features.vertexPipelineStoresAndAtomics == VK_FALSE)
        abilities_.noTessellation = "This device (" + name_ + ") has no tessellation stages that can count";
    if (features.features.geometryShader == VK_FALSE ||
        features.features.vertexPipelineStoresAndAtomics == VK_FALSE)
        abilities_.noGeometry = "This device (" + name_ + ") has no geometry stage that can count";
    if (features.features.shaderFloat64 == VK_FALSE)
        abilities_.noDouble = "This device (" + name_ + ") does not compute in double";
    abilities_.maxTessellationLevel = std::min(64U, properties_.limits.maxTessellationGenerationLevel);
    abilities_.swapchain = hasExtension(physical_, VK_KHR_SWAPCHAIN_EXTENSION_NAME);

    VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    VkPhysicalDeviceMeshShaderPropertiesEXT meshLimits{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MESH_SHADER_PROPERTIES_EXT};
    if (meshExtension)
        driver.pNext = &meshLimits;
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &driver, {}};
    vkGetPhysicalDeviceProperties2(physical_, &properties);
    driver_ = std::string(driver.driverName) + ", " + driver.driverInfo;
    if (driver.driverID == VK_DRIVER_ID_MESA_LLVMPIPE)
        abilities_.tessellatedVerticesPerDraw = 65535;
    // Beside the limits, what the makers advise: NVIDIA 64 vertices and 126 triangles, AMD 128 and 256.
    const bool nvidia = driver.driverID == VK_DRIVER_ID_NVIDIA_PROPRIETARY;
    const bool amd = driver.driverID == VK_DRIVER_ID_AMD_PROPRIETARY ||
                     driver.driverID == VK_DRIVER_ID_AMD_OPEN_SOURCE ||
                     driver.driverID == VK_DRIVER_ID_MESA_RADV;
    abilities_.meshVertices = std::min(nvidia ? 64U : amd ? 128U : 256U, meshLimits.maxMeshOutputVertices);
    abilities_.meshTriangles = std::min(nvidia ? 126U : 256U, meshLimits.maxMeshOutputPrimitives);
}

void Device::createLogicalDevice()
{
    const bool mesh = abilities_.noMeshStages.empty();
    const bool tessellation = abilities_.noTessellation.empty();
    VkPhysicalDeviceMeshShaderFeaturesEXT meshFeatures{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MESH_SHADER_FEATURES_EXT};
    meshFeatures.taskShader = VK_TRUE;
    meshFeatures.meshShader = VK_TRUE;
    VkPhysicalDeviceVulkan13Features features13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    features13.pNext = mesh ? &meshFeatures : nullptr;
    features13.dynamicRendering = VK_TRUE;
    features13.synchronization2 = VK_TRUE;
    features13.maintenance4 = VK_TRUE;
    VkPhysicalDeviceVulkan12Features features12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
    features12.pNext = &features13;
    features12.scalarBlockLayout = VK_TRUE;
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
    features.pNext = &features12;
    features.features.tessellationShader = tessellation ? VK_TRUE : VK_FALSE;
    const bool geometry = abilities_.noGeometry.empty();
    features.features.geometryShader = geometry ? VK_TRUE : VK_FALSE;
    features.features.vertexPipelineStoresAndAtomics = tessellation || geometry ? VK_TRUE : VK_FALSE;
    features.features.shaderFloat64 = abilities_.noDouble.empty() ? VK_TRUE : VK_FALSE;
    VkPhysicalDeviceFeatures present;
    vkGetPhysicalDeviceFeatures(physical_, &present);
    features.features.multiDrawIndirect = present.multiDrawIndirect;
    features.features.largePoints = present.largePoints;
    features.features.independentBlend = VK_TRUE;
    features.features.fragmentStoresAndAtomics = VK_TRUE;
    features.features.shaderCullDistance = VK_TRUE;

    std::vector<const char*> extensions;
    if (mesh)
        extensions.push_back(VK_EXT_MESH_SHADER_EXTENSION_NAME);
    if (abilities_.swapchain)
        extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    const float priority = 1.0F;
    VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue.queueFamilyIndex = queueFamily_;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    info.pNext = &features;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    vkCheck(vkCreateDevice(physical_, &info, nullptr, &device_), "being opened");
    vkGetDeviceQueue(device_, queueFamily_, 0, &queue_);
    drawMeshTasks_ =
        reinterpret_cast<PFN_vkCmdDrawMeshTasksEXT>(vkGetDeviceProcAddr(device_, "vkCmdDrawMeshTasksEXT"));
    drawMeshTasksIndirect_ = reinterpret_cast<PFN_vkCmdDrawMeshTasksIndirectEXT>(
        vkGetDeviceProcAddr(device_, "vkCmdDrawMeshTasksIndirectEXT"));
}

std::uint32_t Device::timestampBits() const
{
    return queueFamilies(physical_)[queueFamily_].timestampValidBits;
}

std::uint32_t Device::memoryType(std::uint32_t allowed, VkMemoryPropertyFlags required,
                                 VkMemoryPropertyFlags preferred) const
{
    for (const VkMemoryPropertyFlags wanted : {required | preferred, required})
        for (std::uint32_t type = 0; type < memory_.memoryTypeCount; ++type)
            if ((allowed >> type & 1U) != 0 && (memory_.memoryTypes[type].propertyFlags & wanted) == wanted)
                return type;
    throw VulkanError({"The graphics device has no memory of a kind that Knotspan needs",
                       {},
                       "Choose another device with --device"});
}

void Device::execute(const std::function<void(VkCommandBuffer)>& record, VkSemaphore wait,
                     VkSemaphore signal) const
{
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    vkCheck(vkBeginCommandBuffer(commands_, &begin), "starting to record");
    try {
        record(commands_);
    } catch (...) {
        vkResetCommandBuffer(commands_, 0);
        throw;
    }
    vkCheck(vkEndCommandBuffer(commands_), "recording");

    VkCommandBufferSubmitInfo commands{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
    commands.commandBuffer = commands_;
    VkSemaphoreSubmitInfo waitInfo{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO};
    waitInfo.semaphore = wait;
    waitInfo.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    VkSemaphoreSubmitInfo signalInfo{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO};
    signalInfo.semaphore = signal;
    signalInfo.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &commands;
    submit.waitSemaphoreInfoCount = wait != VK_NULL_HANDLE ? 1 : 0;
    submit.pWaitSemaphoreInfos = &waitInfo;
    submit.signalSemaphoreInfoCount = signal != VK_NULL_HANDLE ? 1 : 0;
    submit.pSignalSemaphoreInfos = &signalInfo;
    const VkFence fence = done_.get();
    vkCheck(vkQueueSubmit2(queue_, 1, &submit, fence), "taking work");
    vkCheck(vkWaitForFences(device_, 1, &fence, VK_TRUE, UINT64_MAX), "drawing");
    vkCheck(vkResetFences(device_, 1, &fence), "drawing");
}

void memoryBarrier(VkCommandBuffer commands, VkPipelineStageFlags2 before, VkAccessFlags2 written,
                   VkPipelineStageFlags2 after, VkAccessFlags2 read)
{
    VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    barrier.srcStageMask = before;
    barrier.srcAccessMask = written;
    barrier.dstStageMask = after;
    barrier.dstAccessMask = read;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace knotspan
