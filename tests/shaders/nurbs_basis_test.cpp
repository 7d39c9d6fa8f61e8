// The shader's own text, compiled as C++, in double and float against 50 digits and, for whole surfaces, the
// reference.
#include <algorithm>
#include <array>
#include <cmath>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "renderer/scene/patch_table.h"
#include "shaders/shared/nurbs_surface.glsl"
#include "tests/random_surface.h"
#include "tests/shaders/exact_basis.h"

namespace knotspan::testing {
namespace {

using Digits50 = boost::multiprecision::cpp_bin_float_50;

// Of a float, and of a double: half of what follows 1.
template <class Real>
constexpr double kUnit = std::numeric_limits<Real>::epsilon() / 2;

// How far a curve can be off whose control points are no further than 1 from the origin: sums of the
// functions' errors. Slopes as a share of 2 p, the largest derivative by t that such a curve can have, second
// derivatives of 4 p (p - 1), likewise. In units.
struct BasisError {
    double value = 0;
    double slope = 0;
    double bend = 0;
};

template <Evaluator evaluator, class Real>
void look(BasisError& worst, const KnotVector& knots, int span, Real t)
{
    const int p = knots.degree();
    std::vector<Real> table;
    appendSpanTable(evaluator, knots, span, table);
    const TableSource<Real> source{table.data()};
    const Digits50 start(knots[span]);
    const Digits50 length = Digits50(knots[span + 1]) - start;
    const auto expected = exactBasis<Digits50>(knots, span, start + Digits50(t) * length);
    const auto basis = gpu::evaluateBasis<evaluator, Real>(source, 0, p, t);
    const auto values = gpu::evaluateBasisValues<evaluator, Real>(source, 0, p, t);
    Digits50 value = 0;
    Digits50 valueAlone = 0;
    Digits50 slope = 0;
    Digits50 bend = 0;
    const auto bent = gpu::evaluateBentBasis<evaluator, Real>(source, 0, p, t);
    for (size_t k = 0; k <= static_cast<size_t>(p); ++k) {
        value += abs(Digits50(basis.value[k]) - expected.value[k]);
        valueAlone += abs(Digits50(values.value[k]) - expected.value[k]);
        slope += abs(Digits50(basis.slope[k]) - expected.slope[k] * length);
        bend += abs(Digits50(bent.bend[k]) - expected.bend[k] * length * length);
    }
    const Digits50 larger = std::max(value, valueAlone);
    worst.value = std::max(worst.value, static_cast<double>(larger) / kUnit<Real>);
    worst.slope = std::max(worst.slope, static_cast<double>(slope) / (2 * p * kUnit<Real>));
    worst.bend = std::max(worst.bend,
                          static_cast<double>(bend) / (4 * std::max(1, p * (p - 1)) * kUnit<Real>));
}

template <Evaluator evaluator, class Real>
BasisError worstBasisError(int degree)
{
    std::mt19937 random(static_cast<unsigned>(degree));
    std::uniform_real_distribution<Real> unit(0, 1);
    BasisError worst;
    for (const double spanRatio : {1.0, 1e3, 1e6})
        for (int trial = 0; trial < 2; ++trial) {
            const NurbsSurface surface = randomSurface(random, {degree, 1, 5, false, 0.0, spanRatio});
            const KnotVector& knots = surface.knotsU();
            for (const int span : knots.spans())
                for (const Real t : {Real(0), Real(1e-4), unit(random), unit(random), Real(0.5), Real(1)})
                    look<evaluator>(worst, knots, span, t);
        }
    // A single span, a Bezier curve: the longest coefficients.
    const KnotVector single = KnotVector::clampedUniform(degree, 1);
    for (int k = 0; k <= 16; ++k)
        look<evaluator>(worst, single, degree, Real(k) / 16);
    return worst;
}

// What holds for an evaluator at a degree, in units. That of the powers grows as their coefficients do; the
// errors of the recursions grow with their steps.
double bound(Evaluator evaluator, int degree, Precision precision)
{
    switch (evaluator) {
    case Evaluator::power:
        return std::max(16.0, 0.5 * std::pow(3.0, degree));
    case Evaluator::bernstein:
        return 14;
    default:
        return degree <= (precision == Precision::float32 ? 9 : 8) ? 16 : 32;
    }
}

template <Evaluator evaluator, class Real>
void expectBounded(const char* type)
{
    constexpr Precision precision = sizeof(Real) == sizeof(float) ? Precision::float32 : Precision::float64;
    std::string values;
    std::string slopes;
    for (int degree = 1; degree <= kMaxDegree; ++degree) {
        const BasisError worst = worstBasisError<evaluator, Real>(degree);
        EXPECT_LT(worst.value, bound(evaluator, degree, precision)) << type << ", degree " << degree;
        EXPECT_LT(worst.slope, bound(evaluator, degree, precision)) << type << ", degree " << degree;
        EXPECT_LT(worst.bend, bound(evaluator, degree, precision)) << type << ", degree " << degree;
        char text[32];
        std::snprintf(text, sizeof(text), "%.3g ", worst.value);
        values += text;
        std::snprintf(text, sizeof(text), "%.3g ", worst.slope);
        slopes += text;
    }
    ::testing::Test::RecordProperty(std::string("values_") + type, values);
    ::testing::Test::RecordProperty(std::string("slopes_") + type, slopes);
}

#define KNOTSPAN_TEST(number, name, ...)                                      \
    TEST(ShaderBasis, ByTheEvaluator_##name##_IsWithinItsBoundForEveryDegree) \
    {                                                                         \
        expectBounded<Evaluator::name, float>("float");                       \
        expectBounded<Evaluator::name, double>("double");                     \
    }
KNOTSPAN_EVALUATOR_LIST(KNOTSPAN_TEST)
#undef KNOTSPAN_TEST

TEST(ChosenEvaluator, IsTheWishOrOneThatIsExactAtTheDegree)
{
    for (int degree = 1; degree <= kMaxDegree; ++degree)
        for (const Precision precision : {Precision::float32, Precision::float64}) {
            EXPECT_EQ(chosenEvaluator(Evaluator::stair, degree, precision), Evaluator::stair);
            const Evaluator chosen = chosenEvaluator(Evaluator::automatic, degree, precision);
            EXPECT_NE(chosen, Evaluator::automatic);
            EXPECT_LE(bound(chosen, degree, precision), 16) << "degree " << degree;
        }
}

TEST(Evaluators, AreFoundByTheirNames)
{
    EXPECT_EQ(evaluators().size(), size_t{KNOTSPAN_EVALUATOR_COUNT} + 1);
    for (const EvaluatorInfo& info : evaluators()) {
        EXPECT_EQ(findEvaluator(info.name), info.id);
        EXPECT_EQ(evaluatorInfo(info.id).name, info.name);
        EXPECT_FALSE(info.description.empty());
    }
    EXPECT_EQ(findEvaluator("automatic"), std::nullopt);
    EXPECT_EQ(findEvaluator("cox"), std::nullopt);
}

// Neighbours beyond all that float can tell apart, and the functions still sum to one.
template <Evaluator evaluator>
void expectSums(double ratio)
{
    for (int degree = 1; degree <= kMaxDegree; ++degree) {
        std::vector<double> values(static_cast<size_t>(degree) + 1, 0.0);
        for (int k = 0; k <= degree; ++k)
            values.insert(values.begin() + degree + 1 + k, 1.0 + k * ratio);
        for (int k = 0; k <= degree; ++k)
            values.push_back(1.0 + (2.0 + degree) * ratio);
        const KnotVector knots = KnotVector::create(degree, values).value();
        std::vector<float> table;
        appendSpanTable(evaluator, knots, degree, table);
        const auto basis =
            gpu::evaluateBasis<evaluator, float>(TableSource<float>{table.data()}, 0, degree, 0.37F);
        double sum = 0;
        double slopes = 0;
        for (int k = 0; k <= degree; ++k) {
            sum += static_cast<double>(basis.value[k]);
            slopes += static_cast<double>(basis.slope[k]);
        }
        EXPECT_NEAR(sum, 1.0, bound(evaluator, degree, Precision::float32) * kUnit<float>)
            << degree << ", " << ratio;
        EXPECT_NEAR(slopes, 0.0, 2 * degree * bound(evaluator, degree, Precision::float32) * kUnit<float>)
            << degree << ", " << ratio;
    }
}

TEST(ShaderBasis, SumsToOneAndItsSlopesToZeroBesideNeighboursOfAnyLength)
{
    for (const double ratio : {1e-12, 1.0, 1e9, 1e30, 1e60}) {
#define KNOTSPAN_ONE(number, name, ...) expectSums<Evaluator::name>(ratio);
        KNOTSPAN_EVALUATOR_LIST(KNOTSPAN_ONE)
#undef KNOTSPAN_ONE
    }
}

struct SurfaceSource {
    std::vector<float> tables;
    std::vector<gpu::vec4> points;

    [[nodiscard]] float spanTable(std::uint32_t index) const { return tables[index]; }
    [[nodiscard]] const gpu::vec4& controlPoint(std::uint32_t index) const { return points[index]; }
};

TEST(ShaderSurface, GivesTheReferencesPointAndTangents)
{
    std::mt19937 random(5);
    const NurbsSurface surface = randomSurface(random, {3, 4, 3, true, 1e6, 10.0});
    const PointFrame frame = PointFrame::of(surface);
    const auto table = makePatchTable<float>(surface, Evaluator::stair);
    const SurfaceSource source{table.spanTables, packPoints<float>(frame, surface.controlPoints())};
    const auto names = ksQuads(surface);
    ASSERT_EQ(names.size(), table.ksquads.size());
    for (size_t k = 0; k < names.size(); ++k) {
        const auto& record = table.ksquads[k];
        const auto bu = gpu::evaluateBasis<Evaluator::stair, float>(source, record.spanU, 3, 0.25F);
        const auto bv = gpu::evaluateBasis<Evaluator::stair, float>(source, record.spanV, 4, 0.75F);
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
