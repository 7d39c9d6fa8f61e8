#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "model/geometry/evaluation.h"
#include "model/samples/sample_list.h"
#include "tests/app/run_program.h"
#include "tests/support.h"

using namespace knotspan;
using namespace knotspan::testing;
using Json = nlohmann::json;

namespace {

class EvaluateCommand : public ::testing::Test {
protected:
    void SetUp() override
    {
        ASSERT_EQ(runProgram({"sample", "sphere", "-o", sphere}).exitCode, 0);
        const Scene scene = findSample("sphere")->make();
        const NurbsSurface& surface = scene.objects().begin()->second->surface;
        u = surface.knotsU().domainStart() * 0.3 + surface.knotsU().domainEnd() * 0.7;
        v = surface.knotsV().domainStart() * 0.6 + surface.knotsV().domainEnd() * 0.4;
        expected = evaluate(surface, u, v);
        char text[80];
        std::snprintf(text, sizeof text, "%.17g,%.17g", u, v);
        at = text;
    }

    TemporaryFolder folder;
    std::string sphere = folder / "sphere.knotspan";
    std::string at;
    double u = 0, v = 0;
    SurfacePoint expected;
};

}  // namespace

TEST_F(EvaluateCommand, GivesTheReferencesNumbersToTheLastBit)
{
    const ProgramRun run = runProgram({"evaluate", sphere, "--surface", "0", "--at", at, "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.messages;
    const Json point = Json::parse(run.output).at("points").at(0);
    const auto vector = [](const Json& json) { return Vec3(json.at(0), json.at(1), json.at(2)); };
    EXPECT_EQ(point.at("surface"), 0);
    EXPECT_EQ(point.at("u"), u);
    EXPECT_EQ(point.at("v"), v);
    EXPECT_EQ(vector(point.at("point")), expected.position);
    EXPECT_EQ(vector(point.at("derivatives").at("du")), expected.du);
    EXPECT_EQ(vector(point.at("derivatives").at("dv")), expected.dv);
    EXPECT_EQ(vector(point.at("derivatives").at("duu")), expected.duu);
    EXPECT_EQ(vector(point.at("derivatives").at("duv")), expected.duv);
    EXPECT_EQ(vector(point.at("derivatives").at("dvv")), expected.dvv);
}

TEST_F(EvaluateCommand, ASphereBendsAlikeEverywhere)
{
    const ProgramRun run = runProgram({"evaluate", sphere, "--surface", "0", "--at", at, "--json"});
    const Json curvatures = Json::parse(run.output).at("points").at(0).at("curvatures");
    const double mean = curvatures.at("mean");
    EXPECT_NEAR(curvatures.at("gauss").get<double>(), mean * mean, 1e-9 * mean * mean);
    EXPECT_NEAR(curvatures.at("principal").at(0).get<double>(), mean, 1e-6 * std::abs(mean));
    EXPECT_NEAR(curvatures.at("principal").at(1).get<double>(), mean, 1e-6 * std::abs(mean));
}

TEST_F(EvaluateCommand, PrintsSeventeenDigitsForPeople)
{
    const ProgramRun run = runProgram({"evaluate", sphere, "--surface", "0", "--at", at, "--at", at});
    ASSERT_EQ(run.exitCode, 0) << run.messages;
    char line[120];
    std::snprintf(line, sizeof line, "  point   %.17g %.17g %.17g\n", expected.position.x,
                  expected.position.y, expected.position.z);
    const size_t first = run.output.find(line);
    ASSERT_NE(first, std::string::npos) << run.output;
    EXPECT_NE(run.output.find(line, first + 1), std::string::npos);
}

TEST_F(EvaluateCommand, RefusesWhatIsNotThere)
{
    expectFailure({"evaluate", sphere, "--surface", "1", "--at", "0,0"}, "no surface 1");
    expectFailure({"evaluate", sphere, "--surface", "0", "--at", "-1e9,0"}, "outside");
    expectWrongCall({"evaluate", sphere, "--surface", "0"});
    expectWrongCall({"evaluate", sphere, "--at", "0,0"});
    for (const char* wrong : {"1", "1,2,3", "nan,0", "inf,0", "a,b", "0,", "", "1e999,0"})
        expectWrongCall({"evaluate", sphere, "--surface", "0", "--at", wrong});
    expectWrongCall({"evaluate", sphere, "--surface", "-1", "--at", "0,0"});
    expectWrongCall({"evaluate", sphere, "--surface", "0.5", "--at", "0,0"});
}
