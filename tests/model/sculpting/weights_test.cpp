#include <gtest/gtest.h>

#include "model/sculpting/weights.h"
#include "tests/model/sculpting/sculpting_scene.h"

namespace knotspan::testing {

TEST(Weights, AreSetForTheSelectionAlone)
{
    const Scene start = sceneOf({symmetricSheet(), symmetricSheet()});
    const PointSelection row = rowOf(start, kFirst, 2);
    Result<Edit> edit = withWeights(start, row, 3.5);
    ASSERT_TRUE(edit);
    Scene scene = start;
    edit->applyTo(scene);
    const NurbsSurface& before = start.find(kFirst)->surface;
    const NurbsSurface& after = scene.find(kFirst)->surface;
    for (int i = 0; i < after.countU(); ++i)
        for (int j = 0; j < after.countV(); ++j) {
            EXPECT_EQ(after.controlPoint(i, j).weight, i == 2 ? 3.5 : before.controlPoint(i, j).weight);
            EXPECT_EQ(after.controlPoint(i, j).position, before.controlPoint(i, j).position);
        }
    EXPECT_EQ(scene.find(kSecond), start.find(kSecond));
    EXPECT_TRUE(withWeights(scene, row, 3.5)->isEmpty()) << "they are that already";
    edit->applyTo(scene);
    EXPECT_EQ(scene.find(kFirst), start.find(kFirst));
}

TEST(Weights, AreScaled)
{
    const Scene start = sceneOf({symmetricSheet()});
    const PointSelection all = netOf(start, kFirst);
    const Scene scene = applied(start, *withWeightsScaled(start, all, 0.25));
    for (int j = 0; j < 7; ++j)
        EXPECT_EQ(scene.find(kFirst)->surface.controlPoint(3, j).weight,
                  0.25 * start.find(kFirst)->surface.controlPoint(3, j).weight);
}

TEST(Weights, BeyondTheirBoundsAreRefusedWithASentence)
{
    const Scene scene = sceneOf({symmetricSheet()});
    const PointSelection row = rowOf(scene, kFirst, 2);
    for (const double weight : {0.0, -1.0, 0.9e-6, 1.1e6, std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::quiet_NaN()}) {
        const Result<Edit> edit = withWeights(scene, row, weight);
        ASSERT_FALSE(edit) << weight;
        EXPECT_NE(edit.error().sentence().find("1e-06 to 1e+06"), std::string::npos)
            << edit.error().sentence();
    }
    EXPECT_TRUE(withWeights(scene, row, kLeastWeight));
    EXPECT_TRUE(withWeights(scene, row, kMostWeight));
}

TEST(Weights, CanBeScaledUpToTheRangeAndNoFurther)
{
    const Scene scene = sceneOf({symmetricSheet()});
    const PointSelection all = netOf(scene, kFirst);
    const FactorRange range = factorRange(scene, all);
    for (const double factor : {range.low, range.high, 1.0})
        EXPECT_TRUE(withWeightsScaled(scene, all, factor)) << factor;
    EXPECT_FALSE(withWeightsScaled(scene, all, range.low * (1 - 1e-6)));
    EXPECT_FALSE(withWeightsScaled(scene, all, range.high * (1 + 1e-6)));
}

}  // namespace knotspan::testing
