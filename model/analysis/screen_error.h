// How far, in pixels, the triangles of a grid over a KSQuad can be from the surface, before any is drawn: the
// bound in closed form, the reference of what shaders compute.
//
// A net here is a KSQuad's Bézier net in homogeneous pixels (ScreenView::toPixels). A triangle drawn with
// perspective-correct interpolation is the homogeneous linear interpolant of its vertices, so the distance at
// (u, v) between the drawn point s_L and the surface's s is |E.xy - s_L E.w| / w with E the error of that
// interpolant, and second derivatives bound E.
#pragma once

#include <optional>

#include "model/geometry/bezier_conversion.h"

namespace knotspan {

// A picture: x and y of toPixels * point are pixels times w, z and w those of clip space. A point shows where
// z <= w (w > 0 follows: z is not negative in front of the near plane) and x / w, y / w lie in the picture.
struct ScreenView {
    Mat4 toPixels{1.0};
    Vec2 low{0, 0};
    Vec2 high{0, 0};
};

// From a matrix to Vulkan's clip space, depth reversed, as Camera::projection makes it. Where the net is
// relative to an origin, so is the matrix.
[[nodiscard]] ScreenView screenView(const Mat4& toClip, double widthPixels, double heightPixels);

// n cells along u times n along v, each two triangles.
struct Grid {
    int u = 1;
    int v = 1;

    [[nodiscard]] long cells() const { return static_cast<long>(u) * v; }
    [[nodiscard]] bool operator==(const Grid&) const = default;
};

constexpr int kLargestFactor = 4096;  // cells along one side that are ever asked for

// Upper bounds, in pixels, of the second derivatives over the KSQuad as the eye sees them. Any triangle whose
// box in the parameters is 1 / n_u wide and 1 / n_v high is nearer than errorBound() to the surface.
struct ErrorFigures {
    double a = 0;  // along u twice
    double b = 0;  // along u and v
    double c = 0;  // along v twice

    // (a / n_u^2 + 2 b / (n_u n_v) + c / n_v^2) / 8
    [[nodiscard]] double errorBound(const Grid& grid) const;
};

// tight: the largest over all projected net points. cheap: around the middle of their box, with its radius.
enum class FigureForm { tight, cheap };

// From the largest second differences and the smallest w of the 4^subdivisions parts that midpoint
// subdivision gives, with s from the whole net: a cell may lie over several parts. Nothing where a control
// point is not in front of the eye (w <= 0): the distance then has no bound of this form; see chooseGrid
// (grid_choice.h).
[[nodiscard]] std::optional<ErrorFigures> errorFigures(const BezierNet& pixels, int subdivisions = 0,
                                                       FigureForm form = FigureForm::tight);

// The grid of the fewest cells with errorBound() <= tolerance > 0: for each n_u the quadratic equation gives
// n_v. Nothing where more than `largest` cells along one side would be needed.
[[nodiscard]] std::optional<Grid> smallestGrid(const ErrorFigures& figures, double tolerance,
                                               int largest = kLargestFactor);

// Cells along a boundary curve (degreeV = 0), from the curve alone: every visible point of its polyline is
// within `tolerance` of the curve. The same bits for the curve and for the curve read backwards. Where it
// crosses the near plane only what shows counts: w is no less than there, s lies in the picture. At most
// `largest`, also where that is too few.
//
// This keeps two neighbours' edge together and the edge itself true, not the triangles beside it: those are
// only as true as errorBound() says of their box, so an edge needs no fewer cells than the grids on its
// sides.
[[nodiscard]] int edgeFactor(const BezierNet& curve, const ScreenView& view, double tolerance,
                             int largest = kLargestFactor);

}  // namespace knotspan
