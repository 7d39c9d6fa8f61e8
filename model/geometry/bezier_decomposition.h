// All KSQuads of a surface as Bezier nets at once, in float: what has to be made again at every edit where
// the device is given Bezier patches instead of the surface itself. bezier_conversion.h makes single nets, in
// double.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "model/core/space.h"
#include "model/geometry/bezier_kernels.h"
#include "model/geometry/knot_vector.h"

namespace knotspan {

// One direction: a matrix for each span. Depends on the knots alone, so that surfaces may share it.
class SpanMatrices {
public:
    explicit SpanMatrices(const KnotVector& knots);

    [[nodiscard]] size_t order() const { return order_; }  // degree + 1
    [[nodiscard]] size_t spanCount() const { return firstPoints_.size(); }
    [[nodiscard]] size_t pointCount() const { return pointCount_; }
    [[nodiscard]] kernels::SpanSums sums() const;

private:
    size_t order_;
    size_t pointCount_;
    std::vector<size_t> firstPoints_;
    std::vector<double> numbers_;
};

class BezierDecomposition {
public:
    BezierDecomposition(std::shared_ptr<const SpanMatrices> alongU,
                        std::shared_ptr<const SpanMatrices> alongV);

    // Of all nets: (degreeU + 1)(degreeV + 1) for each KSQuad.
    [[nodiscard]] size_t pointCount() const;
    // `points`: the surface's, homogeneous. `nets`: pointCount() of them, KSQuads in the order of ksQuads(),
    // each net as BezierNet has it. Computed in double, rounded last. Threads may share a decomposition.
    void decompose(std::span<const Vec4> points, std::span<glm::vec4> nets) const;

private:
    std::shared_ptr<const SpanMatrices> alongU_;
    std::shared_ptr<const SpanMatrices> alongV_;
};

}  // namespace knotspan
