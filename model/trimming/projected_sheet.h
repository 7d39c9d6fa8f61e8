// A surface as it falls onto a plane (a picture) along the lines of a projection: forth, and back again.
#pragma once

#include <array>
#include <optional>

#include "model/geometry/evaluation.h"
#include "model/trimming/curve_projection.h"

namespace knotspan {

// Beyond its border the surface goes on straight, across seams as it does. It is not copied.
class ProjectedSheet {
public:
    ProjectedSheet(const NurbsSurface& surface, const PlaneProjection& projection);

    // Of the domain.
    [[nodiscard]] const Vec2& low() const { return low_; }
    [[nodiscard]] Vec2 size() const { return high_ - low_; }
    // In space.
    [[nodiscard]] Vec3 position(const Vec2& at) const;
    // Parameters beyond a seam are brought back into the domain.
    [[nodiscard]] Vec2 acrossSeams(Vec2 at) const;

    struct Picture {
        Vec2 at;
        Vec2 byU;
        Vec2 byV;
        [[nodiscard]] double turn() const { return byU.x * byV.y - byU.y * byV.x; }
        [[nodiscard]] bool isEdgeOn() const;
        // The change of u and v that moves the picture by that.
        [[nodiscard]] Vec2 solve(const Vec2& by) const
        {
            return Vec2(by.x * byV.y - by.y * byV.x, byU.x * by.y - byU.y * by.x) / turn();
        }
    };
    // Nothing where it does not fall onto the plane: behind the eye.
    [[nodiscard]] std::optional<Picture> picture(const Vec2& at) const;

    // The place that falls onto a point of the plane, by Newton's method from `start` on.
    [[nodiscard]] std::optional<Vec2> placeOf(const Vec2& point, const Vec2& start) const;

private:
    [[nodiscard]] SurfacePoint pointAt(Vec2 at) const;

    const NurbsSurface& surface_;
    Mat4 transform_;
    Mat4 toPlane_;
    Vec2 low_;
    Vec2 high_;
    std::array<bool, 2> isClosed_;
};

}  // namespace knotspan
