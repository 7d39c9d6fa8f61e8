// How far, in model units, the triangles of a grid over a KSQuad can be from the surface, before any is made:
// the bound of screen_error.h in space instead of on screen.
//
// The surface is X / w with X = (w S, w) a polynomial, a triangle is the homogeneous linear interpolant of
// its vertices. With L that interpolant, E = X - L, s = L.xyz / L.w on the triangle: S - s = (E.xyz - s E.w)
// / w, and second derivatives bound E. A window is a part of the KSQuad; those of one size overlap, so that
// each triangle's box of parameters lies in one. In a window the second derivatives count by the middle of
// their values, as if they were constant, and by how far they are from it (spread).
//
// Where weights differ there is another pairing, with the triangle's point at the same shares of its corners:
// then second derivatives of S itself count, whose numerators over w^3 are polynomials too. Each window takes
// the better one: along a cylinder the first slides a lot, this one not at all.
#pragma once

#include <optional>

#include "model/analysis/screen_error.h"

namespace knotspan {

// Second derivatives over t in a window.
struct SpaceFigures {
    Vec3 a{};  // along u twice: the middle of its values
    Vec3 b{};  // along u and v
    Vec3 c{};  // along v twice
    Vec3 spread{};
    Vec3 largest{};
    double divisor = 1;  // of all the others

    [[nodiscard]] double errorBound(const Grid& grid) const;
    [[nodiscard]] double errorBound(const Vec2& size) const;
    // Whether that is at most `tolerance`; quicker.
    [[nodiscard]] bool isWithin(double tolerance, const Grid& grid) const;
};

struct SpaceWindow {
    SpaceFigures homogeneous;
    std::optional<SpaceFigures> ofSurface;

    // Of any triangle whose box is 1 / grid.u wide and 1 / grid.v high, or of this size.
    [[nodiscard]] double errorBound(const Grid& grid) const;
    [[nodiscard]] double errorBound(const Vec2& size) const;
    [[nodiscard]] bool isWithin(double tolerance, const Grid& grid) const;
    // The one that is less in all.
    [[nodiscard]] const SpaceFigures& better() const;
};

class SpaceError {
public:
    // `net` in model units, relative to a place nearby; w > 0 everywhere. Refers to it.
    explicit SpaceError(const BezierNet& net);

    // Looks for the surface's own second derivatives, too, where the homogeneous ones are far larger. That
    // costs as much again, and many KSQuads are flat enough without.
    void considerSurface();

    // The whole KSQuad.
    [[nodiscard]] const SpaceWindow& whole() const { return whole_; }
    // So many windows each way that hold for grids no coarser than `least`.
    [[nodiscard]] std::vector<SpaceWindow> windows(const Grid& least, int countU, int countV) const;

private:
    const BezierNet& net_;
    bool rational_;
    std::vector<Vec4> along_[3];      // secondDerivatives()
    std::vector<Vec4> ofSurface_[3];  // numerators over w^3; empty where they are not looked at
    SpaceWindow whole_;
};

struct SpaceGrid {
    Grid grid;
    double bound = 0;  // <= tolerance
};
// A grid of few cells within the tolerance > 0; nothing where more than `largest` cells along a side would be
// needed.
[[nodiscard]] std::optional<SpaceGrid> chooseSpaceGrid(SpaceError& error, double tolerance,
                                                       int largest = kLargestFactor);

}  // namespace knotspan
