#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "model/geometry/banded_system.h"

namespace knotspan {
namespace {

TEST(BandedSystem, SolvesWhatItIsGiven)
{
    std::mt19937 random(61);
    std::uniform_real_distribution<double> number(-1, 1);
    for (const int band : {0, 1, 4, 50}) {
        constexpr int kSize = 30;
        std::vector<std::vector<double>> matrix(kSize, std::vector<double>(kSize, 0.0));
        BandedSystem system(kSize, band);
        std::vector<double> expected(kSize);
        std::vector<double> right(kSize, 0.0);
        for (int i = 0; i < kSize; ++i) {
            expected[static_cast<size_t>(i)] = number(random);
            for (int j = std::max(0, i - band); j <= i; ++j) {
                const double value = i == j ? 40 : number(random);
                matrix[static_cast<size_t>(i)][static_cast<size_t>(j)] = value;
                matrix[static_cast<size_t>(j)][static_cast<size_t>(i)] = value;
                system.add(i, j, value);
            }
        }
        for (size_t i = 0; i < kSize; ++i)
            for (size_t j = 0; j < kSize; ++j)
                right[i] += matrix[i][j] * expected[j];
        ASSERT_TRUE(system.factor());
        const std::vector<double> found = system.solve(right);
        ASSERT_EQ(found.size(), expected.size());
        for (size_t i = 0; i < kSize; ++i)
            EXPECT_NEAR(found[i], expected[i], 1e-14);
    }
}

TEST(BandedSystem, FindsNoSolutionOfAMatrixThatIsNotPositiveDefinite)
{
    BandedSystem system(2, 1);
    system.add(0, 0, 1);
    system.add(1, 0, 2);
    system.add(1, 1, 1);
    EXPECT_FALSE(system.factor());
}

}  // namespace
}  // namespace knotspan
