// Shows the renderer's last drawn frame in a window: through a swapchain, or, where the window system gives
// no Vulkan surface, by painting the picture that was read back.
#pragma once

#include <memory>

#include <QSize>
#include <QWidget>

#include "renderer/renderer.h"

namespace knotspan {

class Presenter {
public:
    Presenter() = default;
    virtual ~Presenter() = default;
    Presenter(const Presenter&) = delete;
    Presenter& operator=(const Presenter&) = delete;

    // What goes into the viewport's layout; lives as long as the presenter.
    [[nodiscard]] virtual QWidget* widget() = 0;
    // The object that gets the mouse, key, resize and expose events of the picture.
    [[nodiscard]] virtual QObject* surface() = 0;
    [[nodiscard]] virtual double pixelRatio() const = 0;
    // The size that a frame for it has, in pixels; empty while nothing can be shown.
    [[nodiscard]] virtual QSize pixelSize() const = 0;
    virtual void setCursor(const QCursor& cursor) = 0;

    [[nodiscard]] virtual Result<void> show() = 0;
};

// The best one that the window system allows. The renderer outlives it.
[[nodiscard]] std::unique_ptr<Presenter> makePresenter(Renderer& renderer);
// The one that always works.
[[nodiscard]] std::unique_ptr<Presenter> makeImagePresenter(Renderer& renderer);

}  // namespace knotspan
