#include "renderer/vulkan/instance.h"

#include <cstdio>
#include <cstring>

namespace knotspan {

namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

bool layerInstalled(const char* name)
{
    std::uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    for (const VkLayerProperties& layer : layers)
        if (std::strcmp(layer.layerName, name) == 0)
            return true;
    return false;
}

std::vector<const char*> availableOf(std::initializer_list<const char*> wanted)
{
    std::uint32_t count = 0;
    vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> present(count);
    vkEnumerateInstanceExtensionProperties(nullptr, &count, present.data());
    std::vector<const char*> found;
    for (const char* name : wanted)
        for (const VkExtensionProperties& extension : present)
            if (std::strcmp(extension.extensionName, name) == 0)
                found.push_back(name);
    return found;
}

}  // namespace

Error noDeviceError()
{
    return {"No Vulkan 1.3 device was found",
            {},
            "Install your graphics card's Vulkan driver; without a graphics card, the package "
            "mesa-vulkan-drivers draws in software (on Debian 12 take it from bookworm-backports, which also "
            "has the mesh stages)"};
}

Instance::Instance(Validation validation)
{
    const bool installed = validation != Validation::off && layerInstalled(kValidationLayer);
    if (validation == Validation::required && !installed)
        throw VulkanError({"The Vulkan validation layer is not installed",
                           {},
                           "Install the package vulkan-validationlayers"});

    std::vector<const char*> extensions = availableOf(
        {"VK_KHR_surface", "VK_KHR_xcb_surface", "VK_KHR_xlib_surface", "VK_KHR_wayland_surface"});
    if (installed) {
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
        extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
    }

    const VkValidationFeatureEnableEXT synchronization =
        VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = &synchronization;
    VkDebugUtilsMessengerCreateInfoEXT messenger{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
    messenger.pNext = &features;
    messenger.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    messenger.messageType =
        VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    messenger.pfnUserCallback = &Instance::receive;
    messenger.pUserData = this;

    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.pApplicationName = "Knotspan";
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    if (installed) {
        info.pNext = &messenger;
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = &kValidationLayer;
    }
    const VkResult result = vkCreateInstance(&info, nullptr, &instance_);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER)  // what a loader without a single driver says
        throw VulkanError(noDeviceError());
    vkCheck(result, "starting Vulkan");
#ifdef __SANITIZE_ADDRESS__
    // A second instance that stays keeps the driver loaded to the end: only so can the leak checker tell what
    // the driver keeps from what we lose.
    static VkInstance kept = VK_NULL_HANDLE;
    if (kept == VK_NULL_HANDLE)
        vkCreateInstance(&info, nullptr, &kept);
#endif

    if (installed) {
        messenger.pNext = nullptr;
        const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
        if (create != nullptr)
            create(instance_, &messenger, nullptr, &messenger_);
    }
}

Instance::~Instance()
{
    if (messenger_ != VK_NULL_HANDLE) {
        const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
        destroy(instance_, messenger_, nullptr);
    }
    vkDestroyInstance(instance_, nullptr);
}

std::vector<std::string> Instance::messages() const
{
    const std::lock_guard lock(mutex_);
    return messages_;
}

std::vector<VkPhysicalDevice> Instance::devices() const
{
    std::uint32_t count = 0;
    vkEnumeratePhysicalDevices(instance_, &count, nullptr);
    std::vector<VkPhysicalDevice> all(count);
    vkEnumeratePhysicalDevices(instance_, &count, all.data());
    all.resize(count);
    std::erase_if(all, [](VkPhysicalDevice device) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(device, &properties);
        return properties.apiVersion < VK_API_VERSION_1_3;
    });
    return all;
}

VkBool32 VKAPI_PTR Instance::receive(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                     const VkDebugUtilsMessengerCallbackDataEXT* data, void* self)
{
    auto* instance = static_cast<Instance*>(self);
    const std::lock_guard lock(instance->mutex_);
    instance->messages_.emplace_back(data->pMessage);
    std::fprintf(stderr, "Vulkan validation: %s\n", data->pMessage);
    return VK_FALSE;
}

}  // namespace knotspan
