// What a hand drags: it turns the hand's way, or typed numbers, into an edit of the scene as it stood when
// the drag began.
#pragma once

#include "model/scene/edit.h"
#include "ui/tools/picture_moves.h"
#include "ui/tools/tool.h"
#include "ui/tools/typed_numbers.h"

namespace knotspan {

class Dragging {
public:
    Dragging() = default;
    virtual ~Dragging() = default;
    Dragging(const Dragging&) = delete;
    Dragging& operator=(const Dragging&) = delete;

    // Called before all edits, once; again only after it failed.
    [[nodiscard]] virtual Result<void> begin(const ToolContext& context) = 0;
    // Another axis, before begin() or after; where it fails the old one stays.
    [[nodiscard]] virtual Result<void> choose(DragAxis axis) = 0;
    [[nodiscard]] virtual DragAxis axis() const = 0;

    // `way` is the hand's, in pixels, those that count.
    [[nodiscard]] virtual Result<Edit> byHand(const ToolContext& context, const Vec2& way) = 0;
    [[nodiscard]] virtual Result<Edit> byNumbers(const ToolContext& context, const DragNumbers& numbers) = 0;

    [[nodiscard]] virtual QString step() const = 0;                    // the undo step's name
    [[nodiscard]] virtual QString manner() const = 0;                  // "Along Z"
    [[nodiscard]] virtual QString unit(const Scene& scene) const = 0;  // " mm"; with its space, or empty

    // How far its gizmo went along, by the last edit.
    [[nodiscard]] virtual Vec3 gizmoMoved() const = 0;
    virtual void show(const ToolContext& context, Overlays& overlays) const = 0;
};

[[nodiscard]] inline PictureView viewOf(const ToolContext& context)
{
    return {context.camera, context.width, context.height, context.pixelRatio};
}

// "X", "Y", "Z", "U", "V", "N"; nothing for `free`.
[[nodiscard]] inline QString letterOf(DragAxis axis)
{
    constexpr const char* kLetters[] = {"", "X", "Y", "Z", "U", "V", "N"};
    return QString::fromLatin1(kLetters[static_cast<int>(axis)]);
}

}  // namespace knotspan
