#include "ui/viewport/input.h"

#include <glm/geometric.hpp>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "ui/tools/region_select.h"
#include "ui/viewport/navigation_presets.h"
#include "ui/viewport/viewport.h"

namespace knotspan {

namespace {

constexpr double kStillPx = 4;  // a press that moves less is a click
constexpr double kPickRadiusPx = 8;
constexpr double kZoomDragPx = 30;       // one notch of the wheel
constexpr double kWheelNotch = 120;      // Qt's unit: eighths of a degree
constexpr double kTouchpadNotchPx = 60;  // for devices that scroll by pixels

}  // namespace

Input::Input(Viewport& viewport)
    : viewport_(viewport),
      info_(&tools().front()),
      tool_(info_->make()),
      box_(std::make_unique<RegionSelect>(RegionShape::box))
{
}

Input::~Input() = default;

bool Input::handle(QEvent& event)
{
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        return press(static_cast<QMouseEvent&>(event));
    case QEvent::MouseMove:
        return move(static_cast<QMouseEvent&>(event));
    case QEvent::MouseButtonRelease:
        return release(static_cast<QMouseEvent&>(event));
    case QEvent::Wheel:
        return wheel(static_cast<QWheelEvent&>(event));
    case QEvent::Leave:
        leave();
        return false;
    case QEvent::ShortcutOverride:
        return takesFromShortcuts(static_cast<QKeyEvent&>(event));
    case QEvent::KeyPress:
        return modifier(static_cast<QKeyEvent&>(event), true) || key(static_cast<QKeyEvent&>(event));
    case QEvent::KeyRelease:
        return modifier(static_cast<QKeyEvent&>(event), false);
    default:
        return false;
    }
}

ToolPointer Input::pointer(const QMouseEvent& event) const
{
    return {wholePixel(event.position()) - viewport_.pictureCorner(), event.modifiers()};
}

// Of the picture of all views.
Vec2 Input::wholePixel(const QPointF& position) const
{
    return Vec2(position.x(), position.y()) * viewport_.presenter_->pixelRatio();
}

ToolContext Input::context() const
{
    const PictureSize size = viewport_.pictureSize();
    const double ratio = viewport_.presenter_->pixelRatio();
    ToolSettings settings = viewport_.toolSettings_;
    if (viewport_.friends_ != nullptr)
        settings.friends = viewport_.friends_->friends().tolerances();
    return {viewport_.document_,
            viewport_.selection_,
            viewport_.probes_,
            viewport_.frame_.camera,
            size.width,
            size.height,
            ratio,
            gesture_,
            [this, ratio](const Vec2& position) { return viewport_.pick(position, kPickRadiusPx * ratio); },
            settings,
            [this](const QString& sentence) { Q_EMIT viewport_.hint(sentence); },
            [this](const QString& sentence) { Q_EMIT viewport_.failed(sentence); },
            [this] { viewport_.requestDraw(); },
            viewport_.frame_.overlays.controlNets};
}

void Input::setTool(const ToolInfo& tool)
{
    cancel();
    leave();
    info_ = &tool;
    tool_ = tool.make();
    if (viewport_.presenter_)
        showCursor();
}

void Input::show(Overlays& overlays) const
{
    tool_->show(context(), overlays);
    if (boxes_)
        box_->show(context(), overlays);
}

void Input::leave()
{
    resting_.reset();
    viewport_.selection_.setHovered({});
    viewport_.hoverCube({});
    if (viewport_.presenter_)
        tool_->leave(context());
    viewport_.readRamp({});
}

// While the hand drags, plain keys are the tool's: Z means the axis, N no net.
bool Input::takesFromShortcuts(QKeyEvent& event)
{
    const bool plain = (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
    if (drag_ != Drag::tool || !plain)
        return false;
    event.accept();
    return true;
}

// What a click would do may be another thing with it, and lights up.
bool Input::modifier(const QKeyEvent& event, bool isDown)
{
    const Qt::KeyboardModifier modifier = event.key() == Qt::Key_Shift     ? Qt::ShiftModifier
                                          : event.key() == Qt::Key_Control ? Qt::ControlModifier
                                                                           : Qt::NoModifier;
    if (modifier == Qt::NoModifier || !resting_)
        return false;
    resting_->modifiers.setFlag(modifier, isDown);
    hover();
    return false;
}

bool Input::key(const QKeyEvent& event)
{
    if (event.key() == Qt::Key_Escape)
        return cancel();
    if (drag_ != Drag::tool)
        return false;
    const ToolAnswer answer = acting().key(context(), event);
    if (answer == ToolAnswer::pass)
        return false;
    follow(answer);
    showCursor();
    return true;
}

bool Input::press(const QMouseEvent& event)
{
    if (stays_) {
        if (event.button() == Qt::LeftButton)
            follow(tool_->press(context(), pointer(event)));
        showCursor();
        return true;
    }
    if (drag_ != Drag::none)
        return true;  // a second button during a drag
    viewport_.workAt(wholePixel(event.position()));
    const ToolPointer at = pointer(event);
    button_ = event.button();
    pressed_ = last_ = at.position;
    resting_.reset();
    viewport_.readRamp({});
    if (button_ == Qt::LeftButton && viewport_.showsCube() &&
        cubePartAt(at.position, viewport_.cubePicture())) {
        drag_ = Drag::cube;
    } else if (const auto turn = turnBy(viewport_.navigation(), button_, event.modifiers())) {
        drag_ = *turn == ViewTurn::orbit ? Drag::orbit : *turn == ViewTurn::pan ? Drag::pan : Drag::zoom;
    } else if (button_ == Qt::LeftButton) {
        gesture_ = viewport_.document_.newGesture();
        drag_ = Drag::tool;
        follow(tool_->press(context(), at));
    }
    showCursor();
    return drag_ != Drag::none;
}

bool Input::move(const QMouseEvent& event)
{
    const ToolPointer at = pointer(event);
    if (drag_ != Drag::none && !stays_ && !event.buttons().testFlag(button_))
        end(at);  // the button went up where nobody told
    if (drag_ == Drag::none) {
        const auto part =
            viewport_.showsCube() ? cubePartAt(at.position, viewport_.cubePicture()) : std::nullopt;
        if (part || !viewport_.worksAt(wholePixel(event.position()))) {
            if (resting_)
                leave();
            viewport_.hoverCube(part);
            return true;
        }
        viewport_.hoverCube({});
        resting_ = at;
        if (!viewport_.drawPending_)
            hover();
        return true;
    }
    const double still = kStillPx * viewport_.presenter_->pixelRatio();
    if (drag_ == Drag::undecided && glm::length(at.position - pressed_) >= still)
        takeLeftOver(at);
    if (drag_ == Drag::cube && glm::length(at.position - pressed_) >= still)
        drag_ = Drag::orbit;
    if (drag_ == Drag::tool)
        follow(acting().move(context(), at));
    else if (isBusy()) {
        navigate(at.position - last_);
        last_ = at.position;
    }
    return true;
}

// A drag that the tool has passed on.
void Input::takeLeftOver(const ToolPointer& at)
{
    boxes_ = !viewport_.navigation().leftOrbits;
    drag_ = boxes_ ? Drag::tool : Drag::orbit;
    if (boxes_)
        follow(box_->press(context(), {pressed_, at.modifiers}));
    showCursor();
}

bool Input::release(const QMouseEvent& event)
{
    if (drag_ == Drag::none || event.button() != button_)
        return drag_ != Drag::none;
    end(pointer(event));
    return true;
}

void Input::end(const ToolPointer& at)
{
    const Drag ended = drag_;
    if (ended == Drag::tool)
        follow(acting().release(context(), at));
    if (stays_)
        return;
    drag_ = Drag::none;
    boxes_ = false;
    if (ended == Drag::undecided)
        tool_->click(context(), at);
    if (ended == Drag::cube)
        if (const auto part = cubePartAt(at.position, viewport_.cubePicture()))
            viewport_.lookFrom(*part);
    showCursor();
}

void Input::follow(ToolAnswer answer)
{
    stays_ = answer == ToolAnswer::stay || (stays_ && answer == ToolAnswer::keep);
    switch (answer) {
    case ToolAnswer::keep:
    case ToolAnswer::stay:
        return;
    case ToolAnswer::pass:
        drag_ = Drag::undecided;
        return;
    case ToolAnswer::commit:
        viewport_.document_.finishGesture(gesture_);
        break;
    case ToolAnswer::revert:
        acting().cancel();
        viewport_.document_.cancelGesture(gesture_);
        break;
    }
    drag_ = Drag::none;
    boxes_ = false;
    viewport_.requestDraw();  // without what the tool showed meanwhile
}

bool Input::cancel()
{
    if (drag_ == Drag::none)
        return false;
    if (drag_ == Drag::tool) {
        follow(ToolAnswer::revert);
        Q_EMIT viewport_.hint({});
    }
    drag_ = Drag::none;
    if (viewport_.presenter_)
        showCursor();
    return true;
}

void Input::hover()
{
    if (resting_ && drag_ == Drag::none)
        tool_->hover(context(), *resting_);
    viewport_.readRamp(resting_ && drag_ == Drag::none ? std::optional(resting_->position) : std::nullopt);
}

void Input::navigate(const Vec2& way)
{
    const PictureSize size = viewport_.pictureSize();
    const Camera& camera = viewport_.frame_.camera;
    if (drag_ == Drag::orbit)
        viewport_.setCamera(orbited(camera, way, size));
    else if (drag_ == Drag::pan)
        viewport_.setCamera(panned(camera, way, size));
    else if (drag_ == Drag::zoom)
        viewport_.setCamera(zoomed(camera, -way.y / kZoomDragPx, pressed_, size));
}

bool Input::wheel(const QWheelEvent& event)
{
    if (drag_ == Drag::tool)
        return true;  // its way is measured in this view
    const double steps = event.angleDelta().isNull() ? event.pixelDelta().y() / kTouchpadNotchPx
                                                     : event.angleDelta().y() / kWheelNotch;
    if (drag_ == Drag::none)
        viewport_.workAt(wholePixel(event.position()));
    const Vec2 cursor = wholePixel(event.position()) - viewport_.pictureCorner();
    viewport_.setCamera(zoomed(viewport_.frame_.camera, steps, cursor, viewport_.pictureSize()));
    return true;
}

void Input::showCursor()
{
    const Qt::CursorShape shape = drag_ == Drag::pan     ? Qt::ClosedHandCursor
                                  : drag_ == Drag::orbit ? Qt::SizeAllCursor
                                  : drag_ == Drag::zoom  ? Qt::SizeVerCursor
                                                         : acting().cursor();
    viewport_.presenter_->setCursor(shape);
}

}  // namespace knotspan
