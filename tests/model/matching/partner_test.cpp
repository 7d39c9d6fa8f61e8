#include "model/matching/partner.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/matching/match.h"
#include "model/matching/row_fit.h"
#include "model/samples/net.h"
#include "tests/random_surface.h"

namespace knotspan {
namespace {

const KnotVector kLine = KnotVector::clampedUniform(1, 1);

// Edges that wind about, so that places far apart along them are close to each other.
NurbsSurface windingEdge(std::mt19937& random, int spans)
{
    return surfaceOf(kLine, KnotVector::clampedUniform(3, spans), [&](int i, int) -> ControlPoint {
        const auto any = [&] { return testing::randomBetween(random, -1, 1); };
        return {{any(), any(), i + any()}, testing::randomBetween(random, 0.8, 1.25)};
    });
}

// In no order, as the last answer is where the next search begins.
TEST(NearestParameter, IsAtLeastAsNearAsTenPlacesInEachSpan)
{
    std::mt19937 random(111);
    for (int round = 0; round < 10; ++round) {
        const NurbsSurface mover = windingEdge(random, 6);
        const NurbsSurface partner = windingEdge(random, 12);
        const Partnering nearest = nearestParameter(mover, partner);
        for (int k = 0; k < 200; ++k) {
            const double v = testing::randomBetween(random, 0, 1);
            const Vec3 point = evaluate(mover, 0, v).position;
            double least = std::numeric_limits<double>::infinity();
            for (const double place : sampleParameters(partner.knotsV(), 8))
                least = std::min(least, glm::distance(point, evaluate(partner, 0, place).position));
            EXPECT_LE(glm::distance(point, evaluate(partner, 0, nearest(v)).position), least) << v;
            EXPECT_EQ(nearest(v), nearest(v));
        }
    }
}

TEST(NearestParameter, FindsTheParameterOfAPointOfTheEdge)
{
    std::mt19937 random(112);
    for (int round = 0; round < 10; ++round) {
        const NurbsSurface edge = windingEdge(random, 12);
        const Partnering nearest = nearestParameter(edge, edge);
        for (int k = 0; k < 200; ++k) {
            const double v = testing::randomBetween(random, 0, 1);
            EXPECT_NEAR(nearest(v), v, 1e-7);
        }
    }
}

// What a match costs, in evaluations of a point of its surfaces, so that neither the machine nor a sanitizer
// counts: edges that run together but are parametrized otherwise.
double costOfMatch(int spans)
{
    using Clock = std::chrono::steady_clock;
    const KnotVector v = KnotVector::clampedUniform(3, spans);
    const KnotVector u = KnotVector::clampedUniform(3, 1);
    const NurbsSurface a = surfaceOf(u, v, [&](int i, int j) -> ControlPoint {
        return {{-i, 10 * grevilleAbscissa(v, j), 0}, 1};
    });
    const NurbsSurface b = surfaceOf(u, v, [&](int i, int j) -> ControlPoint {
        const double y = grevilleAbscissa(v, j);
        return {{i, 10 * (y + 0.3 * y * (1 - y)), 0.2 * i * std::sin(3 * y) + 0.1 * i}, 1};
    });
    MatchRequest request;
    request.a.surface = &a;
    request.b.surface = &b;
    request.edgeA = {0, Side::startU, 0, 1};
    request.edgeB = {1, Side::startU, 0, 1};
    const auto start = Clock::now();
    const auto proposal = matchEdge(request);
    const auto middle = Clock::now();
    EXPECT_TRUE(proposal) << proposal.error().sentence();
    constexpr int kEvaluations = 20000;
    double sum = 0;
    for (int k = 0; k < kEvaluations; ++k)
        sum += evaluate(b, 0.5, static_cast<double>(k) / kEvaluations).position.y;
    EXPECT_GT(sum, 0);
    return kEvaluations * ((middle - start) / std::chrono::duration<double>(Clock::now() - middle));
}

TEST(NearestParameter, CostsNoMoreForEachSpanWhereThereAreMany)
{
    const double few = costOfMatch(10);
    const double many = costOfMatch(40);
    RecordProperty("evaluations_10_spans", std::to_string(few));
    RecordProperty("evaluations_40_spans", std::to_string(many));
    EXPECT_LT(many, 3e5);  // 40,000; 2,000,000 where each question looks at all samples anew
}

}  // namespace
}  // namespace knotspan
