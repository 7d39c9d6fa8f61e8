#include "ui/tools/gizmo.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace knotspan {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kShortestPx = 14;  // an arrow that is seen shorter points at the eye
constexpr double kStartPx = 14;     // arrows leave the centre free
constexpr double kLinePx = 3;
constexpr double kHeadPx = 18;
constexpr double kTickPx = 5;
constexpr double kBarPx = 9;

struct AxisLook {
    std::uint32_t colour;
    int ticks;  // across the arrow, for eyes that see no colours
};

AxisLook lookOf(DragAxis axis)
{
    switch (axis) {
    case DragAxis::x:
        return {0xe5484d, 0};
    case DragAxis::y:
        return {0x46a758, 1};
    case DragAxis::z:
        return {0x3e8eff, 2};
    case DragAxis::u:
        return {0x2cc4d8, 0};
    case DragAxis::v:
        return {0xd864c8, 1};
    case DragAxis::normal:
        return {0xf2d13c, 2};
    case DragAxis::free:
        break;
    }
    return {0xd8dce4, 0};
}

double distanceTo(const Stroke& stroke, const Vec2& pixel)
{
    const Vec2 along = stroke.to - stroke.from;
    const double square = glm::dot(along, along);
    const double t = square > 0 ? glm::clamp(glm::dot(pixel - stroke.from, along) / square, 0.0, 1.0) : 0.0;
    return glm::distance(pixel, stroke.from + t * along);
}

}  // namespace

Gizmo::Gizmo(const PictureView& view, const Vec3& centre, const std::vector<GizmoHandle>& handles)
    : ratio_(view.pixelRatio),
      shapes_(handles.size())
{
    const PixelProjection projection(view.camera, view.width, view.height);
    const auto middle = projection(centre);
    if (!middle)
        return;
    centre_ = *middle;
    const double length = kArrowPx * ratio_ * view.camera.unitsPerPixel(centre, view.height);
    for (size_t k = 0; k < handles.size(); ++k) {
        const GizmoHandle& handle = handles[k];
        const AxisLook look = lookOf(handle.axis);
        std::vector<Stroke>& shape = shapes_[k];
        const auto tip = projection(centre + length * handle.direction);
        const Vec2 along = tip.value_or(centre_) - centre_;
        const bool shows = glm::length(along) >= kShortestPx * ratio_;
        if (handle.kind == HandleKind::move && shows)
            shape = arrow(along, look.ticks);
        else if (handle.kind == HandleKind::turn)
            shape = ring(RingSeen(view.camera, handle.direction));
        else if (handle.kind == HandleKind::scale && shows)
            shape = {line((kScaleBarPx - kBarPx / 2) / kArrowPx * along,
                          (kScaleBarPx + kBarPx / 2) / kArrowPx * along, kBarPx)};
        else if (handle.kind == HandleKind::scaleEvenly)
            shape = {line(Vec2(-kBarPx / 2, 0) * ratio_, Vec2(kBarPx / 2, 0) * ratio_, kBarPx)};
        for (Stroke& stroke : shape)
            stroke.colour = look.colour;
    }
}

// From the centre.
Stroke Gizmo::line(const Vec2& from, const Vec2& to, double width) const
{
    const auto pixels = static_cast<float>(width * ratio_);
    return {centre_ + from, centre_ + to, kHoverColour, pixels, pixels, 1};
}

std::vector<Stroke> Gizmo::arrow(const Vec2& along, int ticks) const
{
    const double head = 1 - kHeadPx / kArrowPx;
    std::vector<Stroke> strokes = {line(kStartPx / kArrowPx * along, head * along, kLinePx),
                                   line(head * along, along, 0.65 * kHeadPx)};
    strokes.back().widthToPx = 0;
    const Vec2 across = Vec2(-along.y, along.x) / glm::length(along) * kTickPx * ratio_;
    for (int k = 0; k < ticks; ++k) {
        const Vec2 at = (0.45 + 0.1 * k) * along;
        strokes.push_back(line(at - across, at + across, 2));
    }
    return strokes;
}

std::vector<Stroke> Gizmo::ring(const RingSeen& seen) const
{
    constexpr int kParts = 64;
    constexpr double kBehind = 0.05;  // a ring that faces the eye has no half behind
    const double radius = kRingPx * ratio_;
    std::vector<Stroke> strokes;
    for (int k = 0; k < kParts; ++k) {
        const double from = 2 * kPi * k / kParts;
        const double to = 2 * kPi * (k + 1) / kParts;
        if (seen.depthAt(from) <= kBehind && seen.depthAt(to) <= kBehind)
            strokes.push_back(line(radius * seen.at(from), radius * seen.at(to), 2));
    }
    return strokes;
}

std::optional<Gizmo::Hit> Gizmo::under(const Vec2& pixel) const
{
    std::optional<Hit> nearest;
    for (size_t k = 0; k < shapes_.size(); ++k)
        for (const Stroke& stroke : shapes_[k]) {
            const double distance = distanceTo(stroke, pixel);
            if (distance <= kHandleReachPx * ratio_ && (!nearest || distance < nearest->distancePx))
                nearest = Hit{k, distance};
        }
    return nearest;
}

std::vector<Stroke> Gizmo::strokes(std::optional<size_t> lit) const
{
    std::vector<Stroke> all;
    for (size_t k = 0; k < shapes_.size(); ++k)
        for (Stroke stroke : shapes_[k]) {
            if (lit == k)
                stroke.colour = kHoverColour;
            all.push_back(stroke);
        }
    return all;
}

}  // namespace knotspan
