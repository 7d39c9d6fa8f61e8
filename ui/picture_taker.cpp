#include "ui/picture_taker.h"

#include <chrono>

#include <QThreadPool>

#include "ui/model_pictures.h"

namespace knotspan {

PictureTaker::PictureTaker(Document& document, Viewport& viewport, QObject* parent)
    : QObject(parent),
      document_(document),
      viewport_(viewport)
{
    rest_.setSingleShot(true);
    rest_.setInterval(std::chrono::seconds(1));
    connect(&rest_, &QTimer::timeout, this, &PictureTaker::take);
    connect(&document_, &Document::fileChanged, this, [this] {
        if (!document_.source().empty() && !document_.isModified())
            rest_.start();
    });
    connect(&viewport_, &Viewport::frameDrawn, this, [this] {
        if (rest_.isActive())
            rest_.start();
    });
}

// The picture is read back here, once for each state of a file; scaling and writing it wait for no one.
void PictureTaker::take()
{
    if (document_.source().empty() || document_.isModified() || modelPictures::isKept(document_.source()))
        return;
    if (viewport_.isDrawPending() || viewport_.isDragging() || !viewport_.isVisible()) {
        rest_.start();
        return;
    }
    // The page shows models as they are, in one view.
    if (viewport_.paneLayout() != PaneLayout::one || viewport_.frame().shading != Shading::shaded)
        return;
    Renderer* renderer = viewport_.renderer();
    if (renderer == nullptr)
        return;
    const Result<Picture> picture = renderer->capture();
    if (!picture)
        return;
    const QImage image = QImage(picture->rgba.data(), picture->width, picture->height, picture->width * 4,
                                QImage::Format_RGBA8888)
                             .convertToFormat(QImage::Format_RGB32);
    QThreadPool::globalInstance()->start(
        [file = document_.source(), image] { modelPictures::keep(file, image); });
}

}  // namespace knotspan
