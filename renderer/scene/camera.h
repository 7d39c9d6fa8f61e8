// The eye of a picture. Everything is double and in model space; the GPU gets matrices relative to the eye.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/core/space.h"

namespace knotspan {

struct Camera {
    Vec3 eye{0, 0, 10};
    Vec3 target{0, 0, 0};  // another point than the eye
    Vec3 up{0, 1, 0};      // any direction that is not along the view
    bool orthographic = false;
    double verticalFovDegrees =
        35;  // orthographic: the height of the view is that of this angle at the target

    [[nodiscard]] bool operator==(const Camera&) const = default;

    [[nodiscard]] Vec3 forward() const;  // unit, from the eye to the target
    [[nodiscard]] Vec3 right() const;    // unit
    [[nodiscard]] Vec3 upward() const;   // unit, orthogonal to both
    [[nodiscard]] double distance() const;

    // The height in model units of one pixel at the depth of `point`, for a picture of `pictureHeight`
    // pixels.
    [[nodiscard]] double unitsPerPixel(const Vec3& point, int pictureHeight) const;

    // Rotation to view space (x right, y up, looking along -z); the eye is subtracted separately, in double.
    [[nodiscard]] Mat4 rotation() const;

    // From coordinates relative to `origin`, of an object placed by `transform`, to eye-relative view space;
    // in double, because both may be far from where the model counts from.
    [[nodiscard]] Mat4 viewFrom(const Mat4& transform, const Vec3& origin) const;

    // From eye-relative view space to Vulkan clip space, depth reversed (1 near, 0 far). `bounds` sets the
    // depth range.
    [[nodiscard]] Mat4 projection(double aspect, const Box& bounds) const;

    // Where that projection's near plane cuts off what it shows. With perspective: no point further from the
    // eye. Orthographic: no point with dot(point, forward()) at least this.
    [[nodiscard]] double cutOff(double aspect, const Box& bounds) const;

    // Where a point of model space falls, in pixels from the upper left corner of the picture; nothing where
    // it is not in front of the eye.
    [[nodiscard]] std::optional<Vec2> toPixel(const Vec3& point, int width, int height) const;

    // Camera motion, as the viewport and scripts need it.
    void orbit(double yawRadians, double pitchRadians);  // around the target; up stays z
    void pan(double rightUnits, double upUnits);
    void zoomAt(double factor,
                const Vec2& cursorFromCentre);  // factor < 1 comes closer; cursor in units at the target
};

// Where points of model space fall, in pixels from the upper left corner of the picture.
class PixelProjection {
public:
    PixelProjection(const Camera& camera, int width, int height);

    // Nothing where the point is not in front of the eye.
    [[nodiscard]] std::optional<Vec2> operator()(const Vec3& point) const;

private:
    Mat4 rotation_;
    Vec3 eye_;
    Vec2 middle_;
    double nearest_;
    double scale_;                 // pixels per unit at depth 1
    std::optional<double> depth_;  // orthographic: the depth that counts for all points
};

// The named views, in the order of the list: "iso", "front", "back", "left", "right", "top", "bottom".
[[nodiscard]] const std::vector<std::string>& namedViews();

// Looks at all `points` from a named direction; nothing for an unknown name. z is up, front looks along +y.
[[nodiscard]] std::optional<Camera> namedView(std::string_view name, const std::vector<Vec3>& points,
                                              double aspect, bool orthographic,
                                              double verticalFovDegrees = 35);

// The same direction, moved so that the points (a scene's control points: the surfaces lie inside their hull)
// fill the picture. Without points, as for a box of two units around the origin.
[[nodiscard]] Camera fitted(Camera camera, const std::vector<Vec3>& points, double aspect);

}  // namespace knotspan
