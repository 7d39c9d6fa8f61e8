#include <algorithm>
#include <vector>

#include <hwy/cache_control.h>
#include <tbb/parallel_for.h>

#include "model/core/check.h"
#include "model/geometry/evaluator_tables.h"
#include "model/geometry/prepared_surface.h"
#include "shaders/shared/nurbs_basis.glsl"

namespace knotspan {

using kernels::kGroupLanes;

namespace {

using Parameters = std::span<const SpanParameter>;

// Runs `fill(first index, points)` and the kernels for all points, a group at a time.
template <class Real, class Fill>
void evaluateGroups(const PreparedSurface<Real>& prepared, std::span<const kernels::Net<Real>> nets,
                    kernels::ScatteredPoints<Real> scattered, Parameters u, Parameters v,
                    GridSamples<Real>& samples, Threads threads, const Fill& fill)
{
    constexpr size_t kLanes = static_cast<size_t>(kGroupLanes<Real>);
    // Fewer points than this are done before another thread has started.
    constexpr size_t kGroupsInTask = 2048 / kLanes;
    check(u.size() == v.size(), "scattered points have as many u as v");
    samples.resize(1, static_cast<int>(u.size()), prepared.fields, prepared.nets.origin);
    const size_t groups = (u.size() + kLanes - 1) / kLanes;
    const auto runGroups = [&](size_t firstGroup, size_t lastGroup) {
        kernels::ScatteredPoint<Real> points[kGroupLanes<Real>];
        kernels::ScatteredPoints<Real> task = scattered;
        task.points = points;
        typename PreparedSurface<Real>::Unsure found;
        for (size_t group = firstGroup; group < lastGroup; ++group) {
            const size_t start = group * kLanes;
            task.count = static_cast<int>(std::min(kLanes, u.size() - start));
            fill(start, std::span(points).first(static_cast<size_t>(task.count)));
            if (prepared.order >= 1)
                for (size_t k = 0; k < static_cast<size_t>(task.count); ++k) {
                    points[k].shortestU = prepared.shortestU[static_cast<size_t>(u[start + k].span)];
                    points[k].shortestV = prepared.shortestV[static_cast<size_t>(v[start + k].span)];
                }
            kernels::Block<Real> block;
            prepared.aim(block, samples, start);
            block.nets = nets.data();
            std::uint32_t unsure = 0;
            block.unsure = &unsure;
            kernels::evaluate(block, task);
            for (size_t k = 0; k < static_cast<size_t>(task.count); ++k)
                if ((unsure >> k & 1U) != 0) {
                    found.at.push_back(start + k);
                    found.u.push_back(u[start + k]);
                    found.v.push_back(v[start + k]);
                }
        }
        // What was written past the cache is to be seen by the threads that wait for this one.
        hwy::FlushStream();
        prepared.settleNormals(samples, found);
    };
    const size_t tasks = (groups + kGroupsInTask - 1) / kGroupsInTask;
    const auto run = [&](size_t task) {
        runGroups(task * kGroupsInTask, std::min((task + 1) * kGroupsInTask, groups));
    };
    if (threads == Threads::one || tasks < 2)
        runGroups(0, groups);
    else
        tbb::parallel_for(size_t{0}, tasks, run);
}

// A direction's span tables for one of the shaders' evaluators.
template <class Real>
struct EvaluatorTables {
    EvaluatorTables(Evaluator evaluator, const KnotVector& of)
        : knots(of),
          tables(of,
                 [&](int span, std::vector<Real>& numbers) { appendSpanTable(evaluator, of, span, numbers); })
    {
    }

    template <Evaluator evaluator>
    void fill(const SpanParameter& at, int& first, Real (&rows)[3][16]) const
    {
        const int degree = knots.degree();
        const auto basis = gpu::evaluateBasis<static_cast<gpu::uint>(evaluator), Real>(
            TableSource<Real>{tables.data()}, static_cast<gpu::uint>(tables.startOf(at.span)), degree,
            static_cast<Real>(at.t));
        first = at.span - degree;
        const Real perLength = Real(1 / (knots[at.span + 1] - knots[at.span]));
        for (size_t k = 0; k <= static_cast<size_t>(degree); ++k) {
            rows[0][k] = basis.value[k];
            rows[1][k] = basis.slope[k] * perLength;
        }
    }

    const KnotVector& knots;
    SpanNumbers<Real> tables;
};

}  // namespace

template <class Real>
void GridEvaluator<Real>::evaluateScattered(Parameters u, Parameters v, GridSamples<Real>& samples,
                                            Threads threads) const
{
    const PreparedSurface<Real>& prepared = *prepared_;
    const int p = prepared.basisU.degree();
    kernels::ScatteredPoints<Real> scattered;
    scattered.mostTermsV = prepared.basisV.degree() + 1;
    for (size_t n = 0; n < prepared.kernelNets.size(); ++n)
        scattered.termsU[n] = std::max(p + 1 - prepared.kernelNets[n].orderU, 0);
    // One direction of a group of points, `first` and `rows` being where they keep it.
    const auto fill = [&](const SpanTables& tables, Parameters at,
                          std::span<kernels::ScatteredPoint<Real>> points, auto first, auto rows) {
        kernels::BasisLanes lanes;
        for (size_t k = 0; k < points.size(); ++k) {
            const size_t inLanes = k % kernels::kBasisLanes;
            if (inLanes == 0)
                tables.basis(at.subspan(k), prepared.order, lanes);
            points[k].*first = at[k].span - tables.degree();
            for (int b = 0; b <= prepared.order; ++b)
                for (int i = 0; i <= tables.degree() - b; ++i)
                    (points[k].*rows)[b][i] = static_cast<Real>(lanes.rows[b][i][inLanes]);
        }
    };
    using Point = kernels::ScatteredPoint<Real>;
    evaluateGroups<Real>(prepared, prepared.kernelNets, scattered, u, v, samples, threads,
                         [&](size_t start, std::span<Point> points) {
                             fill(prepared.basisU, u.subspan(start), points, &Point::firstU, &Point::u);
                             fill(prepared.basisV, v.subspan(start), points, &Point::firstV, &Point::v);
                         });
}

template <class Real>
void GridEvaluator<Real>::evaluateScatteredBy(Evaluator evaluator, Parameters u, Parameters v,
                                              GridSamples<Real>& samples, Threads threads) const
{
    const PreparedSurface<Real>& prepared = *prepared_;
    check(prepared.order <= 1, "the shaders' evaluators give first derivatives at most");
    const KnotVector& knotsU = prepared.knotsU;
    const KnotVector& knotsV = prepared.knotsV;
    // Every derivative from the points themselves: the slopes are in the basis functions.
    std::vector<kernels::Net<Real>> nets(prepared.kernelNets.size(), prepared.kernelNets[0]);
    kernels::ScatteredPoints<Real> scattered;
    scattered.mostTermsV = knotsV.degree() + 1;
    for (size_t n = 0; n < nets.size(); ++n) {
        nets[n].orderU = prepared.kernelNets[n].orderU;
        nets[n].orderV = prepared.kernelNets[n].orderV;
        scattered.termsU[n] = knotsU.degree() + 1;
    }
    const auto run = [&]<Evaluator chosen>() {
        const EvaluatorTables<Real> tablesU(chosen, knotsU);
        const EvaluatorTables<Real> tablesV(chosen, knotsV);
        evaluateGroups<Real>(prepared, nets, scattered, u, v, samples, threads,
                             [&](size_t start, std::span<kernels::ScatteredPoint<Real>> points) {
                                 for (size_t k = 0; k < points.size(); ++k) {
                                     kernels::ScatteredPoint<Real>& point = points[k];
                                     tablesU.template fill<chosen>(u[start + k], point.firstU, point.u);
                                     tablesV.template fill<chosen>(v[start + k], point.firstV, point.v);
                                 }
                             });
    };
    constexpr Precision kPrecision = sizeof(Real) == 4 ? Precision::float32 : Precision::float64;
    switch (chosenEvaluator(evaluator, std::max(knotsU.degree(), knotsV.degree()), kPrecision)) {
#define KNOTSPAN_ONE(number, name, ...) \
    case Evaluator::name:               \
        return run.template operator()<Evaluator::name>();
        KNOTSPAN_EVALUATOR_LIST(KNOTSPAN_ONE)
#undef KNOTSPAN_ONE
    case Evaluator::automatic:
        check(false, "a chosen evaluator is one of the list");
    }
}

template void GridEvaluator<float>::evaluateScattered(Parameters, Parameters, GridSamples<float>&,
                                                      Threads) const;
template void GridEvaluator<double>::evaluateScattered(Parameters, Parameters, GridSamples<double>&,
                                                       Threads) const;
template void GridEvaluator<float>::evaluateScatteredBy(Evaluator, Parameters, Parameters,
                                                        GridSamples<float>&, Threads) const;
template void GridEvaluator<double>::evaluateScatteredBy(Evaluator, Parameters, Parameters,
                                                         GridSamples<double>&, Threads) const;

}  // namespace knotspan
