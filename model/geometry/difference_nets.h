// A surface's control points as the fast evaluation reads them, with the control points of its derivatives.
#pragma once

#include <memory>
#include <vector>

#include "model/geometry/nurbs_surface.h"

namespace knotspan {

// The net of one partial derivative of the homogeneous surface (of order 0: the surface itself). Point (i, j)
// is numbers[(i * components + c) * countV + j]: a row of x, one of y, one of z and, for a rational surface,
// one of w.
template <class Real>
struct DifferenceNet {
    int orderU = 0;
    int orderV = 0;
    int countU = 0;
    int countV = 0;
    std::unique_ptr<Real[]> numbers;  // and kPadding zeros more, so that whole vectors may be read at the end
    // The largest magnitude of a number: of the points (i, j) for each i, and for each j.
    std::vector<Real> largestOfI;
    std::vector<Real> largestOfJ;
};

template <class Real>
struct DifferenceNets {
    static constexpr size_t kPadding = 16;

    // `order` is the highest order of derivatives, 0 .. 2. A surface whose weights are all equal has 3
    // components, others 4. Coordinates are relative to the middle of the control points' box, weights to the
    // largest one, to a power of two; numbers beyond Real's range become its largest. The NURBS Book,
    // eq. 3.4.
    DifferenceNets(const NurbsSurface& surface, int order);

    Vec3 origin{};
    int components = 3;
    std::vector<DifferenceNet<Real>> nets;  // orders (0,0) (1,0) (0,1) (2,0) (1,1) (0,2), as far as asked for
};

}  // namespace knotspan
