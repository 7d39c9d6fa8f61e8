#include "renderer/renderer.h"

#include <new>

#include "renderer/renderer_parts.h"

namespace knotspan {

namespace {

// The renderer's border: what is an exception inside is an Error outside.
template <class Work>
auto guarded(Work&& work, bool* deviceLost = nullptr) -> Result<decltype(work())>
{
    if (deviceLost != nullptr && *deviceLost)
        return failure("The graphics device stopped answering", "Save your work and start Knotspan again");
    try {
        if constexpr (std::is_void_v<decltype(work())>) {
            work();
            return {};
        } else {
            return work();
        }
    } catch (const VulkanError& error) {
        if (deviceLost != nullptr && error.deviceLost())
            *deviceLost = true;
        return tl::unexpected(error.error());
    } catch (const std::bad_alloc&) {
        return failure("The memory is full", "Close other programs, or open a smaller model");
    }
}

Validation validationFor(const RendererOptions& options)
{
    if (options.validation)
        return Validation::required;
#ifdef NDEBUG
    return Validation::off;
#else
    return Validation::whereInstalled;
#endif
}

}  // namespace

Result<std::unique_ptr<Renderer>> Renderer::create(const RendererOptions& options)
{
    return guarded([&] {
        auto parts = std::make_unique<Parts>(std::make_unique<Instance>(validationFor(options)), options);
        return std::unique_ptr<Renderer>(new Renderer(std::move(parts)));
    });
}

Result<std::vector<std::string>> Renderer::devices()
{
    return guarded([] {
        const Instance instance(Validation::off);
        std::vector<std::string> names;
        for (VkPhysicalDevice device : instance.devices()) {
            VkPhysicalDeviceProperties properties;
            vkGetPhysicalDeviceProperties(device, &properties);
            names.emplace_back(properties.deviceName);
        }
        if (names.empty())
            throw VulkanError(noDeviceError());
        return names;
    });
}

Renderer::Renderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Renderer::~Renderer() = default;

const std::string& Renderer::deviceName() const
{
    return parts_->device.name();
}

DeviceInfo Renderer::deviceInfo() const
{
    const std::uint32_t version = parts_->device.vulkanVersion();
    const std::string vulkan = std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
                               std::to_string(VK_API_VERSION_MINOR(version)) + "." +
                               std::to_string(VK_API_VERSION_PATCH(version));
    return {deviceName(), parts_->device.driver(), vulkan};
}

std::string Renderer::whyUnavailable(PathId path) const
{
    return pathFactory(path).whyUnavailable(parts_->device);
}

std::string Renderer::whyUnavailable(Precision precision) const
{
    return precision == Precision::float64 ? parts_->device.abilities().noDouble : std::string();
}

PathId Renderer::bestPath() const
{
    for (const PathInfo& path : paths())
        if (whyUnavailable(path.id).empty())
            return path.id;
    return paths().back().id;
}

Result<void> Renderer::sync(const Scene& scene, Joins joins)
{
    return guarded([&] { parts_->sync(scene, joins); }, &parts_->deviceLost);
}

bool Renderer::isPrepared(const Frame& frame) const
{
    return parts_->isPrepared(frame);
}

Result<FrameStats> Renderer::draw(const Frame& frame)
{
    return guarded([&] { return parts_->draw(frame, false); }, &parts_->deviceLost);
}

Result<Picture> Renderer::capture()
{
    if (!parts_->lastFrame)
        return failure("There is no picture yet", "Draw a frame first");
    return guarded([&] { return readPicture(parts_->device, parts_->shown()); }, &parts_->deviceLost);
}

Result<KsQuadIndices> Renderer::captureKsQuads()
{
    if (!parts_->lastFrame)
        return failure("There is no picture yet", "Draw a frame first");
    return guarded([&] { return parts_->targets->readKsQuads(); }, &parts_->deviceLost);
}

Result<Pick> Renderer::pick(double x, double y, double radiusPx)
{
    return guarded([&] { return parts_->pick(x, y, radiusPx); }, &parts_->deviceLost);
}

void* Renderer::instance() const
{
    return parts_->instance->get();
}

Result<std::unique_ptr<Swapchain>> Renderer::createSwapchain(std::uint64_t surface, int width, int height)
{
    return guarded(
        [&] {
            // A VkSurfaceKHR is a pointer on 64-bit machines and a number elsewhere.
            const auto handle = (VkSurfaceKHR)surface;  // NOLINT
            const VkExtent2D extent{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
            return std::make_unique<Swapchain>(std::unique_ptr<Swapchain::Parts>(
                new Swapchain::Parts{WindowImages(parts_->device, handle, extent)}));
        },
        &parts_->deviceLost);
}

Result<bool> Renderer::present(Swapchain& swapchain)
{
    if (!parts_->lastFrame)
        return failure("There is no picture yet", "Draw a frame first");
    return guarded([&] { return swapchain.parts().images.show(parts_->shown()); }, &parts_->deviceLost);
}

Result<std::vector<CapturedVertex>> Renderer::captureVertices(const Frame& frame)
{
    return guarded([&] { return parts_->captureVertices(frame); }, &parts_->deviceLost);
}

Result<Evaluations> Renderer::evaluate(const std::vector<EvaluationPoint>& points,
                                       const EvaluationOptions& options)
{
    return guarded([&] { return parts_->evaluate(points, options); }, &parts_->deviceLost);
}

Vec3 Renderer::surfaceOrigin(ObjectId object) const
{
    const auto* resident = parts_->scene.find(object);
    return resident != nullptr ? resident->frame.origin : Vec3(0);
}

std::vector<HeldMemory> Renderer::memory() const
{
    return parts_->memory();
}

std::vector<std::string> Renderer::validationMessages() const
{
    return parts_->instance->messages();
}

Swapchain::Swapchain(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Swapchain::~Swapchain() = default;

}  // namespace knotspan
