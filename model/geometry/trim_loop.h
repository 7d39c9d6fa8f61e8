// Trim loops: closed chains of NURBS curves in a surface's (u,v) that say which part of it is the face.
//
// They are kept with the object from the first import on, unchanged to the bit.
#pragma once

#include <vector>

#include "model/core/space.h"
#include "model/geometry/knot_vector.h"

namespace knotspan {

struct TrimPoint {
    Vec2 position;  // (u, v), unweighted
    double weight = 1.0;

    [[nodiscard]] bool operator==(const TrimPoint&) const = default;
};

// A NURBS curve in the parameter plane.
class TrimCurve {
public:
    // Refuses, with a sentence, what KnotVector refuses, a wrong number of points, and numbers that are not
    // finite or weights that are not above zero.
    [[nodiscard]] static Result<TrimCurve> create(KnotVector knots, std::vector<TrimPoint> points);

    [[nodiscard]] const KnotVector& knots() const { return knots_; }
    [[nodiscard]] const std::vector<TrimPoint>& points() const { return points_; }
    // At t, taken into the knots' domain: the place, and its derivative by t.
    [[nodiscard]] Vec2 evaluate(double t) const;
    [[nodiscard]] Vec2 derivative(double t) const;

    [[nodiscard]] bool operator==(const TrimCurve&) const = default;

private:
    struct Look {
        Vec2 at;
        Vec2 slope;
    };
    [[nodiscard]] Look look(double t) const;
    TrimCurve(KnotVector knots, std::vector<TrimPoint> points);

    KnotVector knots_;
    std::vector<TrimPoint> points_;
};

// Curves in order, each starting where the one before ends. The face lies to the left of an outer loop.
struct TrimLoop {
    bool outer = true;
    std::vector<TrimCurve> curves;

    [[nodiscard]] bool operator==(const TrimLoop&) const = default;
};

// With the border of the whole surface around holes that have nothing around them, for whoever takes the
// first loop for the outer one; others as they are.
[[nodiscard]] std::vector<TrimLoop> withBorder(std::vector<TrimLoop> loops, const KnotVector& knotsU,
                                               const KnotVector& knotsV);

}  // namespace knotspan
