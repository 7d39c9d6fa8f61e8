// The control points that shape one KSQuad with the basis at one of its parameters: what the evaluation of
// points and of normals is made of.
#pragma once

#include "model/geometry/basis.h"
#include "model/geometry/nurbs_surface.h"

namespace knotspan {

struct LocalNet {
    const NurbsSurface& surface;
    int firstU;
    int firstV;
    BasisDerivatives basisU;
    BasisDerivatives basisV;

    [[nodiscard]] const ControlPoint& point(int i, int j) const
    {
        return surface.controlPoint(firstU + i, firstV + j);
    }
    [[nodiscard]] double factor(int orderU, int orderV, int i, int j) const
    {
        return basisU[static_cast<size_t>(orderU)][static_cast<size_t>(i)] *
               basisV[static_cast<size_t>(orderV)][static_cast<size_t>(j)];
    }

    // The control point that counts most: relative to it even weights that differ by many orders cancel
    // nothing.
    [[nodiscard]] Vec3 origin() const;

    // A partial derivative of the homogeneous surface, its space part relative to `from`.
    [[nodiscard]] Vec4 sum(int orderU, int orderV, const Vec3& from) const;

    // The same with all parts positive: what rounding errors of sum() are to be measured by.
    [[nodiscard]] Vec4 sumOfSizes(int orderU, int orderV, const Vec3& from) const;
};

// (u, v) lies in the domain.
[[nodiscard]] LocalNet localNet(const NurbsSurface& surface, double u, double v);

}  // namespace knotspan
