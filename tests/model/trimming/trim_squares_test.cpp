// The squares that answer for most places of a KSQuad: what they say holds, and they are as fine as loops ask
// for.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "model/trimming/trim_words.h"
#include "tests/model/trimming/loop_samples.h"

namespace knotspan::testing {
namespace {

// All squares of a record, finest first, as trimming.glsl describes them.
struct Squares {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::vector<std::uint32_t> sides;

    [[nodiscard]] double nearShare() const
    {
        return static_cast<double>(std::count(sides.begin(), sides.end(), TRIM_NEAR)) /
               static_cast<double>(sides.size());
    }
};

std::vector<Squares> squaresOf(const TrimIndex& index, std::uint32_t ksquad)
{
    const auto& words = index.words();
    const std::uint32_t record = words[ksquad];
    const std::uint32_t shape = words[record];
    size_t at = record + (shape >> 6U);
    std::vector<Squares> levels;
    std::uint32_t columns = 16U << (shape & 7U);
    std::uint32_t rows = 16U << (shape >> 3U & 7U);
    while (levels.empty() || levels.back().columns + levels.back().rows > 32) {
        Squares level{columns, rows, {}};
        for (std::uint32_t k = 0; k < columns * rows; ++k)
            level.sides.push_back(words.at(at + k / 16) >> (2 * (k % 16)) & 3U);
        at += columns * rows / 16;
        columns = std::max(columns / 2, 16U);
        rows = std::max(rows / 2, 16U);
        levels.push_back(std::move(level));
    }
    return levels;
}

TrimLoop rectangle(const Vec2& low, const Vec2& high)
{
    return {false, {polyline({low, {low.x, high.y}, high, {high.x, low.y}, low})}};
}

// In one KSQuad of [-1, 3] x [10, 12].
TrimIndex indexOf(const std::vector<TrimLoop>& loops)
{
    return TrimIndex::create(TrimRegion(loops, flatSurface({-1, 3}, {10, 12}))).value();
}

std::vector<TrimLoop> slots(int count)
{
    std::vector<TrimLoop> loops;
    for (int k = 0; k < count; ++k) {
        const double from = -1 + 4.0 * (k + 0.25) / count;
        loops.push_back(rectangle({from, 10.3}, {from + 2.0 / count, 11.7}));
    }
    return loops;
}

TEST(TrimSquares, SayWhatHoldsOfAllTheirPlaces)
{
    const std::vector<TrimLoop> loops{{true, {circle({0.9, 11.05}, 0.83)}},
                                      {false, {circle({1.1, 11.2}, 0.3, false)}},
                                      rectangle({0.31, 10.7}, {0.62, 10.9})};
    const TrimRegion region(loops, flatSurface({-1, 3}, {10, 12}));
    const auto levels = squaresOf(TrimIndex::create(region).value(), 0);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0, 1);
    int sure = 0;
    for (int k = 0; k < 20000; ++k) {
        const Vec2 t(share(random), share(random));
        for (const Squares& level : levels) {
            const auto column = static_cast<std::uint32_t>(t.x * level.columns);
            const auto row = static_cast<std::uint32_t>(t.y * level.rows);
            const std::uint32_t side = level.sides[row * level.columns + column];
            if (side == TRIM_NEAR)
                continue;
            ++sure;
            EXPECT_EQ(side == TRIM_INSIDE, region.contains(-1 + 4 * t.x, 10 + 2 * t.y)) << t.x << " " << t.y;
        }
    }
    EXPECT_GT(sure, 20000);
}

// 16 along each side would all be cut by one.
TEST(TrimSquares, OfAFaceWithManySlotsAreFiner)
{
    const auto levels = squaresOf(indexOf(slots(40)), 0);
    EXPECT_GE(levels.front().columns, 128U);
    EXPECT_LT(levels.front().nearShare(), 0.3);
    EXPECT_GT(levels.back().nearShare(), 0.6);
    EXPECT_EQ(levels.back().columns, 16U);
    EXPECT_EQ(levels.back().rows, 16U);
}

TEST(TrimSquares, AreNoMoreThanTheCurvesAreWorth)
{
    for (const int count : {1, 2, 5, 20, 100, 400}) {
        const TrimIndex index = indexOf(slots(count));
        const std::uint32_t record = index.words()[0];
        const size_t curves = index.words()[record] >> 6U;
        // The finest ones four times the curves' words, all others together less than that again.
        EXPECT_LE(index.words().size() - record - curves, std::max<size_t>(8 * curves, 16)) << count;
    }
}

}  // namespace
}  // namespace knotspan::testing
