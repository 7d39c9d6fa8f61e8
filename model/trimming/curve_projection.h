// A closed curve of a plane (a drawn one: of the picture) brought onto a surface along the lines of a
// projection, as curves in its (u,v).
#pragma once

#include <functional>
#include <optional>

#include "model/geometry/nurbs_surface.h"
#include "model/geometry/trim_loop.h"

namespace knotspan {

// A smooth piece over t of 0 to 1: the place, and its change by t.
struct PlanePiece {
    std::function<Vec2(double)> at;
    std::function<Vec2(double)> change;
    std::vector<double> breaks;  // of t, increasing, where it is not as smooth; ends not among them
};
// In order, the last one ends where the first begins.
using PlaneCurve = std::vector<PlanePiece>;

// Straight from corner to corner and back to the first.
[[nodiscard]] PlaneCurve closedPolygon(const std::vector<Vec2>& corners);
// Through the points, at least three and no two that follow each other the same, as a closed cubic spline of
// steady curvature.
[[nodiscard]] PlaneCurve closedSpline(const std::vector<Vec2>& points);

struct ProjectedCurve {
    std::vector<TrimCurve> curves;  // cubic, one for each piece
    double error = 0;               // the largest distance found, in space, from the exact projection
};

struct PlaneProjection {
    Mat4 toPlane{1.0};    // of points in space to x/w and y/w in the plane, where w is above zero
    Mat4 transform{1.0};  // of the surface's points to those in space
};

// The place (u, v) of the surface that falls onto a point of the plane, searched from `start` on; nothing
// where none is found.
[[nodiscard]] std::optional<Vec2> projectedPlace(const NurbsSurface& surface,
                                                 const PlaneProjection& projection, const Vec2& point,
                                                 const Vec2& start);

// Follows the sheet of the surface that `start` (u, v) is on; it falls near where the curve begins. Pieces of
// a cubic are halved until none is further off than `tolerance` at nine places. The curve may leave the
// surface: beyond its border that is taken as going on straight, and on closed ones as across the seam.
// Fails, with a sentence, where it comes to where the surface is seen edge-on.
[[nodiscard]] Result<ProjectedCurve> projectedOnto(const NurbsSurface& surface,
                                                   const PlaneProjection& projection, const PlaneCurve& curve,
                                                   const Vec2& start, double tolerance);

}  // namespace knotspan
