// The images of a window that the renderer shows its frames in; made by Renderer::createSwapchain() and gone
// before the window's surface and the renderer.
#pragma once

#include <memory>

namespace knotspan {

class Swapchain {
public:
    struct Parts;
    explicit Swapchain(std::unique_ptr<Parts> parts);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    [[nodiscard]] Parts& parts() { return *parts_; }

private:
    std::unique_ptr<Parts> parts_;
};

}  // namespace knotspan
