// The hand and the keys of one drag, whatever is dragged: how far the hand went, what was typed, which
// sentence stands beside the picture.
//
// With Shift held the hand counts a tenth. X, Y, Z, U, V and N choose an axis, the same again none. While
// numbers are typed the hand does not count; Enter takes them. What cannot be is refused with a sentence, and
// the last thing that could be stays.
#pragma once

#include <memory>

#include "ui/tools/dragging.h"

namespace knotspan {

class DragGesture {
public:
    DragGesture(std::unique_ptr<Dragging> dragging, const Vec2& pressed);

    void move(const ToolContext& context, const ToolPointer& pointer);
    [[nodiscard]] ToolAnswer key(const ToolContext& context, const QKeyEvent& event);
    [[nodiscard]] ToolAnswer release(const ToolContext& context);

    // Whether it is more than a click by now.
    [[nodiscard]] bool hasBegun() const { return hasMoved_; }
    [[nodiscard]] const Dragging& dragging() const { return *dragging_; }
    // How far the gizmo goes along, by what was applied.
    [[nodiscard]] const Vec3& gizmoMoved() const { return gizmoMoved_; }

private:
    void follow(const ToolContext& context);
    [[nodiscard]] Result<Edit> wanted(const ToolContext& context);
    void refuse(const ToolContext& context, const Error& error);
    void accept(const ToolContext& context);
    void choose(const ToolContext& context, DragAxis axis);
    [[nodiscard]] ToolAnswer take(const ToolContext& context);

    std::unique_ptr<Dragging> dragging_;
    Vec2 pressed_;
    Vec2 last_;
    Vec2 way_{0};
    TypedNumbers typed_;
    bool hasMoved_ = false;
    bool isReady_ = false;    // begin() went well
    bool isApplied_ = false;  // something, at some time
    Vec3 gizmoMoved_{0};
    QString refusal_;  // of the last answer; empty where it was applied
    bool isHinting_ = false;
};

}  // namespace knotspan
