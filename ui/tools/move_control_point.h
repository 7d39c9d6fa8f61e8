// Selects objects by clicking, and moves a control point with the hand: in the plane that faces the eye,
// through the point itself, so that it stays under the cursor. With ToolSettings::keepFriends the control
// points of friends follow; where they cannot, nothing moves and the reason is said.
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
        PickedControlPoint point;
        Vec2 pressed;  // where the hand took hold
        Vec3 start;    // where the control point was
        bool moved = false;
        bool keepsFriends = false;
        std::optional<DragWithFriends> friends;  // from the first move on, where they are kept
        bool applied = false;
        QString refusal;  // of the last place; empty where the point went there
    };
    [[nodiscard]] Result<Edit> editTo(const ToolContext& context, const SceneObject& object,
                                      const Vec3& position);
    std::optional<Drag> drag_;
};

}  // namespace knotspan
