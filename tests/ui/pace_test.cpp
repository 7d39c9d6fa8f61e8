// How the tolerance follows the time that frames take, on machines that are told in formulas.
#include "ui/viewport/pace.h"

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace knotspan {
namespace {

constexpr double kAsked = 0.5;

// What a frame at a tolerance takes, in milliseconds.
using Machine = std::function<double(double tolerancePx, int frame)>;

Machine machineOf(double pixelsMs, double trianglesMsAtAsked)
{
    return [=](double px, int) { return pixelsMs + trianglesMsAtAsked * kAsked / px; };
}

Machine noisy(const Machine& machine, unsigned seed)
{
    return [machine, random = std::mt19937(seed)](double px, int frame) mutable {
        std::normal_distribution<double> jitter(1, 0.05);
        const double draw = std::uniform_real_distribution<double>(0, 1)(random);
        return machine(px, frame) * std::clamp(jitter(random), 0.8, 1.2) * (draw < 0.1 ? 2 : 1);
    };
}

struct Gesture {
    std::vector<double> tolerances;  // by frame, the one after the last included
    std::vector<double> ms;          // as the machine takes, noise left out

    [[nodiscard]] double lastMs() const { return ms.back(); }
    [[nodiscard]] double lastPx() const { return tolerances.back(); }
    [[nodiscard]] int changes(size_t from = 0) const
    {
        int count = 0;
        for (size_t k = from + 1; k < tolerances.size(); ++k)
            count += tolerances[k] != tolerances[k - 1] ? 1 : 0;
        return count;
    }
    // The first frame from which on all were in time; as many as there are: none.
    [[nodiscard]] size_t inTimeFrom() const
    {
        size_t first = ms.size();
        while (first > 0 && ms[first - 1] <= Pace::kFrameMs)
            --first;
        return first;
    }
};

Gesture drawn(Pace& pace, const Machine& machine, const Machine& measured, int frames, double asked = kAsked)
{
    Gesture gesture;
    double px = asked;
    for (int frame = 0; frame < frames; ++frame) {
        gesture.tolerances.push_back(px);
        gesture.ms.push_back(machine(px, frame));
        px = pace.afterDrawing({px, measured(px, frame)}, asked);
        EXPECT_GE(px, asked);
        EXPECT_LE(px, std::max(asked, Pace::kLoosestPx));
    }
    gesture.tolerances.push_back(px);
    return gesture;
}

Gesture drawn(const Machine& machine, int frames, double asked = kAsked)
{
    Pace pace;
    return drawn(pace, machine, machine, frames, asked);
}

TEST(Pace, StaysAtTheAskedToleranceWhereFramesComeInTime)
{
    EXPECT_EQ(drawn(machineOf(4, 10), 500).changes(), 0);
}

TEST(Pace, LoosensUntilFramesComeInTimeWhereTrianglesCostIt)
{
    for (const double ms : {18.0, 25.0, 40.0, 100.0, 200.0}) {
        const Gesture gesture = drawn(machineOf(0.5, ms), 200);
        EXPECT_LE(gesture.inTimeFrom(), 40U) << ms;
        EXPECT_LE(gesture.changes(), 4) << ms;
        // No coarser than it has to be, about.
        EXPECT_GE(gesture.lastMs(), 0.5 * Pace::kFrameMs) << ms;
    }
}

TEST(Pace, AnswersALongFrameWithinThree)
{
    const Gesture gesture = drawn(machineOf(1, 100), 200);
    EXPECT_EQ(gesture.tolerances[2], kAsked);
    EXPECT_GT(gesture.tolerances[3], kAsked);
    EXPECT_LE(gesture.inTimeFrom(), 15U);
}

// A software driver: the looser tolerance is tried once, and given back.
TEST(Pace, TakesBackALooserToleranceThatGainsNothingAndDoesNotTryAgain)
{
    for (const double ms : {20.0, 60.0, 300.0}) {
        const Gesture gesture = drawn(machineOf(ms, 0.03 * ms), 1000);
        EXPECT_EQ(gesture.lastPx(), kAsked);
        EXPECT_EQ(gesture.changes(), 2);
        EXPECT_LE(std::count_if(gesture.tolerances.begin(), gesture.tolerances.end(),
                                [](double px) { return px > kAsked; }),
                  11);
    }
}

TEST(Pace, TriesAgainAfterARest)
{
    Pace pace;
    const Machine slow = machineOf(60, 1);
    (void)drawn(pace, slow, slow, 200);
    pace.rest();
    EXPECT_EQ(drawn(pace, slow, slow, 200).changes(), 2);
}

// Of 40 ms pixels take 30: half of the rest is gained, then nothing that is worth it.
TEST(Pace, LoosensAsFarAsItHelpsWherePixelsAndTrianglesCostTheTime)
{
    const Gesture gesture = drawn(machineOf(30, 30), 1000);
    EXPECT_GT(gesture.lastPx(), kAsked);
    EXPECT_LT(gesture.lastPx(), Pace::kLoosestPx);
    EXPECT_LT(gesture.lastMs(), 0.75 * 60);
    EXPECT_LE(gesture.changes(), 6);
    EXPECT_EQ(gesture.changes(100), 0);
}

TEST(Pace, GoesToTheLoosestWhereNothingLessIsEnough)
{
    const Gesture gesture = drawn(machineOf(1, 1000), 500);
    EXPECT_EQ(gesture.lastPx(), Pace::kLoosestPx);
    EXPECT_EQ(gesture.changes(100), 0);
}

TEST(Pace, NeverGoesBeyondAnAskedToleranceThatIsLooserStill)
{
    const Gesture gesture = drawn([](double, int) { return 500.0; }, 300, 12);
    EXPECT_EQ(gesture.changes(), 0);
    EXPECT_EQ(gesture.lastPx(), 12);
}

TEST(Pace, FollowsASceneThatGrowsHeavierAndLighterAgain)
{
    const Machine light = machineOf(1, 10);
    const Machine heavy = machineOf(1, 80);
    const Machine both = [&](double px, int frame) {
        return frame >= 100 && frame < 300 ? heavy(px, frame) : light(px, frame);
    };
    const Gesture gesture = drawn(both, 600);
    EXPECT_EQ(gesture.tolerances[100], kAsked);
    for (size_t frame = 140; frame < 300; ++frame)
        EXPECT_LE(gesture.ms[frame], Pace::kFrameMs) << frame;
    EXPECT_EQ(gesture.lastPx(), kAsked);
    EXPECT_LE(gesture.inTimeFrom(), 300U);
}

// One frame in ten takes twice as long, all of them a few percent more or less.
TEST(Pace, DoesNotFlutterWithANoisyClock)
{
    for (unsigned seed = 0; seed < 100; ++seed) {
        const auto run = [&](const Machine& machine) {
            Pace pace;
            return drawn(pace, machine, noisy(machine, seed), 1000);
        };
        EXPECT_EQ(run(machineOf(4, 8)).changes(), 0) << seed;
        const Gesture loosened = run(machineOf(1, 60));
        EXPECT_LE(loosened.inTimeFrom(), 60U) << seed;
        EXPECT_LE(loosened.changes(), 6) << seed;
        EXPECT_LE(loosened.changes(200), 1) << seed;
        EXPECT_EQ(run(machineOf(50, 1)).lastPx(), kAsked) << seed;
    }
}

TEST(Pace, LooksAwayFromFramesThatWereDrawnWithAnotherTolerance)
{
    Pace pace;
    for (int frame = 0; frame < 100; ++frame)
        EXPECT_EQ(pace.afterDrawing({2 * kAsked, 100}, kAsked), kAsked);
}

TEST(Pace, BeginsAnewWithAnotherAskedTolerance)
{
    Pace pace;
    const Machine slow = machineOf(1, 100);
    EXPECT_GT(drawn(pace, slow, slow, 50).lastPx(), kAsked);
    EXPECT_EQ(pace.afterDrawing({3, 5}, 1), 1);
}

}  // namespace
}  // namespace knotspan
