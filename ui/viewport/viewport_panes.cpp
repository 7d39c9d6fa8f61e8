// The viewport's views: which one the hand works in, and what belongs to each picture by itself.
#include <algorithm>

#include "renderer/scene/framed_points.h"
#include "ui/viewport/input.h"
#include "ui/viewport/probe_lines.h"
#include "ui/viewport/stroke_text.h"
#include "ui/viewport/viewport.h"

namespace knotspan {

void Viewport::setPaneLayout(PaneLayout layout)
{
    if (layout == panes_.layout())
        return;
    cancelDrag();
    const double before = pictureSize().aspect();
    panes_.setLayout(layout, frame_.camera);
    frame_.camera.zoomAt(before / pictureSize().aspect(), Vec2(0));  // as much from left to right as before
    drawnPanes_.clear();
    Q_EMIT frameChanged();
    requestDraw();
}

void Viewport::showCube(bool on)
{
    showsCube_ = on;
    hoveredPart_.reset();
    Q_EMIT frameChanged();
    requestDraw();
}

PictureSize Viewport::wholeSize() const
{
    const QSize size = presenter_ ? presenter_->pixelSize() : QSize();
    if (size.isEmpty())
        return {std::max(width(), 1), std::max(height(), 1)};
    return {size.width(), size.height()};
}

PictureSize Viewport::pictureSize() const
{
    const PictureSize whole = wholeSize();
    const PaneRect rect = panes_.rects(whole.width, whole.height)[panes_.current()];
    return {rect.width, rect.height};
}

Vec2 Viewport::pictureCorner() const
{
    const PictureSize whole = wholeSize();
    const PaneRect rect = panes_.rects(whole.width, whole.height)[panes_.current()];
    return {rect.x, rect.y};
}

bool Viewport::worksAt(const Vec2& pixel) const
{
    const PictureSize whole = wholeSize();
    return panes_.at(pixel, whole.width, whole.height) == panes_.current();
}

void Viewport::workAt(const Vec2& pixel)
{
    const PictureSize whole = wholeSize();
    const auto pane = panes_.at(pixel, whole.width, whole.height);
    if (!pane || *pane == panes_.current() || panes_.isFresh(*pane))
        return;
    hoveredPart_.reset();
    setCamera(panes_.makeCurrent(*pane, frame_.camera));
}

CubePicture Viewport::cubePicture() const
{
    const PictureSize size = pictureSize();
    return {frame_.camera, size.width, size.height, presenter_->pixelRatio()};
}

void Viewport::hoverCube(const std::optional<CubePart>& part)
{
    if (part == hoveredPart_)
        return;
    hoveredPart_ = part;
    requestDraw();
}

// Views that nobody turned yet look at the whole model.
void Viewport::lookAfresh()
{
    const auto start = panes_.startView(panes_.current());
    if (viewPending_) {
        if (panes_.count() > 1)
            frame_.camera.orthographic = start.orthographic;
        look(start.name);
    }
    const PictureSize size = pictureSize();
    for (size_t pane = 0; pane < panes_.count(); ++pane) {
        if (pane == panes_.current() || !panes_.isFresh(pane))
            continue;
        const auto view = panes_.startView(pane);
        if (const auto camera = namedView(view.name, framedPoints(document_.scene()), size.aspect(),
                                          view.orthographic, frame_.camera.verticalFovDegrees))
            panes_.setCamera(pane, *camera);
    }
}

// Of the others only those are drawn whose picture is another than the one that stands there.
Result<void> Viewport::drawOthers(const Frame& shared)
{
    drawnPanes_.resize(panes_.count());
    const PictureSize whole = wholeSize();
    const std::vector<PaneRect> rects = panes_.rects(whole.width, whole.height);
    for (size_t pane = 0; pane < panes_.count(); ++pane) {
        if (pane == panes_.current())
            continue;
        Frame frame = shared;
        frame.camera = panes_.camera(pane);
        frame.pane = Pane{rects[pane].x, rects[pane].y, whole.width, whole.height};
        addViewTo(frame, false);
        if (drawnPanes_[pane] == frame)
            continue;
        if (const auto drawn = renderer_->draw(frame); !drawn)
            return tl::unexpected(drawn.error());
        drawnPanes_[pane] = frame;
    }
    drawnPanes_[panes_.current()].reset();
    return {};
}

void Viewport::addViewTo(Frame& frame, bool isCurrent) const
{
    constexpr float kBorderPx = 2;
    const double ratio = presenter_->pixelRatio();
    Overlays& overlays = frame.overlays;
    if (isCurrent)
        input_->show(overlays);
    const auto lines =
        probeLines(document_.scene(), probes_, {frame.camera, frame.width, frame.height, ratio});
    overlays.strokes.insert(overlays.strokes.end(), lines.begin(), lines.end());
    if (showsCube_)
        addViewCube(overlays, {frame.camera, frame.width, frame.height, ratio},
                    isCurrent ? hoveredPart_ : std::nullopt);
    if (panes_.count() == 1)
        return;
    addStrokeText(overlays.strokes, viewTitle(frame.camera), {.corner = Vec2(10, 10) * ratio},
                  {.height = 10 * ratio, .width = 1.4 * ratio});
    if (!isCurrent)
        return;
    const Vec2 far(frame.width, frame.height);
    const float width = 2 * kBorderPx * static_cast<float>(ratio);  // half of it is outside
    const Vec2 corners[4] = {{0, 0}, {far.x, 0}, far, {0, far.y}};
    for (size_t k = 0; k < 4; ++k)
        overlays.strokes.push_back({corners[k], corners[(k + 1) % 4], kSelectedColour, width, width, 1});
}

}  // namespace knotspan
