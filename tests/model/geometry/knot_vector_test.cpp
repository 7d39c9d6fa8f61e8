#include <limits>

#include <gtest/gtest.h>

#include "model/geometry/knot_vector.h"

namespace knotspan {
namespace {

std::string refusal(int degree, std::vector<double> knots)
{
    const auto result = KnotVector::create(degree, std::move(knots));
    return result ? "" : result.error().sentence();
}

TEST(KnotVector, TakesClampedAndUnclampedKnots)
{
    EXPECT_EQ(refusal(2, {0, 0, 0, 1, 2, 2, 3, 3, 3}), "");
    EXPECT_EQ(refusal(3, {0, 1, 2, 3, 4, 5, 6, 7, 8}), "");
    EXPECT_EQ(refusal(1, {0, 0, 1, 1}), "");
    EXPECT_EQ(refusal(15, std::vector<double>(KnotVector::clampedUniform(15, 3).values())), "");
}

TEST(KnotVector, RefusesDegreesOutsideOneToFifteenWithASentence)
{
    EXPECT_EQ(refusal(0, {0, 1}), "Degree 0 is not between 1 and 15.");
    EXPECT_EQ(refusal(16, std::vector<double>(40)), "Degree 16 is not between 1 and 15.");
}

TEST(KnotVector, RefusesTooFewKnotsWithASentence)
{
    EXPECT_EQ(refusal(3, {0, 0, 0, 1, 1, 1}), "Degree 3 needs at least 8 knots, but there are 6.");
    EXPECT_EQ(refusal(1, {}), "Degree 1 needs at least 4 knots, but there are 0.");
}

TEST(KnotVector, RefusesDecreasingKnotsWithASentence)
{
    EXPECT_EQ(refusal(1, {0, 0, 0.6, 0.5, 1, 1}), "Knot 3 is smaller than the one before it.");
}

TEST(KnotVector, RefusesKnotsThatAreNoNumbersWithASentence)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refusal(1, {0, nan, 1, 1}), "Knot 1 is not a finite number.");
    EXPECT_EQ(refusal(1, {0, 0, 1, infinity}), "Knot 3 is not a finite number.");
    EXPECT_EQ(refusal(1, {-1.7e308, -1.7e308, 1.7e308, 1.7e308}),
              "The knots reach further than a number can tell.");
}

TEST(KnotVector, RefusesKnotsThatStandTooOftenWithASentence)
{
    EXPECT_EQ(refusal(2, {0, 0, 0, 1, 1, 1, 2, 2, 2}),
              "Knot 3 stands there 3 times, but degree 2 allows 2 inside.");
    EXPECT_EQ(refusal(1, {0, 0, 0, 1, 2, 2}),
              "Knot 0 stands there 3 times, but degree 1 allows 2 at an end.");
}

TEST(KnotVector, RefusesADomainWithoutLengthWithASentence)
{
    const char* const sentence =
        "The knots leave the surface no length: its first and last parameter are the same.";
    EXPECT_EQ(refusal(1, {0, 0, 0, 0}), sentence);
    EXPECT_EQ(refusal(2, {0, 1, 2, 2, 3, 4}), sentence);
}

TEST(KnotVector, FindsTheSpanOnTheRightOfAnInteriorKnotAndTheLastAtTheEnd)
{
    const auto knots = *KnotVector::create(2, {0, 0, 0, 1, 1, 4, 5, 5, 5});
    EXPECT_EQ(knots.spans(), (std::vector<int>{2, 4, 5}));
    EXPECT_EQ(knots.findSpan(0), 2);
    EXPECT_EQ(knots.findSpan(0.999), 2);
    EXPECT_EQ(knots.findSpan(1), 4);
    EXPECT_EQ(knots.findSpan(4), 5);
    EXPECT_EQ(knots.findSpan(5), 5);
    EXPECT_EQ(knots.findSpan(-7), 2);
    EXPECT_EQ(knots.findSpan(99), 5);
    EXPECT_EQ(knots.findSpan(std::numeric_limits<double>::quiet_NaN()), 2);
}

TEST(KnotVector, TellsTheDomainOfAnUnclampedVector)
{
    const auto knots = *KnotVector::create(3, {0, 1, 2, 3, 4, 5, 6, 7, 8});
    EXPECT_EQ(knots.domainStart(), 3);
    EXPECT_EQ(knots.domainEnd(), 5);
    EXPECT_EQ(knots.spans(), (std::vector<int>{3, 4}));
    EXPECT_EQ(knots.findSpan(1), 3);
    EXPECT_EQ(knots.findSpan(7), 4);
}

}  // namespace
}  // namespace knotspan
