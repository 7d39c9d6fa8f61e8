#include "model/core/totals.h"

#include <gtest/gtest.h>

#include "model/core/space.h"

namespace knotspan {
namespace {

struct Sum {
    int value = 0;

    void add(const Sum& other) { value += other.value; }
};

TEST(Totals, AreKeptUpWhileSingleValuesChange)
{
    for (const int count : {1, 2, 3, 7, 8, 9, 100}) {
        std::vector<Sum> values(static_cast<size_t>(count));
        Totals<Sum> totals(values);
        for (int step = 0; step < 200; ++step) {
            const auto place = static_cast<size_t>(step * 37 % count);
            values[place].value = step;
            totals.set(place, values[place]);
            int sum = 0;
            for (const Sum& one : values)
                sum += one.value;
            ASSERT_EQ(totals.all().value, sum) << count;
            EXPECT_EQ(totals[place].value, step);
        }
    }
}

TEST(Totals, OfNothingAreNothing)
{
    EXPECT_TRUE(Totals<Box>().all().isEmpty());
    EXPECT_TRUE(Totals<Box>(std::vector<Box>()).all().isEmpty());
}

// Of a thousand boxes in a row those around one place, without asking most others.
TEST(Totals, AreSearchedForWhatSatisfiesATest)
{
    std::vector<Box> boxes;
    for (int k = 0; k < 1000; ++k)
        boxes.push_back({Vec3(k, 0, 0), Vec3(k + 1.5, 1, 1)});
    const Totals<Box> totals(boxes);
    int asked = 0;
    std::vector<size_t> found;
    totals.visitWhere(
        [&](const Box& box) {
            ++asked;
            return box.low.x <= 500.2 && box.high.x >= 500.2;
        },
        [&](size_t k) { found.push_back(k); });
    EXPECT_EQ(found, (std::vector<size_t>{499, 500}));
    EXPECT_LT(asked, 50);
}

}  // namespace
}  // namespace knotspan
