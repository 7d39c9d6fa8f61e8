// Where a plane cuts a surface: curves whose points lie on both, as far apart as a tolerance asks.
#pragma once

#include <memory>
#include <vector>

#include "model/mesh/tessellation.h"

namespace knotspan {

// The points p with dot(normal, p) = offset; model space.
struct SectionPlane {
    Vec3 normal{0, 0, 1};  // unit
    double offset = 0;
};

// A polyline. Where it is closed its first point is also its last.
struct SectionCurve {
    std::vector<Vec3> points;

    [[nodiscard]] bool isClosed() const { return points.size() > 2 && points.front() == points.back(); }
    [[nodiscard]] double length() const;
};

// A surface made ready for being cut by many planes: a mesh finds the curves, the surface itself says where
// they run.
class SectionSurface {
public:
    // Bumps lower than `deviation` (above zero, model units) may be missed where the plane only touches them.
    // Refuses what tessellate() refuses.
    [[nodiscard]] static Result<SectionSurface> create(SharedObject object, double deviation);

    // Points are on the surface and, to rounding, on the plane; the curve between two of them is at most
    // about `tolerance` (above zero) from the straight line, measured in its middle. Where the plane touches
    // the surface along an area there is no curve inside of it; where it touches in a point, curves that
    // cross there may be joined otherwise, across a cell of the mesh.
    [[nodiscard]] std::vector<SectionCurve> cut(const SectionPlane& plane, double tolerance) const;

private:
    SectionSurface(SharedObject object, Tessellation mesh);

    SharedObject object_;
    std::shared_ptr<const Tessellation> mesh_;
};

}  // namespace knotspan
