#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/run_program.h"
#include "tests/support.h"

using namespace knotspan::testing;
using Json = nlohmann::json;

TEST(InfoCommand, JsonHasTheNamesOfTheContract)
{
    const TemporaryFolder folder;
    ASSERT_EQ(runProgram({"sample", "sphere", "-o", folder / "sphere.knotspan"}).exitCode, 0);
    const ProgramRun run = runProgram({"info", folder / "sphere.knotspan", "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.messages;
    EXPECT_EQ(run.messages, "");
    const Json info = Json::parse(run.output);
    std::vector<std::string> names;
    for (const auto& [name, value] : info.items())
        names.push_back(name);
    EXPECT_EQ(names, (std::vector<std::string>{"bounds", "bytes_bezier", "bytes_nurbs", "control_points",
                                               "ksquads", "surfaces", "units"}));
    const Json& surface = info.at("surfaces").at(0);
    EXPECT_EQ(surface.at("id"), 0);
    EXPECT_EQ(surface.at("degree_u"), 2);
    EXPECT_EQ(surface.at("degree_v"), 2);
    EXPECT_EQ(surface.at("rational"), true);
    EXPECT_EQ(surface.at("trimmed"), false);
    EXPECT_TRUE(surface.at("name").is_string());
    EXPECT_NE(surface.at("closed_u"), surface.at("closed_v"));
    const int points = surface.at("control_points_u").get<int>() * surface.at("control_points_v").get<int>();
    EXPECT_EQ(info.at("control_points"), points);
    EXPECT_EQ(info.at("ksquads"), surface.at("ksquads"));
    EXPECT_EQ(surface.size(), 11U);
}

TEST(InfoCommand, ASingleSurfaceOf100ControlPointsTakesTheBytesOfItsNetAndKnots)
{
    const TemporaryFolder folder;
    ASSERT_EQ(runProgram({"sample", "single-100", "-o", folder / "s.knotspan"}).exitCode, 0);
    const Json info = Json::parse(runProgram({"info", folder / "s.knotspan", "--json"}).output);
    EXPECT_EQ(info.at("control_points"), 100);
    EXPECT_EQ(info.at("ksquads"), 49);
    EXPECT_EQ(info.at("bytes_nurbs"), 100 * 16 + 2 * 14 * 4);
    EXPECT_EQ(info.at("bytes_bezier"), 49 * 16 * 16);
}

TEST(InfoCommand, SaysTheSameForPeople)
{
    const TemporaryFolder folder;
    ASSERT_EQ(runProgram({"sample", "nine-16", "-o", folder / "n.knotspan"}).exitCode, 0);
    const ProgramRun run = runProgram({"info", folder / "n.knotspan"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.output.rfind("9 surfaces, 9 KSQuads, 144 control points\n", 0), 0U) << run.output;
}

TEST(InfoCommand, CountsTheFacesOfARealStepFile)
{
    KNOTSPAN_NEED_MODELS(models);
    const ProgramRun run = runProgram({"info", *models / "screw.step", "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.messages;
    EXPECT_EQ(Json::parse(run.output).at("surfaces").size(), 10U);
}
