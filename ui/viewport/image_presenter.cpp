// Reads each frame back and paints it.
#include <QImage>
#include <QPaintEvent>
#include <QPainter>
#include <QPointer>

#include "ui/viewport/presenter.h"

namespace knotspan {

namespace {

class ImageWidget : public QWidget {
public:
    ImageWidget()
    {
        setAttribute(Qt::WA_OpaquePaintEvent);
        setMouseTracking(true);
        setFocusPolicy(Qt::StrongFocus);
    }

    void setImage(QImage image)
    {
        image_ = std::move(image);
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        if (image_.isNull())
            painter.fillRect(rect(), palette().window());
        else
            painter.drawImage(rect(), image_);
    }

private:
    QImage image_;
};

class ImagePresenter : public Presenter {
public:
    explicit ImagePresenter(Renderer& renderer) : renderer_(renderer), widget_(new ImageWidget) {}
    ~ImagePresenter() override { delete widget_; }

    QWidget* widget() override { return widget_; }
    QObject* surface() override { return widget_; }
    double pixelRatio() const override { return widget_->devicePixelRatioF(); }
    QSize pixelSize() const override
    {
        return widget_->isVisible() ? (QSizeF(widget_->size()) * pixelRatio()).toSize() : QSize();
    }
    void setCursor(const QCursor& cursor) override { widget_->setCursor(cursor); }

    Result<void> show() override
    {
        const Result<Picture> picture = renderer_.capture();
        if (!picture)
            return tl::unexpected(picture.error());
        const QImage image(picture->rgba.data(), picture->width, picture->height, picture->width * 4,
                           QImage::Format_RGBA8888);
        widget_->setImage(image.convertToFormat(QImage::Format_RGB32));
        return {};
    }

private:
    Renderer& renderer_;
    QPointer<ImageWidget> widget_;
};

}  // namespace

std::unique_ptr<Presenter> makeImagePresenter(Renderer& renderer)
{
    return std::make_unique<ImagePresenter>(renderer);
}

}  // namespace knotspan
