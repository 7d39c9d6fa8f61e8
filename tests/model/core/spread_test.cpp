#include "model/core/spread.h"

#include <gtest/gtest.h>

namespace knotspan {
namespace {

TEST(Spread, OfOneMeasurementIsThatMeasurement)
{
    const Spread spread = spreadOf({2.5});
    EXPECT_EQ(spread.min, 2.5);
    EXPECT_EQ(spread.median, 2.5);
    EXPECT_EQ(spread.max, 2.5);
}

TEST(Spread, OfAnEvenNumberHasTheMeanOfTheMiddleTwoInTheMiddle)
{
    const Spread spread = spreadOf({9, 1, 4, 2});
    EXPECT_EQ(spread.min, 1);
    EXPECT_EQ(spread.median, 3);
    EXPECT_EQ(spread.max, 9);
}

}  // namespace
}  // namespace knotspan
