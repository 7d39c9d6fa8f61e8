// The places where evaluation is measured: random, the same in each run, spread over all KSQuads, with the
// exact positions at some of them.
#pragma once

#include <vector>

#include "model/geometry/grid_evaluation.h"
#include "model/scene/scene.h"

namespace knotspan::app {

// Not less than double; where it is no more, errors of double are those of the exact positions too.
using Exact = long double;
using ExactVec3 = glm::vec<3, Exact>;

struct ExactPoint {
    size_t index;        // which of the places, as below
    ExactVec3 position;  // relative to the surface's origin, the middle of its bounds
    double size;         // the largest coordinate of the KSQuad's control points, as relative
};

// Places of one surface. Parameters are floats, so that every number type sees the same.
struct Places {
    std::vector<SpanParameter> u;
    std::vector<SpanParameter> v;
    std::vector<ExactPoint> exact;
};

struct MeasuredSurface {
    ObjectId id{};
    SharedObject object;
    // The k-th u with the k-th v, in the KSQuads' order. Where the points are too few to be timed they come
    // several times.
    Places scattered;
    // Every u with every v: point i * v.size() + j.
    Places grid;
};

struct MeasuredPoints {
    std::vector<MeasuredSurface> surfaces;  // the visible ones that got points
    size_t scattered = 0;                   // with repetitions
    size_t grid = 0;
    size_t exact = 0;  // among the scattered
};

// Of the visible objects: `count` scattered points, and grids of about as many.
[[nodiscard]] MeasuredPoints measuredPoints(const Scene& scene, size_t count);

}  // namespace knotspan::app
