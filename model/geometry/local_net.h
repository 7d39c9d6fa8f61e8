// The control points that shape one KSQuad with the basis at one of its parameters: what the evaluation of
// points and of normals is made of.
#pragma once

#include "model/geometry/basis.h"
#include "model/geometry/nurbs_surface.h"

namespace knotspan {

// Partial derivatives of the homogeneous surface are B-splines of differences of control points (The NURBS
// Book, eq. 3.4): differences of neighbours keep their digits where spans are short and neighbours nearly
// coincide; derivatives of basis functions would cancel there. Weights are relative to that of the control
// point that counts most, so that they neither overflow nor vanish.
class LocalNet {
public:
    // (u, v) lies in the domain.
    LocalNet(const NurbsSurface& surface, double u, double v);

    [[nodiscard]] int degreeU() const { return surface_.degreeU(); }
    [[nodiscard]] int degreeV() const { return surface_.degreeV(); }
    [[nodiscard]] Vec3 position(int i, int j) const { return point(i, j).position * shrinking_; }
    [[nodiscard]] double weight(int i, int j) const;

    // The position of the control point that counts most: relative to it a part far from the origin keeps its
    // digits, and even weights that differ by many orders cancel nothing.
    [[nodiscard]] Vec3 heaviest() const { return position(heaviestI_, heaviestJ_); }

    // All positions are smaller than the surface's by this power of two: 1, but where coordinates are so
    // large that their differences, or their products with weights, would overflow.
    [[nodiscard]] double shrinking() const { return shrinking_; }

    // A partial derivative of the homogeneous surface, its space part relative to heaviest() + from.
    [[nodiscard]] Vec4 sum(int orderU, int orderV, const Vec3& from) const;

    // The same with all parts positive: what rounding errors of sum() are to be measured by.
    [[nodiscard]] Vec4 sumOfSizes(int orderU, int orderV, const Vec3& from) const;

private:
    [[nodiscard]] const ControlPoint& point(int i, int j) const
    {
        return surface_.controlPoint(firstU_ + i, firstV_ + j);
    }

    // One way to combine what two neighbours bring: their difference, or what its rounding is measured by.
    enum class Parts { signed_, sizes };
    template <Parts parts>
    [[nodiscard]] Vec4 controlPoint(int orderU, int orderV, int i, int j, const Vec3& from) const;
    template <Parts parts>
    [[nodiscard]] Vec4 neighbours(int i, int j, int nextI, int nextJ, const Vec3& from) const;
    template <Parts parts>
    [[nodiscard]] Vec4 total(int orderU, int orderV, const Vec3& from) const;

    const NurbsSurface& surface_;
    int firstU_;
    int firstV_;
    BasisOfDegrees basisU_;
    BasisOfDegrees basisV_;
    int heaviestI_ = 0;
    int heaviestJ_ = 0;
    double lightening_ = 1;
    double shrinking_ = 1;
};

}  // namespace knotspan
