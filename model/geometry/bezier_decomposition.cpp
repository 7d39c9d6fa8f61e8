#include "model/geometry/bezier_decomposition.h"

#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "model/core/check.h"
#include "model/geometry/bezier_conversion.h"
#include "model/geometry/bezier_kernels.h"

namespace knotspan {

SpanMatrices::SpanMatrices(const KnotVector& knots)
    : order_(static_cast<size_t>(knots.degree() + 1)),
      pointCount_(static_cast<size_t>(knots.controlPointCount()))
{
    for (const int span : knots.spans()) {
        firstPoints_.push_back(static_cast<size_t>(span - knots.degree()));
        const auto matrix = bezierMatrix(knots, span);
        numbers_.insert(numbers_.end(), matrix.begin(), matrix.end());
    }
}

kernels::SpanSums SpanMatrices::sums() const
{
    return {order_, spanCount(), numbers_.data(), firstPoints_.data(), pointCount_};
}

BezierDecomposition::BezierDecomposition(std::shared_ptr<const SpanMatrices> alongU,
                                         std::shared_ptr<const SpanMatrices> alongV)
    : alongU_(std::move(alongU)),
      alongV_(std::move(alongV))
{
}

size_t BezierDecomposition::pointCount() const
{
    return alongU_->spanCount() * alongV_->spanCount() * alongU_->order() * alongV_->order();
}

void BezierDecomposition::decompose(std::span<const Vec4> points, std::span<glm::vec4> nets) const
{
    check(points.size() == alongU_->pointCount() * alongV_->pointCount() && nets.size() == pointCount(),
          "the points are those of a surface of these knots");
    thread_local std::vector<Vec4> rows;
    rows.resize(alongU_->pointCount() * alongV_->spanCount() * alongV_->order());
    kernels::decompose(alongU_->sums(), alongV_->sums(), glm::value_ptr(points.front()),
                       glm::value_ptr(rows.front()), glm::value_ptr(nets.front()));
}

}  // namespace knotspan
