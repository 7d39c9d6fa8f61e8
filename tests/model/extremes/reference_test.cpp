// The double reference at the extremes.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/analysis/curvature.h"
#include "model/geometry/evaluation.h"
#include "tests/model/extremes/exact_points.h"
#include "tests/model/extremes/figures.h"

namespace knotspan {
namespace {

using testing::ExactKSQuad;
using testing::ExactPoint;
using testing::FigureTable;
using testing::relativeError;

constexpr double kUnit = 0x1p-52;

// Positions are absolute: half a unit of the result's own last place is its own.
double positionUnits(const Vec3& found, const ExactPoint& at, double size)
{
    const testing::RealVec3& exact = at.value.position;
    const double wrong = relativeError(found, exact, size) / kUnit;
    const double last = 0.5 * std::max({std::abs(found.x), std::abs(found.y), std::abs(found.z)}) / size;
    return std::max(0.0, wrong - last);
}

TEST(ReferenceAtTheExtremes, IsRightToTheLastDigits)
{
    FigureTable table({"position, 2^-52", "du", "dv", "duu", "duv", "dvv"});
    for (const auto& row : testing::extremeSurfaces()) {
        SCOPED_TRACE(row.name);
        table.beginRow(row.name);
        for (const ExactKSQuad& ksquad : testing::exactKSQuads(row, testing::Exactly::u))
            for (const ExactPoint& at : ksquad.points) {
                const SurfacePoint found = evaluate(row.surface, at.u, at.v);
                table.add(0, positionUnits(found.position, at, ksquad.size));
                table.add(1, relativeError(found.du, at.value.du, ksquad.du));
                table.add(2, relativeError(found.dv, at.value.dv, ksquad.dv));
                table.add(3, relativeError(found.duu, at.value.duu, ksquad.duu));
                table.add(4, relativeError(found.duv, at.value.duv, ksquad.duv));
                table.add(5, relativeError(found.dvv, at.value.dvv, ksquad.dvv));
            }
        EXPECT_LE(table.worst(0), row.reference.position) << "position";
        if (row.onlyFinite)
            continue;
        for (size_t column = 1; column <= 2; ++column)
            EXPECT_LE(table.worst(column), row.reference.derivative) << "first derivative";
        for (size_t column = 3; column <= 5; ++column)
            EXPECT_LE(table.worst(column), row.reference.secondDerivative) << "second derivative";
    }
    table.report();
}

// Tangents nearer to parallel than rounding tells span no plane.
constexpr double kTold = 1e11;

TEST(ReferenceAtTheExtremes, HasUnitNormalsThatAreTheExactOnesOrTheirLimits)
{
    FigureTable table({"normal, of its sensitivity", "limit, radians"});
    for (const auto& row : testing::extremeSurfaces()) {
        if (row.onlyFinite)
            continue;
        SCOPED_TRACE(row.name);
        table.beginRow(row.name);
        for (const ExactKSQuad& ksquad : testing::exactKSQuads(row, testing::Exactly::u))
            for (const ExactPoint& at : ksquad.points) {
                const SurfaceNormal found = evaluateNormal(row.surface, at.u, at.v);
                EXPECT_NEAR(glm::length(found.direction), 1, 1e-15);
                if (at.isLimit) {
                    EXPECT_EQ(found.exists, at.normal.has_value()) << at.u << ", " << at.v;
                    if (at.normal)
                        table.add(1, testing::angleBetween(found.direction, *at.normal));
                } else if (at.normalSensitivity < kTold) {
                    EXPECT_TRUE(found.exists);
                    table.add(0, testing::angleBetween(found.direction, *at.normal) / at.normalSensitivity);
                }
            }
        EXPECT_LE(table.worst(0), row.reference.normal);
        EXPECT_LE(table.worst(1), row.reference.limit);
    }
    table.report();
}

// The second fundamental form's eigenvalues, by the quadratic formula that 50 digits can afford.
std::array<double, 2> exactCurvatures(const testing::PrecisePoint& at, const testing::RealVec3& normal)
{
    using testing::dot;
    using testing::Real;
    const Real e = dot(at.du, at.du);
    const Real f = dot(at.du, at.dv);
    const Real g = dot(at.dv, at.dv);
    const Real l = dot(at.duu, normal);
    const Real m = dot(at.duv, normal);
    const Real n = dot(at.dvv, normal);
    const Real area = e * g - f * f;
    const Real gauss = (l * n - m * m) / area;
    const Real mean = (l * g - 2 * m * f + n * e) / (2 * area);
    const Real half = sqrt(std::max(Real(0), Real(mean * mean - gauss)));
    return {static_cast<double>(mean + half), static_cast<double>(mean - half)};
}

// How much curvature the KSQuad's largest second derivatives would make here.
double curvatureScale(const ExactKSQuad& ksquad, const ExactPoint& at)
{
    const double u = static_cast<double>(testing::length(at.value.du));
    const double v = static_cast<double>(testing::length(at.value.dv));
    const double sine = static_cast<double>(testing::length(testing::cross(at.value.du, at.value.dv)) /
                                            (testing::length(at.value.du) * testing::length(at.value.dv)));
    return (ksquad.duu / u / u + ksquad.duv / u / v + ksquad.dvv / v / v) * (1 + at.normalSensitivity) /
           (sine * sine);
}

TEST(ReferenceAtTheExtremes, HasThePrincipalCurvatures)
{
    FigureTable table({"principal curvatures, of the second derivatives'"});
    for (const auto& row : testing::extremeSurfaces()) {
        if (row.onlyFinite)
            continue;
        SCOPED_TRACE(row.name);
        table.beginRow(row.name);
        for (const ExactKSQuad& ksquad : testing::exactKSQuads(row, testing::Exactly::u))
            for (const ExactPoint& at : ksquad.points) {
                const auto found = curvature(evaluate(row.surface, at.u, at.v));
                if (at.isLimit || !(at.normalSensitivity < 1e9))
                    continue;
                const auto exact = exactCurvatures(at.value, *at.normal);
                // Second derivatives beyond the range of double are 0.
                if (!(std::abs(exact[0]) < 1e150) || !(std::abs(exact[1]) < 1e150) || ksquad.duu < 1e-290)
                    continue;
                ASSERT_TRUE(found);
                const double scale = curvatureScale(ksquad, at);
                table.add(0, std::abs(found->largest - exact[0]) / scale);
                table.add(0, std::abs(found->smallest - exact[1]) / scale);
            }
        EXPECT_LE(table.worst(0), std::max(row.reference.secondDerivative, row.reference.normal));
    }
    table.report();
}

bool isFinite(const Vec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

TEST(ReferenceAtTheExtremes, IsFiniteAtAnyParameter)
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    for (const auto& row : testing::extremeSurfaces()) {
        SCOPED_TRACE(row.name);
        const KnotVector& knotsU = row.surface.knotsU();
        const KnotVector& knotsV = row.surface.knotsV();
        for (const double u : {kNone, -kInfinity, kInfinity, -1e308, 1e308, 0.0, knotsU.domainEnd()})
            for (const double v : {kNone, kInfinity, knotsV.domainStart(), 0.0}) {
                const SurfacePoint found = evaluate(row.surface, u, v);
                EXPECT_TRUE(isFinite(found.position));
                EXPECT_TRUE(isFinite(found.du) && isFinite(found.dv));
                EXPECT_TRUE(isFinite(found.duu) && isFinite(found.duv) && isFinite(found.dvv));
                EXPECT_NEAR(glm::length(evaluateNormal(row.surface, u, v).direction), 1, 1e-15);
                EXPECT_EQ(found.position,
                          evaluate(row.surface, knotsU.inDomain(u), knotsV.inDomain(v)).position);
            }
        EXPECT_EQ(evaluate(row.surface, kNone, kInfinity).position,
                  evaluate(row.surface, knotsU.domainStart(), knotsV.domainEnd()).position);
    }
}

}  // namespace
}  // namespace knotspan
