// Selects objects and control points by clicking, and moves the selected control points with the hand: in the
// plane that faces the eye, through the point under the hand, or along the axis that the settings ask for;
// points that fall off or mirror follow (model/sculpting/point_drag.h). With Shift held the hand counts a
// tenth. With ToolSettings::keepFriends the control points of friends follow; where they cannot, nothing
// moves and the reason is said.
#pragma once

#include "model/matching/drag_with_friends.h"
#include "ui/tools/tool.h"

namespace knotspan {

class MoveControlPoint : public Tool {
public:
    void hover(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer press(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer move(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer release(const ToolContext& context, const ToolPointer& pointer) override;
    void click(const ToolContext& context, const ToolPointer& pointer) override;
    void cancel() override;

private:
    struct Drag {
        ScenePoint point;    // under the hand
        bool alone = false;  // a press that goes nowhere leaves it selected alone
        Vec2 pressed;        // where the hand took hold
        Vec2 last;           // where it was
        Vec2 way{0};         // how far it went, in pixels that count
        Vec3 start;          // where the control point was
        bool moved = false;
        std::optional<PointDrag> points;         // from the first move on
        std::optional<DragWithFriends> friends;  // likewise, where they are kept
        QString step;
        bool applied = false;
        QString refusal;  // of the last place; empty where the points went there
    };
    [[nodiscard]] Result<void> begin(const ToolContext& context);
    [[nodiscard]] Result<Edit> editTo(const ToolContext& context);
    std::optional<Drag> drag_;
};

}  // namespace knotspan
