#include "model/geometry/prepared_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/geometry/evaluation.h"

namespace knotspan {

namespace {

// The parameter of the knot vector; a span's end is taken a little before it, so that it belongs to the span.
double parameter(const KnotVector& knots, const SpanParameter& at)
{
    const double length = knots[at.span + 1] - knots[at.span];
    const bool ends = at.t >= 1 && knots[at.span + 1] < knots.domainEnd();
    const double value = knots[at.span] + (ends ? 1 - 0x1p-30 : at.t) * length;
    return ends ? std::min(value, std::nextafter(knots[at.span + 1], knots[at.span])) : value;
}

// Of each span, from the numbers that a tangent on it is a sum of; a rational one is a difference of two such
// sums.
template <class Real>
std::vector<Real> shortestTangents(const KnotVector& knots, const std::vector<Real>& largest, int components)
{
    constexpr Real kRounding = 4096 * std::numeric_limits<Real>::epsilon();
    std::vector<Real> result(knots.values().size());
    for (const int span : knots.spans()) {
        const auto first = largest.begin() + (span - knots.degree());
        result[static_cast<size_t>(span)] =
            kRounding * *std::max_element(first, first + knots.degree()) * Real(components - 2);
    }
    return result;
}

}  // namespace

template <class Real>
PreparedSurface<Real>::PreparedSurface(const NurbsSurface& from, SampleFields wanted)
    : fields(wanted),
      order(wanted.normals ? std::max(wanted.derivatives, 1) : wanted.derivatives),
      nets(from, order),
      knotsU(from.knotsU()),
      knotsV(from.knotsV()),
      basisU(from.knotsU()),
      basisV(from.knotsV())
{
    for (const DifferenceNet<Real>& net : nets.nets)
        kernelNets.push_back({net.numbers.get(), net.countU, net.countV, net.orderU, net.orderV});
    if (fields.normals)
        surface = from;
    if (order >= 1) {
        shortestU = shortestTangents(from.knotsU(), nets.nets[1].largestOfI, nets.components);
        shortestV = shortestTangents(from.knotsV(), nets.nets[2].largestOfJ, nets.components);
    }
}

template <class Real>
void PreparedSurface<Real>::aim(kernels::Block<Real>& block, GridSamples<Real>& samples, size_t start) const
{
    // Less than the second cache of today's processors.
    constexpr size_t kCache = 1 << 20;
    block.nets = kernelNets.data();
    block.netCount = static_cast<int>(kernelNets.size());
    block.components = nets.components;
    block.degreeU = basisU.degree();
    block.stride = samples.stride();
    block.pastTheCache = samples.bytes() > kCache;
    for (int field = 0; field < GridSamples<Real>::kFieldCount; ++field)
        if (const auto name = static_cast<typename GridSamples<Real>::Field>(field); samples.has(name))
            for (int c = 0; c < 3; ++c)
                block.planes[3 * field + c] = samples.plane(name, c).data() + start;
}

template <>
void PreparedSurface<float>::settleNormals(GridSamples<float>& samples, const Unsure& unsure) const
{
    if (unsure.at.empty())
        return;
    std::call_once(exactOnce, [this] {
        exact = std::make_unique<GridEvaluator<double>>(*surface, SampleFields{.normals = true});
    });
    GridSamples<double> found;
    exact->evaluateScattered(unsure.u, unsure.v, found, Threads::one);
    for (int c = 0; c < 3; ++c)
        for (size_t k = 0; k < unsure.at.size(); ++k)
            samples.plane(GridSamples<float>::kNormal, c)[unsure.at[k]] =
                static_cast<float>(found.plane(GridSamples<double>::kNormal, c)[k]);
}

template <>
void PreparedSurface<double>::settleNormals(GridSamples<double>& samples, const Unsure& unsure) const
{
    for (size_t k = 0; k < unsure.at.size(); ++k) {
        const Vec3 normal =
            evaluateNormal(*surface, parameter(knotsU, unsure.u[k]), parameter(knotsV, unsure.v[k]))
                .direction;
        for (int c = 0; c < 3; ++c)
            samples.plane(GridSamples<double>::kNormal, c)[unsure.at[k]] = normal[c];
    }
}

template struct PreparedSurface<float>;
template struct PreparedSurface<double>;

}  // namespace knotspan
