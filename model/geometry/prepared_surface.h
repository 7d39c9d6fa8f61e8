// What grid and scattered evaluation keep of a surface between calls.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "model/geometry/difference_nets.h"
#include "model/geometry/grid_evaluation.h"
#include "model/geometry/grid_kernels.h"
#include "model/geometry/span_tables.h"

namespace knotspan {

template <class Real>
struct PreparedSurface {
    PreparedSurface(const NurbsSurface& from, SampleFields wanted);

    // Fills in what a block of kernels needs of surface and samples; `start` is the block's first sample in a
    // plane.
    void aim(kernels::Block<Real>& block, GridSamples<Real>& samples, size_t start) const;

    // Samples whose normals the kernels could not tell: where in the planes, and at which parameters.
    struct Unsure {
        std::vector<size_t> at;
        std::vector<SpanParameter> u;
        std::vector<SpanParameter> v;
    };
    // Gives them normals with more digits: in float those of the evaluation in double, there the reference's.
    void settleNormals(GridSamples<Real>& samples, const Unsure& unsure) const;

    SampleFields fields;
    int order;  // of the derivatives that are computed
    DifferenceNets<Real> nets;
    std::vector<kernels::Net<Real>> kernelNets;
    KnotVector knotsU;
    KnotVector knotsV;
    SpanTables basisU;
    SpanTables basisV;
    std::optional<NurbsSurface> surface;  // where normals are wanted
    mutable std::once_flag exactOnce;     // for float: made when first needed
    mutable std::unique_ptr<GridEvaluator<double>> exact;
    // By span: what a tangent times the weight may be by rounding alone. Empty without derivatives.
    std::vector<Real> shortestU;
    std::vector<Real> shortestV;
};

}  // namespace knotspan
