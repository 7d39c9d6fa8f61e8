// Sculpts the surface under the pointer with a round brush (model/sculpting/brushes.h): of the selected
// objects, or of all where none is selected. Shift smooths whatever the brush; Ctrl turns inflate around.
// The live symmetry plane counts.
#pragma once

#include "model/matching/drag_with_friends.h"
#include "model/sculpting/brushes.h"
#include "ui/tools/tool.h"

namespace knotspan {

class Brush : public Tool {
public:
    explicit Brush(BrushKind kind) : kind_(kind) {}

    void hover(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer press(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer move(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer release(const ToolContext& context, const ToolPointer& pointer) override;
    void click(const ToolContext&, const ToolPointer&) override {}
    void cancel() override { stroke_.reset(); }
    void leave(const ToolContext& context) override;
    void show(const ToolContext& context, Overlays& overlays) const override;
    [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

private:
    // From a press to its release.
    struct BrushStroke {
        BrushKind kind{};
        double sign = 1;
        Scene start;
        std::set<ObjectId> objects;  // that it may change
        Vec3 centre{0};              // where it took hold
        double radius = 0;           // in model units
        Vec2 pressed{0};
        Vec2 last{0};                            // of the last dab
        std::optional<DragWithFriends> friends;  // of grab, where they are kept
        bool hasMoved = false;                   // further than a hand trembles
        bool hasChanged = false;                 // something
        QString refusal;
    };
    [[nodiscard]] Result<Edit> grabbed(const ToolContext& context, const Vec2& to);
    [[nodiscard]] Result<Edit> dabbedAt(const ToolContext& context, const Vec3& centre) const;
    void apply(const ToolContext& context, const Result<Edit>& edit);

    BrushKind kind_;
    std::optional<BrushStroke> stroke_;
    std::optional<Vec2> over_;  // where the pointer is, for the circle
};

}  // namespace knotspan
