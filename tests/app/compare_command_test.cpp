#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "model/formats/format_list.h"
#include "model/samples/sample_list.h"
#include "tests/app/run_program.h"
#include "tests/support.h"

using namespace knotspan;
using namespace knotspan::testing;
using Json = nlohmann::json;

namespace {

void writeSphere(const std::filesystem::path& path, double radius, const std::string& units)
{
    SceneObject sphere = *findSample("sphere")->make().objects().begin()->second;
    sphere.transform = glm::scale(Mat4(1.0), Vec3(radius)) * sphere.transform;
    Scene scene;
    scene.add(sphere);
    scene.setUnits(units);
    ASSERT_TRUE(formats::write(scene, path));
}

}  // namespace

TEST(CompareCommand, KnowsTheDistanceOfSpheresInAnyUnits)
{
    const TemporaryFolder folder;
    writeSphere(folder / "a.knotspan", 1, "mm");
    writeSphere(folder / "b.knotspan", 0.00104, "m");
    const ProgramRun run = runProgram({"compare", folder / "a.knotspan", folder / "b.knotspan", "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.messages;
    EXPECT_NE(run.messages.find("Lengths were converted from m to mm."), std::string::npos) << run.messages;
    const Json found = Json::parse(run.output);
    std::vector<std::string> names;
    for (const auto& [name, value] : found.items())
        names.push_back(name);
    EXPECT_EQ(names, (std::vector<std::string>{"a", "a_to_b", "b", "b_to_a", "largest", "largest_at", "mean",
                                               "uncertainty", "units"}));
    const double uncertainty = found.at("uncertainty");
    EXPECT_NEAR(found.at("largest"), 0.04, uncertainty);
    EXPECT_NEAR(found.at("mean"), 0.04, uncertainty);
    EXPECT_NEAR(found.at("a_to_b").at("largest"), 0.04, uncertainty);
    EXPECT_NEAR(found.at("b_to_a").at("mean"), 0.04, uncertainty);
    EXPECT_LT(uncertainty, 0.002);
    EXPECT_EQ(found.at("units"), "mm");
    EXPECT_EQ(found.at("largest_at").size(), 3U);
}

TEST(CompareCommand, FindsAMeshWithinItsDeviationAndTellsPeople)
{
    const TemporaryFolder folder;
    writeSphere(folder / "a.knotspan", 20, "in");
    ASSERT_EQ(runProgram({"convert", folder / "a.knotspan", folder / "a.glb", "--deviation", "0.1"}).exitCode,
              0);
    ASSERT_EQ(runProgram({"convert", folder / "a.knotspan", folder / "a.stl", "--deviation", "0.1"}).exitCode,
              0);
    for (const char* mesh : {"a.glb", "a.stl"}) {
        const ProgramRun run = runProgram({"compare", folder / "a.knotspan", folder / mesh, "--json"});
        ASSERT_EQ(run.exitCode, 0) << run.messages;
        EXPECT_EQ(std::count(run.messages.begin(), run.messages.end(), '\n'), 1) << run.messages;
        const Json found = Json::parse(run.output);
        EXPECT_LE(found.at("largest"), 0.1 + found.at("uncertainty").get<double>()) << mesh;
        EXPECT_GT(found.at("largest"), 0.01) << mesh;
    }
    const ProgramRun run = runProgram({"compare", folder / "a.glb", folder / "a.glb"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.output.rfind("largest distance ", 0), 0U) << run.output;
    EXPECT_NE(run.output.find(" m; from the first to the second "), std::string::npos) << run.output;
    EXPECT_EQ(run.messages, "");
}

TEST(CompareCommand, RefusesWhatCannotBeRead)
{
    const TemporaryFolder folder;
    writeSphere(folder / "a.knotspan", 1, "mm");
    expectWrongCall({"compare", folder / "a.knotspan"});
    expectFailure({"compare", folder / "a.knotspan", folder / "b.stl"}, folder / "b.stl");
}
