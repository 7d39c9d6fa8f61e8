// The fast evaluation's own rules; how exact it is, is in tests/model/extremes.
#include "model/geometry/grid_evaluation.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/geometry/simd_targets.h"
#include "tests/random_surface.h"

namespace knotspan::testing {
namespace {

// Two flat strips that meet at right angles, the second half upright; v = 0 is one point of each strip's
// edge.
NurbsSurface creasedFan(double start)
{
    const KnotVector u =
        KnotVector::create(1, {start, start, start + 0.01, start + 0.02, start + 0.02}).value();
    const KnotVector v = KnotVector::clampedUniform(2, 1);
    std::vector<ControlPoint> points;
    for (const Vec3& across : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 1)})
        for (const double along : {0.0, 0.0, 1.0})
            points.push_back({across + Vec3(0, along, 0), 1.0});
    return NurbsSurface::create(u, v, points).value();
}

TEST(GridEvaluation, TakesTheNormalOfItsOwnSpanAtACreaseWhereverTheKnotsLie)
{
    for (const double start : {0.0, 1e3, 1e6}) {
        const NurbsSurface surface = creasedFan(start);
        const GridEvaluator<double> evaluator(surface, {0, true});
        const SpanParameter ends{surface.knotsU().spans()[0], 1.0};
        const SpanParameter begins{surface.knotsU().spans()[1], 0.0};
        const SpanParameter pinched{surface.knotsV().spans()[0], 0.0};
        GridSamples<double> samples;
        evaluator.evaluate(std::vector{ends, begins}, std::vector{pinched}, samples);
        EXPECT_LT(glm::length(samples.normal(0, 0) - Vec3(0, 0, 1)), 1e-6) << start;
        EXPECT_LT(glm::length(samples.normal(1, 0) - Vec3(-1, 0, 0)), 1e-6) << start;
    }
}

TEST(GridEvaluation, GivesARowTheSameBitsOnOneThreadAndOnAll)
{
    std::mt19937 random(3);
    const NurbsSurface surface = randomSurface(random, {3, 4, 6, true, 0.0, 10.0});
    std::vector<double> along(100'000);
    for (size_t k = 0; k < along.size(); ++k)
        along[k] =
            surface.knotsV().domainStart() +
            (surface.knotsV().domainEnd() - surface.knotsV().domainStart()) * static_cast<double>(k) / 99'999;
    const auto v = spanParameters(surface.knotsV(), along);
    const auto u = spanParameters(surface.knotsU(), std::vector{surface.knotsU().domainStart() + 0.3});
    const GridEvaluator<double> evaluator(surface, {1, true});
    GridSamples<double> one;
    GridSamples<double> all;
    evaluator.evaluate(u, v, one, Threads::one);
    evaluator.evaluate(u, v, all, Threads::all);
    for (int c = 0; c < 3; ++c)
        for (const auto field :
             {GridSamples<double>::kPosition, GridSamples<double>::kDv, GridSamples<double>::kNormal})
            EXPECT_TRUE(std::equal(one.plane(field, c).begin(),
                                   one.plane(field, c).begin() + static_cast<std::ptrdiff_t>(v.size()),
                                   all.plane(field, c).begin()));
}

TEST(GridEvaluation, OfNothingIsNothing)
{
    std::mt19937 random(3);
    const GridEvaluator<float> evaluator(randomSurface(random, {}), {2, true});
    GridSamples<float> samples;
    evaluator.evaluate({}, {}, samples);
    EXPECT_EQ(samples.rows() * samples.columns(), 0);
    evaluator.evaluateScattered({}, {}, samples);
    EXPECT_EQ(samples.columns(), 0);
}

TEST(GridEvaluation, ByAShadersEvaluatorNeedsNoNormals)
{
    std::mt19937 random(3);
    const NurbsSurface surface = randomSurface(random, {3, 5, 3, true, 0.0, 10.0});
    const std::vector<SpanParameter> u{{surface.knotsU().spans()[0], 0.25}};
    const std::vector<SpanParameter> v{{surface.knotsV().spans()[0], 0.5}};
    const GridEvaluator<double> evaluator(surface, {1, false});
    GridSamples<double> exact;
    GridSamples<double> same;
    evaluator.evaluateScattered(u, v, exact);
    evaluator.evaluateScatteredBy(Evaluator::bernstein, u, v, same);
    EXPECT_LT(glm::length(exact.position(0, 0) - same.position(0, 0)), 1e-14);
    EXPECT_LT(glm::length(exact.du(0, 0) - same.du(0, 0)), 1e-12 * glm::length(exact.du(0, 0)));
    EXPECT_FALSE(same.has(GridSamples<double>::kNormal));
}

TEST(SimdTargets, StayAsChosenWhoeverAsksForTheList)
{
    for (const std::string& target : simdTargets()) {
        useSimdTarget(target);
        EXPECT_FALSE(simdTargets().empty());
        EXPECT_EQ(simdTargetInUse(), target);
    }
    useSimdTarget("");
    EXPECT_EQ(simdTargetInUse(), simdTargets().front());
}

}  // namespace
}  // namespace knotspan::testing
