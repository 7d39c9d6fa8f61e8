#include <gtest/gtest.h>

#include <set>

#include "renderer/frame.h"

namespace knotspan::testing {
namespace {

TEST(Lists, FindEveryPathAndShadingByItsName)
{
    for (const PathInfo& path : paths())
        EXPECT_EQ(findPath(path.name), path.id);
    for (const ShadingInfo& shading : shadings())
        EXPECT_EQ(findShading(shading.name), shading.id);
    EXPECT_FALSE(findPath("raytracing"));
    EXPECT_FALSE(findShading(""));
}

TEST(Lists, ReadCullSetsAsTheyWriteThem)
{
    for (const char* text : {"none", "surface", "lqc", "surface,lqc"}) {
        const auto set = parseCullSet(text);
        ASSERT_TRUE(set) << text;
        std::string joined;
        for (const std::string& name : names(*set))
            joined += (joined.empty() ? "" : ",") + name;
        EXPECT_EQ(joined, text);
    }
    for (const char* wrong : {"", "lqc,", ",lqc", "all", "lqc,none", "LQC"})
        EXPECT_FALSE(parseCullSet(wrong)) << wrong;
}

TEST(Lists, ReadSamplingRules)
{
    EXPECT_EQ(parseSamplingRule("area"), (SamplingRule{SamplingRule::Kind::area, 0}));
    EXPECT_EQ(parseSamplingRule("fixed:8"), (SamplingRule{SamplingRule::Kind::fixed, 8}));
    for (const char* wrong : {"", "fixed", "fixed:", "fixed:0", "fixed:65", "fixed:8x", "fixed:-1", "Area"})
        EXPECT_FALSE(parseSamplingRule(wrong)) << wrong;
}

}  // namespace
}  // namespace knotspan::testing
