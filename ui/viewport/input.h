// The pointer and the keys over the picture: the same code for both presenters. Turns the view itself, and
// leaves the left button to the current tool first.
#pragma once

#include <QPointF>

#include "ui/tools/tool_list.h"

class QEvent;
class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace knotspan {

class Viewport;

class Input {
public:
    explicit Input(Viewport& viewport);
    ~Input();
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;

    // True where the event is used up.
    bool handle(QEvent& event);

    // Takes a running drag of a tool back, or stops the view's; false where neither ran.
    bool cancel();

    // Tells the tool where the pointer rests, once the picture it rests on is drawn.
    void hover();

    // One of tools(); what the one before was doing is taken back.
    void setTool(const ToolInfo& tool);
    [[nodiscard]] const ToolInfo& tool() const { return *info_; }
    // What the picture is to show of the tool.
    void show(Overlays& overlays) const;
    // Whether the hand is moving something: the model or the view.
    [[nodiscard]] bool isBusy() const { return drag_ > Drag::cube; }
    // Whether a tool is in the middle of a gesture.
    [[nodiscard]] bool isDragging() const { return drag_ == Drag::tool; }

private:
    // Up to `cube` nothing moves yet: what was pressed may still become a click.
    enum class Drag { none, undecided, cube, orbit, pan, zoom, tool };

    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    bool wheel(const QWheelEvent& event);
    bool takesFromShortcuts(QKeyEvent& event);
    bool key(const QKeyEvent& event);
    bool modifier(const QKeyEvent& event, bool isDown);
    [[nodiscard]] Tool& acting() const { return boxes_ ? *box_ : *tool_; }
    void takeLeftOver(const ToolPointer& at);
    void end(const ToolPointer& at);
    [[nodiscard]] Vec2 wholePixel(const QPointF& position) const;
    void leave();
    void navigate(const Vec2& way);
    void showCursor();
    [[nodiscard]] ToolContext context() const;
    [[nodiscard]] ToolPointer pointer(const QMouseEvent& event) const;
    void follow(ToolAnswer answer);

    Viewport& viewport_;
    const ToolInfo* info_;
    std::unique_ptr<Tool> tool_;
    std::unique_ptr<Tool> box_;  // for drags that nobody else takes, where they do not orbit
    bool boxes_ = false;         // the drag is its
    bool stays_ = false;         // the tool's drag goes on with the button up
    Drag drag_ = Drag::none;
    Qt::MouseButton button_ = Qt::NoButton;
    int gesture_ = 0;
    Vec2 pressed_{};
    Vec2 last_{};
    std::optional<ToolPointer> resting_;
};

}  // namespace knotspan
