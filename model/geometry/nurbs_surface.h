// A NURBS surface: immutable, and always a valid one, because create() refuses what is no surface.
//
// Control points are kept as the file gave them: unweighted coordinates with their weight, so that saving
// returns the same bits. Index i runs along u (0 .. countU - 1), j along v; point (i, j) is stored at i *
// countV + j.
#pragma once

#include <vector>

#include "model/core/space.h"
#include "model/geometry/knot_vector.h"

namespace knotspan {

struct ControlPoint {
    Vec3 position;  // unweighted
    double weight = 1.0;

    [[nodiscard]] Vec4 homogeneous() const { return {position * weight, weight}; }
    [[nodiscard]] bool operator==(const ControlPoint&) const = default;
};

class NurbsSurface {
public:
    // Refuses, with a sentence that names the control point: a net whose size is not countU * countV of the
    // knot vectors; coordinates that are not finite; weights that are not finite or not above zero.
    [[nodiscard]] static Result<NurbsSurface> create(KnotVector knotsU, KnotVector knotsV,
                                                     std::vector<ControlPoint> controlPoints);

    [[nodiscard]] const KnotVector& knotsU() const { return knotsU_; }
    [[nodiscard]] const KnotVector& knotsV() const { return knotsV_; }
    [[nodiscard]] int degreeU() const { return knotsU_.degree(); }
    [[nodiscard]] int degreeV() const { return knotsV_.degree(); }
    [[nodiscard]] int countU() const { return knotsU_.controlPointCount(); }
    [[nodiscard]] int countV() const { return knotsV_.controlPointCount(); }
    [[nodiscard]] const std::vector<ControlPoint>& controlPoints() const { return controlPoints_; }
    [[nodiscard]] const ControlPoint& controlPoint(int i, int j) const
    {
        return controlPoints_[static_cast<size_t>(i) * static_cast<size_t>(countV()) +
                              static_cast<size_t>(j)];
    }

    // Whether two weights differ, so that the denominator is no constant.
    [[nodiscard]] bool isRational() const { return rational_; }

    // Whether the boundaries u = start and u = end (or those of v) are one curve, to 1e-9 of the net's size.
    [[nodiscard]] bool isClosedU() const;
    [[nodiscard]] bool isClosedV() const;

    // The box around the control points; the surface lies inside it (convex hull).
    [[nodiscard]] const Box& bounds() const { return bounds_; }

    [[nodiscard]] bool operator==(const NurbsSurface& other) const
    {
        return knotsU_ == other.knotsU_ && knotsV_ == other.knotsV_ && controlPoints_ == other.controlPoints_;
    }

private:
    NurbsSurface(KnotVector knotsU, KnotVector knotsV, std::vector<ControlPoint> controlPoints);

    KnotVector knotsU_;
    KnotVector knotsV_;
    std::vector<ControlPoint> controlPoints_;
    Box bounds_;
    bool rational_ = false;
};

}  // namespace knotspan
