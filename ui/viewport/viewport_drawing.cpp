// Drawing on demand: whatever changes asks for a picture, and one turn of the event loop makes at most one.
#include <algorithm>

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QTimer>

#include "ui/viewport/input.h"
#include "ui/viewport/ramp_reading.h"
#include "ui/viewport/viewport.h"

namespace knotspan {

namespace {

constexpr int kShowWindowMs = 60;
constexpr int kRestMs = 120;  // a hand that moves less often rests

}  // namespace

void Viewport::requestDraw()
{
    if (drawPending_)
        return;
    drawPending_ = true;
    // Before a long wait the rest of the window gets the time to show itself.
    const bool isPrepared = renderer_ && renderer_->isPrepared(frame_);
    QTimer::singleShot(isPrepared ? 0 : kShowWindowMs, this, [this] {
        if (drawPending_)
            drawNow();
    });
    if (!isPrepared && renderer_)
        Q_EMIT preparing();
}

void Viewport::drawNow()
{
    drawPending_ = false;
    if (!presenter_ || presenter_->pixelSize().isEmpty())
        return;  // showing it asks again
    if (const Result<void> drawn = draw(); !drawn) {
        Q_EMIT failed(QString::fromStdString(drawn.error().sentence()));
        return;
    }
    input_->hover();
}

Result<void> Viewport::draw()
{
    lookAfresh();
    drawPending_ = false;
    if (scenePending_) {
        if (Result<void> synced = renderer_->sync(document_.scene()); !synced)
            return synced;
        scenePending_ = false;
        drawnPanes_.clear();
    }
    Frame frame = sharedFrame();
    const bool isPrepared = renderer_->isPrepared(frame);
    if (!isPrepared) {
        QGuiApplication::setOverrideCursor(Qt::WaitCursor);
        Q_EMIT preparing();
    }
    if (!mayLoosen()) {
        pace_.rest();
        loosened_ = 0;
        sharpened_ = false;
    }
    frame.tolerancePx = std::max(frame.tolerancePx, loosened_);
    frame.smoothEdges = frame.smoothEdges && !sharpened_;
    QElapsedTimer clock;
    clock.start();
    Result<void> others;
    if (panes_.count() > 1) {
        others = drawOthers(frame);
        const PictureSize whole = wholeSize();
        const Vec2 corner = pictureCorner();
        frame.pane = Pane{static_cast<int>(corner.x), static_cast<int>(corner.y), whole.width, whole.height};
    }
    addViewTo(frame, true);
    const Result<FrameStats> stats = renderer_->draw(frame);
    if (!isPrepared)
        QGuiApplication::restoreOverrideCursor();
    if (!others)
        return others;
    if (!stats)
        return tl::unexpected(stats.error());
    if (Result<void> shown = present(); !shown)
        return shown;
    if (isPrepared)
        keepPace(frame, static_cast<double>(clock.nsecsElapsed()) * 1e-6, stats->surfacesTrimmed > 0);
    if (!section_.isComplete())
        requestDraw();
    Q_EMIT frameDrawn(*stats);
    return {};
}

// What all views show.
Frame Viewport::sharedFrame()
{
    Frame frame = frame_;
    const PictureSize size = pictureSize();
    frame.width = size.width;
    frame.height = size.height;
    frame.pixelRatio = presenter_->pixelRatio();
    addSelectionTo(frame.overlays);
    if (friends_ != nullptr)
        frame.overlays.edgeLines = friends_->lines();
    frame.overlays.spaceLines = combs_.lines();
    const std::vector<SharedSpaceLines>& cuts = section_.lines();
    frame.overlays.spaceLines.insert(frame.overlays.spaceLines.end(), cuts.begin(), cuts.end());
    if (frame.shading == Shading::deviation)
        frame.deviations = deviation_.follow();
    else
        deviation_.rest();
    return frame;
}

// From the picture that is there: none is drawn for it.
void Viewport::readRamp(const std::optional<Vec2>& position)
{
    if (position && drawPending_)
        return;  // once it is there
    QString text;
    if (position && renderer_ && showsNumbers(frame_.shading)) {
        Frame frame = frame_;
        if (const DeviationMap* const map = deviation_.map())
            frame.deviations = map->distances;
        const Result<Pick> picked = renderer_->pick(position->x, position->y, 0);
        if (picked && picked->place)
            if (const auto number = rampNumber(document_.scene(), frame, *picked->place))
                text = rampText(frame, *number, document_.scene().units());
    }
    Q_EMIT rampRead(text);
}

// While the hand moves, the picture may be coarser than asked for; once it rests, never. Frozen culling would
// be noted anew for each tolerance.
bool Viewport::mayLoosen() const
{
    return toolSettings_.loosen && input_->isBusy() && !frame_.cullingCamera;
}

void Viewport::keepPace(const Frame& drawn, double ms, bool isTrimmed)
{
    const double asked = frame_.tolerancePx;
    if (mayLoosen()) {
        loosened_ = pace_.afterDrawing({drawn.tolerancePx, ms}, asked);
        sharpened_ = sharpened_ || ms > Pace::kFrameMs;
    }
    if (drawn.tolerancePx > asked || (isTrimmed && drawn.smoothEdges != frame_.smoothEdges))
        settling_.start(kRestMs);
    else
        settling_.stop();
}

void Viewport::settle()
{
    pace_.rest();
    loosened_ = 0;
    sharpened_ = false;
    requestDraw();
}

// Where the window system refuses a surface after all, the read-back picture takes over.
Result<void> Viewport::present()
{
    Result<void> shown = presenter_->show();
    if (shown || qobject_cast<QWidget*>(presenter_->surface()) != nullptr)
        return shown;
    usePresenter(makeImagePresenter(*renderer_));
    requestDraw();
    return {};
}

void Viewport::addSelectionTo(Overlays& overlays) const
{
    overlays.netsOf.clear();
    for (const ObjectId id : selection_.objects())
        if (const SharedObject object = document_.scene().find(id); object && object->visible)
            overlays.netsOf.push_back(id);
    overlays.highlighted = overlays.netsOf;
    overlays.highlighted.insert(overlays.highlighted.end(), selection_.meshes().begin(),
                                selection_.meshes().end());
    overlays.marks.clear();
    const auto& hovered = selection_.hovered();
    for (const auto& [id, chosen] : selection_.points().objects())
        for (const ControlPointIndex index : chosen.points)
            overlays.marks.push_back({id, index});
    if (hovered)
        overlays.marks.push_back({hovered->object, hovered->index, kHoverColour});
    overlays.hovered = selection_.hoveredObject();
}

}  // namespace knotspan
