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
                                               "ksquads", "meshes", "surfaces", "units"}));
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

// A square of 4 x 4 units: trimmed to a half, with a gap of 1 % in the loop of the first, open in the second.
TEST(InfoCommand, TellsWhatTrimLoopsLeaveAndWhatWasWrongWithThem)
{
    const TemporaryFolder folder;
    const auto surface = [](const std::string& name, const std::string& lastPoint) {
        return "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 4 4 0\nvp 0 0\nvp 1 0\nvp 1 0.5\nvp 0 0.5\nvp " + lastPoint +
               "\ncstype bspline\ndeg 1\ncurv2 -5 -4 -3 -2 -1\nparm u 0 0 1 2 3 4 4\nend\no " + name +
               "\ncstype bspline\ndeg 1 1\nsurf 0 1 0 1 -4 -3 -2 -1\nparm u 0 0 1 1\nparm v 0 0 1 1\n"
               "trim 0 4 -1\nend\n";
    };
    writeFile(folder / "a.obj", surface("bridged", "0 0.003") + surface("open", "0 0.3"));
    const ProgramRun run = runProgram({"info", folder / "a.obj", "--json", "--area"});
    ASSERT_EQ(run.exitCode, 0) << run.messages;
    EXPECT_NE(
        run.messages.find("1 surface has trim loops that do not close (by up to 30 % of the surface) and is "
                          "shown whole: open."),
        std::string::npos)
        << run.messages;
    EXPECT_NE(
        run.messages.find(
            "1 surface has trim loops with gaps of up to 0.3 % of the surface, closed by lines: bridged."),
        std::string::npos)
        << run.messages;
    const Json surfaces = Json::parse(run.output).at("surfaces");
    ASSERT_EQ(surfaces.size(), 2U);
    EXPECT_EQ(surfaces[0].at("trim_loops"), 1);
    EXPECT_EQ(surfaces[0].at("trim_notes").size(), 1U);
    EXPECT_NEAR(surfaces[0].at("area").get<double>(), 8, 1e-9);
    EXPECT_NEAR(surfaces[1].at("area").get<double>(), 16, 1e-9);
    const ProgramRun words = runProgram({"info", folder / "a.obj", "--area"});
    EXPECT_NE(words.output.find("area 24 "), std::string::npos) << words.output;
}

TEST(InfoCommand, TellsOfMeshesWhetherTheyAreClosed)
{
    const TemporaryFolder folder;
    writeFile(folder / "open.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 2\n3 0 1 2\n3 0 2 3\n");
    const Json info = Json::parse(runProgram({"info", folder / "open.off", "--json"}).output);
    EXPECT_EQ(info.at("surfaces").size(), 0U);
    EXPECT_EQ(info.at("bounds").at("high"), (std::vector<double>{1, 1, 2}));
    EXPECT_EQ(info.at("meshes"), Json::array({Json{{"id", 0},
                                                   {"name", "open"},
                                                   {"vertices", 4},
                                                   {"triangles", 2},
                                                   {"boundary_edges", 4},
                                                   {"non_manifold_edges", 0},
                                                   {"closed", false}}}));
    const ProgramRun run = runProgram({"info", folder / "open.off"});
    EXPECT_EQ(run.output.rfind("1 mesh\nbounds (0, 0, 0) to (1, 1, 2) mm\n", 0), 0U) << run.output;
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
    const Json info = Json::parse(run.output);
    EXPECT_EQ(info.at("surfaces").size(), 10U);
    const Json& import = info.at("import");
    EXPECT_EQ(import.at("faces"), 10);
    EXPECT_EQ(import.at("exact"), 10);
    EXPECT_GT(import.at("seconds").get<double>(), 0);
    EXPECT_GT(import.at("peak_mb").get<double>(), 1);
    EXPECT_LT(import.at("peak_mb").get<double>(), 1000);
    EXPECT_NE(runProgram({"info", *models / "screw.step"}).output.find(" MiB of memory\n"),
              std::string::npos);
}
