// The shader's own text, compiled as C++, in double and float against the reference.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "model/geometry/basis.h"
#include "model/geometry/evaluation.h"
#include "renderer/scene/patch_table.h"
#include "tests/random_surface.h"

// What a stage binds, a caller passes.
#define spanKnot(index) static_cast<Real>(source.knots[index])
#define controlPoint(index) source.points[index]
#include "shaders/shared/nurbs_surface.glsl"
#undef spanKnot
#undef controlPoint

namespace knotspan::testing {
namespace {

template <class Real>
struct Source {
    std::vector<float> knots;
    std::vector<glm::vec<4, Real>> points;
};

// The largest errors of values, and of slopes as a share of the degree (no slope by t is larger), in units of
// 2^-24.
struct BasisError {
    double value = 0;
    double slope = 0;
};

template <class Real>
BasisError worstBasisError(int degree, double spanRatio)
{
    constexpr double kUnit = 1.0 / 16777216.0;
    std::mt19937 random(static_cast<unsigned>(degree));
    BasisError worst;
    for (int trial = 0; trial < 20; ++trial) {
        const NurbsSurface surface = randomSurface(random, {degree, 1, 5, false, 0.0, spanRatio});
        const KnotVector& knots = surface.knotsU();
        for (const int span : knots.spans()) {
            Source<Real> source;
            appendSpanKnots(knots, span, source.knots);
            for (const float t : {0.0F, 0.125F, 0.5F, 0.8125F, 1.0F}) {
                const double length = knots[span + 1] - knots[span];
                const auto expected =
                    basisDerivatives(knots, span, knots[span] + static_cast<double>(t) * length);
                const auto basis = gpu::evaluateBasis<Real>(source, 0, degree, static_cast<Real>(t));
                for (size_t k = 0; k <= static_cast<size_t>(degree); ++k) {
                    const double value = std::abs(static_cast<double>(basis.value[k]) - expected[0][k]);
                    const double slope =
                        std::abs(static_cast<double>(basis.slope[k]) - expected[1][k] * length);
                    worst.value = std::max(worst.value, value / kUnit);
                    worst.slope = std::max(worst.slope, slope / (degree * kUnit));
                }
            }
        }
    }
    return worst;
}

TEST(ShaderBasis, InFloatIsWithinAFewUnitsOfTheReferenceForEveryDegree)
{
    for (int degree = 1; degree <= kMaxDegree; ++degree) {
        const BasisError worst = worstBasisError<float>(degree, 1e3);
        EXPECT_LT(worst.value, 16) << "degree " << degree;
        EXPECT_LT(worst.slope, 16) << "degree " << degree;
    }
}

// The knots are floats on the device: in double only their rounding is left.
TEST(ShaderBasis, InDoubleIsLimitedByTheRoundedKnotsAlone)
{
    for (int degree = 1; degree <= kMaxDegree; ++degree) {
        const BasisError worst = worstBasisError<double>(degree, 1e3);
        EXPECT_LT(worst.value, 4) << "degree " << degree;
        EXPECT_LT(worst.slope, 4) << "degree " << degree;
    }
}

TEST(ShaderBasis, SumsToOneAndItsSlopesToZero)
{
    std::mt19937 random(11);
    for (int degree = 1; degree <= kMaxDegree; ++degree) {
        const NurbsSurface surface = randomSurface(random, {degree, 1, 4, false, 0.0, 1e6});
        Source<float> source;
        appendSpanKnots(surface.knotsU(), surface.knotsU().spans()[1], source.knots);
        const auto basis = gpu::evaluateBasis<float>(source, 0, degree, 0.37F);
        double sum = 0;
        double slopes = 0;
        for (int k = 0; k <= degree; ++k) {
            sum += static_cast<double>(basis.value[k]);
            slopes += static_cast<double>(basis.slope[k]);
        }
        EXPECT_NEAR(sum, 1.0, 1e-6);
        EXPECT_NEAR(slopes, 0.0, 4e-6 * degree);
    }
}

TEST(ShaderSurface, GivesTheReferencesPointAndTangents)
{
    std::mt19937 random(5);
    const NurbsSurface surface = randomSurface(random, {3, 4, 3, true, 1e6, 10.0});
    const PointFrame frame = PointFrame::of(surface);
    const PatchTable table = makePatchTable(surface);
    Source<float> source{table.spanKnots, {}};
    for (const auto& point : packPoints(frame, surface.controlPoints()))
        source.points.push_back(point);
    const auto names = ksQuads(surface);
    ASSERT_EQ(names.size(), table.ksquads.size());
    for (size_t k = 0; k < names.size(); ++k) {
        const auto& record = table.ksquads[k];
        const auto bu = gpu::evaluateBasis<float>(source, record.spanU, 3, 0.25F);
        const auto bv = gpu::evaluateBasis<float>(source, record.spanV, 4, 0.75F);
        const auto at = gpu::contractNet<float>(source, record.firstPoint,
                                                static_cast<gpu::uint>(surface.countV()), 3, 4, bu, bv);
        const KnotVector& ku = surface.knotsU();
        const KnotVector& kv = surface.knotsV();
        const double hu = ku[names[k].spanU + 1] - ku[names[k].spanU];
        const double hv = kv[names[k].spanV + 1] - kv[names[k].spanV];
        const SurfacePoint expected =
            evaluate(surface, ku[names[k].spanU] + 0.25 * hu, kv[names[k].spanV] + 0.75 * hv);
        EXPECT_LT(glm::length(Vec3(at.position) + frame.origin - expected.position), 3e-6);
        EXPECT_LT(glm::length(Vec3(at.du) - expected.du * hu), 3e-5);
        EXPECT_LT(glm::length(Vec3(at.dv) - expected.dv * hv), 3e-5);
    }
}

}  // namespace
}  // namespace knotspan::testing
