// What grid and scattered evaluation keep of a surface between calls.
#pragma once

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

    // Replaces a normal that the kernels could not tell, at index `at` of the planes, by the reference's.
    void settleNormal(GridSamples<Real>& samples, size_t at, const SpanParameter& u,
                      const SpanParameter& v) const;

    SampleFields fields;
    int order;  // of the derivatives that are computed
    DifferenceNets<Real> nets;
    std::vector<kernels::Net<Real>> kernelNets;
    SpanTables basisU;
    SpanTables basisV;
    std::optional<NurbsSurface> surface;  // where normals are wanted
    // By span: what a tangent may be by rounding alone. Empty without derivatives.
    std::vector<Real> shortestU;
    std::vector<Real> shortestV;
};

}  // namespace knotspan
