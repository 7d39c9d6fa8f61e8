#include <gtest/gtest.h>

#include <algorithm>

#include "model/geometry/evaluation.h"
#include "tests/model/geometry/precise_evaluation.h"
#include "tests/random_surface.h"

namespace knotspan {
namespace {

using testing::Real;

// The largest difference of a component, in units of `size`.
double difference(const Vec3& value, const std::array<Real, 3>& exact, double size)
{
    double most = 0;
    for (int c = 0; c < 3; ++c)
        most = std::max(most, std::abs(static_cast<double>(Real(value[c]) - exact[static_cast<size_t>(c)])));
    return most / size;
}

double size(const std::array<Real, 3>& value)
{
    double most = 0;
    for (const Real& part : value)
        most = std::max(most, std::abs(static_cast<double>(part)));
    return most;
}

// `derivativeSize` is what the derivative is built from: net size over span lengths.
void expectPrecise(const NurbsSurface& surface, double u, double v, double tolerance)
{
    const SurfacePoint found = evaluate(surface, u, v);
    const auto exact = testing::preciseEvaluation(surface, u, v);
    const int spanU = surface.knotsU().findSpan(u);
    const int spanV = surface.knotsV().findSpan(v);
    const double perU = surface.degreeU() / (surface.knotsU()[spanU + 1] - surface.knotsU()[spanU]);
    const double perV = surface.degreeV() / (surface.knotsV()[spanV + 1] - surface.knotsV()[spanV]);
    const double net = surface.bounds().diagonal();
    EXPECT_LE(difference(found.position, exact.position, net), tolerance);
    EXPECT_LE(difference(found.du, exact.du, std::max(size(exact.du), net * perU)), tolerance);
    EXPECT_LE(difference(found.dv, exact.dv, std::max(size(exact.dv), net * perV)), tolerance);
    EXPECT_LE(difference(found.duu, exact.duu, std::max(size(exact.duu), net * perU * perU)), 4 * tolerance);
    EXPECT_LE(difference(found.duv, exact.duv, std::max(size(exact.duv), net * perU * perV)), 4 * tolerance);
    EXPECT_LE(difference(found.dvv, exact.dvv, std::max(size(exact.dvv), net * perV * perV)), 4 * tolerance);
}

void expectPreciseAllOver(const NurbsSurface& surface, std::mt19937& random, double tolerance)
{
    const KnotVector& knotsU = surface.knotsU();
    const KnotVector& knotsV = surface.knotsV();
    for (int n = 0; n < 2; ++n)
        expectPrecise(surface, testing::randomBetween(random, knotsU.domainStart(), knotsU.domainEnd()),
                      testing::randomBetween(random, knotsV.domainStart(), knotsV.domainEnd()), tolerance);
    expectPrecise(surface, knotsU.domainStart(), knotsV.domainEnd(), tolerance);
    expectPrecise(surface, knotsU.domainEnd(), knotsV[knotsV.spans().back()], tolerance);
}

TEST(Evaluation, AgreesWithMultiplePrecisionForEveryDegree)
{
    std::mt19937 random(2);
    for (int degree = kMinDegree; degree <= kMaxDegree; ++degree)
        for (const bool rational : {false, true})
            for (const bool clamped : {false, true}) {
                SCOPED_TRACE("degree " + std::to_string(degree) + (rational ? ", rational" : "") +
                             (clamped ? ", clamped" : ", not clamped"));
                const int other = 1 + (3 * degree) % 7;
                expectPreciseAllOver(testing::randomSurface(random, {.degreeU = degree,
                                                                     .degreeV = other,
                                                                     .rational = rational,
                                                                     .spanRatio = 100,
                                                                     .clamped = clamped}),
                                     random, 1e-13);
            }
}

TEST(Evaluation, KeepsItsDigitsWithWeightsOverTwelveOrders)
{
    std::mt19937 random(3);
    for (const int degree : {2, 3, 5, 9})
        expectPreciseAllOver(
            testing::randomSurface(random, {.degreeU = degree, .rational = true, .weightRatio = 1e6}), random,
            1e-13);
}

TEST(Evaluation, LosesOnlyTheLastDigitsOfACoordinateFarFromTheOrigin)
{
    std::mt19937 random(4);
    const NurbsSurface near = testing::randomSurface(random, {.degreeU = 3, .degreeV = 4, .rational = true});
    std::vector<ControlPoint> points = near.controlPoints();
    for (ControlPoint& point : points)
        point.position = glm::floor(point.position * 1024.0) / 1024.0;
    const auto rounded = *NurbsSurface::create(near.knotsU(), near.knotsV(), points);
    for (ControlPoint& point : points)
        point.position += Vec3(1 << 23, -(1 << 24), 1 << 22);
    const auto far = *NurbsSurface::create(near.knotsU(), near.knotsV(), points);
    const double u = 0.3 * near.knotsU().domainStart() + 0.7 * near.knotsU().domainEnd();
    const double v = 0.6 * near.knotsV().domainStart() + 0.4 * near.knotsV().domainEnd();
    const SurfacePoint a = evaluate(rounded, u, v);
    const SurfacePoint b = evaluate(far, u, v);
    for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(a.du[c], b.du[c]) << "derivatives do not know where the part stands";
        EXPECT_EQ(a.duv[c], b.duv[c]);
    }
}

TEST(Evaluation, TakesParametersOutsideTheDomainToItsBorder)
{
    std::mt19937 random(5);
    const NurbsSurface surface =
        testing::randomSurface(random, {.degreeU = 3, .degreeV = 2, .rational = true, .clamped = false});
    const double u = surface.knotsU().domainEnd();
    const double v = surface.knotsV().domainStart();
    EXPECT_EQ(evaluate(surface, u + 7, v - 3).position, evaluate(surface, u, v).position);
}

}  // namespace
}  // namespace knotspan
