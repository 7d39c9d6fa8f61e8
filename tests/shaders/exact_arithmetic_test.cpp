// The evaluators in exact fractions: their texts and their tables are right where no rounding hides a
// mistake.
#include <random>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include "model/geometry/basis_evaluators.h"
#include "model/geometry/evaluator_tables.h"
#include "shaders/shared/nurbs_basis.glsl"
#include "tests/shaders/exact_basis.h"

namespace knotspan::testing {
namespace {

using Fraction = boost::multiprecision::cpp_rational;

std::vector<Fraction> tableOf(Evaluator evaluator, const KnotVector& knots, int span)
{
    const auto differences = evaluator_tables::differences(knots, span, Fraction(1e300));
    switch (evaluator) {
#define KNOTSPAN_ONE(number, name, ...) \
    case Evaluator::name:               \
        return evaluator_tables::name(knots.degree(), differences);
        KNOTSPAN_EVALUATOR_LIST(KNOTSPAN_ONE)
#undef KNOTSPAN_ONE
    case Evaluator::automatic:
        break;
    }
    return {};
}

// Uneven whole knots, first with ends of multiplicity p + 1, and an interior knot of the given multiplicity.
KnotVector knotsWith(std::mt19937& random, int degree, int multiplicity, bool clamped)
{
    std::uniform_int_distribution<int> step(1, 9);
    std::vector<double> values;
    double at = 0;
    for (int k = 0; k <= degree; ++k)
        values.push_back(clamped ? at : at += step(random));
    for (const int times : {1, multiplicity, 1}) {
        at += step(random);
        values.insert(values.end(), static_cast<size_t>(times), at);
    }
    at += step(random);
    for (int k = 0; k <= degree; ++k)
        values.push_back(clamped ? at : at += step(random));
    return KnotVector::create(degree, values).value();
}

template <Evaluator evaluator>
void expectExact(const KnotVector& knots)
{
    const int p = knots.degree();
    for (const int span : knots.spans()) {
        const std::vector<Fraction> table = tableOf(evaluator, knots, span);
        ASSERT_EQ(table.size(), spanTableSize(evaluator, p));
        const TableSource<Fraction> source{table.data()};
        for (const Fraction& t : {Fraction(0), Fraction(2, 7), Fraction(1)}) {
            const Fraction start(knots[span]);
            const Fraction length = Fraction(knots[span + 1]) - start;
            const auto expected = exactBasis<Fraction>(knots, span, start + t * length);
            const auto values = gpu::evaluateBasisValues<evaluator, Fraction>(source, 0, p, t);
            const auto both = gpu::evaluateBasis<evaluator, Fraction>(source, 0, p, t);
            const auto bent = gpu::evaluateBentBasis<evaluator, Fraction>(source, 0, p, t);
            for (size_t k = 0; k <= static_cast<size_t>(p); ++k) {
                EXPECT_EQ(bent.value[k], expected.value[k]) << "degree " << p << ", span " << span;
                EXPECT_EQ(bent.slope[k], expected.slope[k] * length) << "degree " << p << ", span " << span;
                EXPECT_EQ(bent.bend[k], expected.bend[k] * length * length)
                    << "degree " << p << ", span " << span;
                EXPECT_EQ(values.value[k], expected.value[k]) << "degree " << p << ", span " << span;
                EXPECT_EQ(both.value[k], expected.value[k]) << "degree " << p << ", span " << span;
                EXPECT_EQ(both.slope[k], expected.slope[k] * length) << "degree " << p << ", span " << span;
            }
        }
    }
}

template <Evaluator evaluator>
void expectExactOnAllKnots()
{
    std::mt19937 random(3);
    for (int degree = 1; degree <= 9; ++degree)
        for (int multiplicity = 1; multiplicity <= degree; ++multiplicity)
            for (const bool clamped : {true, false})
                expectExact<evaluator>(knotsWith(random, degree, multiplicity, clamped));
}

#define KNOTSPAN_TEST(number, name, ...)                                      \
    TEST(ExactArithmetic, HasTheEvaluator_##name##_EqualCoxDeBoorAtEveryKnot) \
    {                                                                         \
        expectExactOnAllKnots<Evaluator::name>();                             \
    }
KNOTSPAN_EVALUATOR_LIST(KNOTSPAN_TEST)
#undef KNOTSPAN_TEST

}  // namespace
}  // namespace knotspan::testing
