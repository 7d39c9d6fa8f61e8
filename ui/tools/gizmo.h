// The gizmo: handles of one size on the picture, around a place of the model, by which a hand moves, turns
// and scales. Pure geometry: what they look like, and which of them is under a pixel.
#pragma once

#include <vector>

#include "model/sculpting/point_drag.h"
#include "renderer/frame.h"
#include "ui/tools/picture_moves.h"

namespace knotspan {

// Sizes, in the hand's pixels.
constexpr double kArrowPx = 80;
constexpr double kRingPx = 64;
constexpr double kScaleBarPx = 96;  // its middle, from the centre
constexpr double kHandleReachPx = 7;

enum class HandleKind {
    move,         // an arrow
    turn,         // the half of a ring that faces the eye
    scale,        // a bar beyond the arrow's head
    scaleEvenly,  // the centre
};

struct GizmoHandle {
    HandleKind kind = HandleKind::move;
    DragAxis axis = DragAxis::free;  // of scaleEvenly
    Vec3 direction{0};               // unit, in model space; of scaleEvenly zero

    [[nodiscard]] bool operator==(const GizmoHandle&) const = default;
};

class Gizmo {
public:
    // Arrows and bars that point at the eye are left out; so is all where the centre is behind it.
    Gizmo(const PictureView& view, const Vec3& centre, const std::vector<GizmoHandle>& handles);

    struct Hit {
        size_t handle = 0;
        double distancePx = 0;  // of the picture, from the middle of its line
    };
    // The nearest within the hand's reach.
    [[nodiscard]] std::optional<Hit> under(const Vec2& pixel) const;

    // All, one perhaps lit.
    [[nodiscard]] std::vector<Stroke> strokes(std::optional<size_t> lit) const;
    // What one handle is drawn with; empty: it is left out.
    [[nodiscard]] const std::vector<Stroke>& shape(size_t handle) const { return shapes_[handle]; }

private:
    [[nodiscard]] std::vector<Stroke> arrow(const Vec2& along, int ticks) const;
    [[nodiscard]] std::vector<Stroke> ring(const RingSeen& seen) const;
    [[nodiscard]] Stroke line(const Vec2& from, const Vec2& to, double width) const;

    Vec2 centre_{0};
    double ratio_ = 1;
    std::vector<std::vector<Stroke>> shapes_;
};

}  // namespace knotspan
