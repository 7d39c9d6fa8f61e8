// What is under a pixel of the last frame.
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "renderer/renderer_parts.h"

namespace knotspan {

Pick Renderer::Parts::pick(double x, double y, double radiusPx)
{
    Pick result;
    if (!lastFrame)
        return result;
    if (lastFrame->overlays.points)
        pickControlPoint({x, y}, radiusPx, result);
    if (x >= 0 && y >= 0 && x < targets->extent().width && y < targets->extent().height)
        result.place = pickedPlace({x, y});
    return result;
}

std::optional<PickedPlace> Renderer::Parts::pickedPlace(const Vec2& pixel) const
{
    const auto x = static_cast<std::uint32_t>(pixel.x);
    const auto y = static_cast<std::uint32_t>(pixel.y);
    const FrameTargets::Pixel at = targets->pixelAt(x, y);
    if (at.ksquad == 0)
        return std::nullopt;
    const KsQuadName name = ksquadName(lastResidents, at.ksquad - 1);
    // Back through what the frame's stages multiplied with.
    const Frame& frame = *lastFrame;
    const Vec4 clip(2.0 * (x + 0.5) / frame.width - 1.0, 2.0 * (y + 0.5) / frame.height - 1.0, at.depth, 1.0);
    const Vec4 view = glm::inverse(Mat4(frameRecord_->projection)) * clip;
    const Vec3 fromEye = glm::transpose(frame.camera.rotation()) * Vec4(Vec3(view) / view.w, 0.0);
    return PickedPlace{name.object, name.ksquad.spanU, name.ksquad.spanV, frame.camera.eye + fromEye};
}

void Renderer::Parts::pickControlPoint(const Vec2& pixel, double radiusPx, Pick& to) const
{
    const Frame& frame = *lastFrame;
    double nearestDepth = 0;
    const PixelProjection toPixel(frame.camera, frame.width, frame.height);
    const Vec3 forward = frame.camera.forward();
    const auto look = [&](const Resident& resident, ControlPointIndex index) {
        const Vec3 point = controlPointInModel(*resident.object, index);
        const auto at = toPixel(point);
        const double distance = at ? glm::length(*at - pixel) : std::numeric_limits<double>::infinity();
        if (!(distance <= radiusPx))
            return;
        const double depth = glm::dot(point - frame.camera.eye, forward);
        // Among points that fall on the same pixel, the one in front.
        const bool same = to.controlPoint && std::abs(distance - to.distancePx) < 0.5;
        if (to.controlPoint && (same ? depth >= nearestDepth : distance >= to.distancePx))
            return;
        to.controlPoint = PickedControlPoint{resident.id, index};
        to.distancePx = distance;
        nearestDepth = depth;
    };
    for (const Resident* resident : shownNets(frame.overlays)) {
        const NurbsSurface& net = resident->object->surface;
        for (int i = 0; i < net.countU(); ++i)
            for (int j = 0; j < net.countV(); ++j)
                look(*resident, {i, j});
    }
}

}  // namespace knotspan
