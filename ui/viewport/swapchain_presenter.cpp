// Copies each frame into the swapchain of an own native window inside the viewport. No copy to the CPU.
// Vulkan's header comes first: Qt's defines VK_NO_PROTOTYPES.
#include <vulkan/vulkan.h>

#include <QGuiApplication>
#include <QPlatformSurfaceEvent>
#include <QPointer>
#include <QVulkanInstance>
#include <QWindow>

#include "renderer/swapchain.h"
#include "ui/viewport/presenter.h"

namespace knotspan {

namespace {

// A window that gives its swapchain up before its surface goes.
class SurfaceWindow : public QWindow {
public:
    SurfaceWindow() { setSurfaceType(QSurface::VulkanSurface); }

    std::unique_ptr<Swapchain> swapchain;
    QSize swapchainSize;

protected:
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::PlatformSurface &&
            static_cast<QPlatformSurfaceEvent*>(event)->surfaceEventType() ==
                QPlatformSurfaceEvent::SurfaceAboutToBeDestroyed)
            swapchain.reset();
        return QWindow::event(event);
    }
};

class SwapchainPresenter : public Presenter {
public:
    SwapchainPresenter(Renderer& renderer, std::unique_ptr<QVulkanInstance> instance)
        : renderer_(renderer),
          instance_(std::move(instance)),
          window_(new SurfaceWindow)
    {
        window_->setVulkanInstance(instance_.get());
        container_ = QWidget::createWindowContainer(window_);  // owns the window
        container_->setFocusPolicy(Qt::StrongFocus);
    }

    ~SwapchainPresenter() override
    {
        if (window_)
            window_->swapchain.reset();
        delete container_;
    }

    QWidget* widget() override { return container_; }
    QObject* surface() override { return window_; }
    double pixelRatio() const override { return window_->devicePixelRatio(); }
    QSize pixelSize() const override
    {
        return window_->isExposed() ? (QSizeF(window_->size()) * pixelRatio()).toSize() : QSize();
    }
    void setCursor(const QCursor& cursor) override { window_->setCursor(cursor); }

    Result<void> show() override
    {
        // The first try may meet a swapchain that no longer fits; a second misfit waits for the next frame.
        for (int attempt = 0; attempt < 2; ++attempt) {
            if (Result<void> fitting = fit(); !fitting)
                return fitting;
            const Result<bool> shown = renderer_.present(*window_->swapchain);
            if (!shown)
                return tl::unexpected(shown.error());
            if (*shown)
                return {};
            window_->swapchain.reset();
        }
        return {};
    }

private:
    Result<void> fit()
    {
        const QSize size = pixelSize();
        if (window_->swapchain && window_->swapchainSize == size)
            return {};
        window_->swapchain.reset();
        const VkSurfaceKHR surface = QVulkanInstance::surfaceForWindow(window_);
        if (surface == VK_NULL_HANDLE)
            return failure("The window system gives no Vulkan surface for this window");
        // A cast that fits both kinds of handle: a pointer on 64-bit systems, a number on others.
        auto made = renderer_.createSwapchain((std::uint64_t)surface, size.width(), size.height());
        if (!made)
            return tl::unexpected(made.error());
        window_->swapchain = std::move(*made);
        window_->swapchainSize = size;
        return {};
    }

    Renderer& renderer_;
    std::unique_ptr<QVulkanInstance> instance_;
    QPointer<QWidget> container_;
    QPointer<SurfaceWindow> window_;
};

bool platformHasSurfaces()
{
    const QString platform = QGuiApplication::platformName();
    return platform != QLatin1String("offscreen") && platform != QLatin1String("minimal") &&
           platform != QLatin1String("vnc") && platform != QLatin1String("linuxfb");
}

}  // namespace

std::unique_ptr<Presenter> makePresenter(Renderer& renderer)
{
    if (platformHasSurfaces()) {
        auto instance = std::make_unique<QVulkanInstance>();
        instance->setVkInstance(static_cast<VkInstance>(renderer.instance()));
        if (instance->create())
            return std::make_unique<SwapchainPresenter>(renderer, std::move(instance));
    }
    return makeImagePresenter(renderer);
}

}  // namespace knotspan
