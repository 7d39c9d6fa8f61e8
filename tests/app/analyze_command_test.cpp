#include <chrono>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "model/formats/format_list.h"
#include "model/geometry/knot_insertion.h"
#include "model/samples/net.h"
#include "model/samples/sample_list.h"
#include "tests/app/run_program.h"
#include "tests/support.h"

using namespace knotspan;
using namespace knotspan::testing;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

Names namesOf(const Json& object)
{
    Names names;
    for (const auto& [name, value] : object.items())
        names.push_back(name);
    return names;
}

// One unit wide, `length` long, its far side `rise` up: it leaves the y axis at the angle atan(rise).
NurbsSurface ramp(double rise, double length = 1)
{
    const KnotVector knots = clampedIntegerKnots(1, 1);
    return surfaceOf(knots, knots, [&](int i, int j) -> ControlPoint {
        return {{length * i, j, length * i * rise}, 1};
    });
}

// No tangent plane where it meets the y axis: the first two rows of control points are one.
NurbsSurface blunt()
{
    return surfaceOf(clampedIntegerKnots(2, 1), clampedIntegerKnots(1, 1), [](int i, int j) -> ControlPoint {
        return {{i == 2 ? -1 : 0, j, 0}, 1};
    });
}

// A wavy bicubic sheet, one knot in the middle of each direction.
NurbsSurface sheet()
{
    const KnotVector knots = clampedIntegerKnots(3, 2);
    return surfaceOf(knots, knots, [&](int i, int j) -> ControlPoint {
        const double x = grevilleAbscissa(knots, i);
        const double y = grevilleAbscissa(knots, j);
        return {{x, y, 0.3 * std::sin(2 * x) * std::cos(y)}, 1};
    });
}

class AnalyzeCommand : public ::testing::Test {
protected:
    void write(const std::vector<NurbsSurface>& surfaces, const Vec3& secondMovedBy = Vec3(0))
    {
        Scene scene;
        for (const NurbsSurface& surface : surfaces) {
            SceneObject object = namedObject("Part " + std::to_string(scene.objects().size()), {}, surface);
            if (scene.objects().size() == 1)
                object.transform[3] = Vec4(secondMovedBy, 1);
            scene.add(std::move(object));
        }
        ASSERT_TRUE(formats::write(scene, file));
    }

    void writeSample(const std::string& name) { ASSERT_TRUE(formats::write(findSample(name)->make(), file)); }

    ProgramRun analyze(std::vector<std::string> options = {}) const
    {
        options.insert(options.begin(), {"analyze", file.string()});
        return runProgram(options);
    }

    int exitCode(const std::vector<std::string>& options = {}) const
    {
        const ProgramRun run = analyze(options);
        EXPECT_EQ(run.messages, "");
        return run.exitCode;
    }

    Json json(std::vector<std::string> options = {}) const
    {
        options.emplace_back("--json");
        return Json::parse(analyze(options).output);
    }

    TemporaryFolder folder;
    fs::path file = folder / "model.knotspan";
};

}  // namespace

TEST_F(AnalyzeCommand, JsonHasTheNamesOfTheContract)
{
    write({ramp(0), ramp(0, -1), ramp(0, 1)}, {0, 0, 0.002});
    const Json json = this->json();
    EXPECT_EQ(namesOf(json), (Names{"creases", "edges", "naked_edges", "summary"}));
    ASSERT_FALSE(json.at("edges").empty());
    for (const Json& edge : json.at("edges")) {
        EXPECT_EQ(namesOf(edge), (Names{"a", "angle_bound_deg", "angle_max_deg", "b", "continuity",
                                        "curvature_max", "friends", "gap_max", "range"}));
        EXPECT_EQ(namesOf(edge.at("a")), (Names{"side", "surface"}));
        EXPECT_EQ(namesOf(edge.at("b")), (Names{"side", "surface"}));
    }
    ASSERT_FALSE(json.at("naked_edges").empty());
    EXPECT_EQ(namesOf(json.at("naked_edges").at(0)), (Names{"range", "side", "surface"}));
}

TEST_F(AnalyzeCommand, HalvesOfASurfaceCutAtAKnotAreG2)
{
    const NurbsSurface whole = sheet();
    write({clampedPart(whole, Direction::U, 0, 1), clampedPart(whole, Direction::U, 1, 2)});
    EXPECT_EQ(exitCode({"--require", "G2"}), 0);
    const Json json = this->json();
    ASSERT_EQ(json.at("edges").size(), 1U);
    const Json& edge = json.at("edges").at(0);
    EXPECT_EQ(edge.at("continuity"), "G2");
    EXPECT_EQ(edge.at("friends"), true);
    EXPECT_EQ(edge.at("a"), (Json{{"surface", 0}, {"side", "u end"}}));
    EXPECT_EQ(edge.at("b"), (Json{{"surface", 1}, {"side", "u start"}}));
    EXPECT_EQ(edge.at("range"), (Json{0, 2}));
    EXPECT_LT(edge.at("gap_max"), 1e-12);
    EXPECT_LT(edge.at("angle_bound_deg"), 1e-6);
    EXPECT_LT(edge.at("curvature_max"), 1e-6);
    EXPECT_EQ(json.at("naked_edges").size(), 6U);
    EXPECT_EQ(json.at("summary").at("passes"), true);
}

TEST_F(AnalyzeCommand, AKinkMissesUnlessItIsAllowed)
{
    write({ramp(std::tan(0.3 * M_PI / 180)), ramp(0, -1)});
    EXPECT_EQ(exitCode(), 3);
    EXPECT_EQ(exitCode({"--angle", "0.299"}), 3);
    EXPECT_EQ(exitCode({"--angle", "0.301"}), 0);
    EXPECT_EQ(exitCode({"--require", "G0"}), 0);
    const Json json = this->json();
    const Json& edge = json.at("edges").at(0);
    EXPECT_EQ(edge.at("continuity"), "G0");
    EXPECT_EQ(edge.at("friends"), false);
    EXPECT_TRUE(edge.at("curvature_max").is_null());
    EXPECT_NEAR(edge.at("angle_max_deg"), 0.3, 1e-9);
    EXPECT_GE(edge.at("angle_bound_deg"), edge.at("angle_max_deg"));
    EXPECT_EQ(json.at("summary").at("misses").at(0).at("edge"), 0);
    EXPECT_EQ(json.at("summary").at("misses").at(0).at("point").at(0), 0.0);
}

TEST_F(AnalyzeCommand, AGapMissesUnlessItIsAllowed)
{
    write({ramp(0), ramp(0, -1)}, {0, 0, 0.002});
    for (const char* continuity : {"G0", "G1", "G2"})
        EXPECT_EQ(exitCode({"--require", continuity}), 3) << continuity;
    EXPECT_EQ(exitCode({"--gap", "0.00199"}), 3);
    EXPECT_EQ(exitCode({"--gap", "0.00201"}), 0);
    const Json json = this->json();
    EXPECT_EQ(json.at("edges").at(0).at("continuity"), "none");
    EXPECT_NEAR(json.at("edges").at(0).at("gap_max"), 0.002, 1e-4);
}

TEST_F(AnalyzeCommand, ABreakOfCurvatureMissesOnlyWhereG2IsAsked)
{
    const KnotVector quadratic = clampedIntegerKnots(2, 1);
    const NurbsSurface bent = surfaceOf(quadratic, clampedIntegerKnots(1, 1), [](int i, int j) {
        return ControlPoint{{0.5 * i, j, i == 2 ? 0.5 : 0}, 1};
    });
    write({bent, ramp(0, -1)});
    EXPECT_EQ(exitCode(), 0);
    EXPECT_EQ(exitCode({"--require", "G2"}), 3);
    const Json json = this->json();
    const Json& edge = json.at("edges").at(0);
    EXPECT_EQ(edge.at("continuity"), "G1");
    EXPECT_NEAR(edge.at("curvature_max"), 1, 1e-9);  // z = x^2 / 2 beside a plane
}

TEST_F(AnalyzeCommand, WhatIsUndeterminedMissesWhereTangentPlanesCount)
{
    write({ramp(0), blunt()});
    EXPECT_EQ(exitCode(), 3);
    EXPECT_EQ(exitCode({"--require", "G2"}), 3);
    EXPECT_EQ(exitCode({"--require", "G0"}), 0);
    EXPECT_EQ(json().at("edges").at(0).at("continuity"), "undetermined");
}

TEST_F(AnalyzeCommand, NakedEdgesMissOnlyWhereAModelShouldBeClosed)
{
    writeSample("single-100");
    EXPECT_EQ(exitCode(), 0);
    EXPECT_EQ(exitCode({"--closed"}), 3);
    EXPECT_EQ(json().at("naked_edges").size(), 4U);
    writeSample("sphere");
    EXPECT_EQ(exitCode({"--closed", "--require", "G2"}), 0);
    writeSample("torus");
    EXPECT_EQ(exitCode({"--closed", "--require", "G2"}), 0);
}

TEST_F(AnalyzeCommand, TheHullShowsItsCreaseAndNothingElse)
{
    writeSample("hull");
    EXPECT_EQ(exitCode(), 3);
    EXPECT_EQ(exitCode({"--require", "G0"}), 0);
    const Json json = this->json();
    EXPECT_EQ(json.at("summary").at("units"), "m");
    const Json info = Json::parse(runProgram({"info", file, "--json"}).output);
    const auto nameOf = [&](const Json& place) {
        return info.at("surfaces").at(place.at("surface").get<size_t>()).at("name").get<std::string>();
    };
    size_t creases = 0;
    for (const Json& edge : json.at("edges")) {
        const bool starboardMeetsPort =
            nameOf(edge.at("a")).substr(0, 4) != nameOf(edge.at("b")).substr(0, 4);
        EXPECT_EQ(edge.at("continuity"), starboardMeetsPort ? "G0" : "G2") << edge;
        creases += starboardMeetsPort ? 1 : 0;
        EXPECT_EQ(edge.at("angle_max_deg") > 20, starboardMeetsPort) << edge;
    }
    EXPECT_EQ(creases, 4U);  // keel aft, amidships and fore, and the stem
    EXPECT_EQ(json.at("summary").at("misses").size(), creases);
    for (const Json& miss : json.at("summary").at("misses"))
        EXPECT_NEAR(miss.at("point").at(1), 0, 1e-9) << miss;
}

TEST_F(AnalyzeCommand, AllInnerEdgesOfTheKnotAreG2)
{
    writeSample("knot");
    EXPECT_EQ(exitCode({"--require", "G2", "--closed"}), 0);
    const Json json = this->json();
    EXPECT_EQ(json.at("edges").size(), 1200U);
    EXPECT_EQ(json.at("summary").at("continuity").at("G2"), 1200);
    EXPECT_EQ(json.at("naked_edges").size(), 0U);
}

TEST_F(AnalyzeCommand, TheTableNamesWhatMissesFirst)
{
    writeSample("hull");
    const ProgramRun run = analyze({"--rows", "2"});
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_EQ(run.messages, "");
    const auto count = [&](const std::string& text) {
        size_t found = 0;
        for (size_t at = run.output.find(text); at != std::string::npos; at = run.output.find(text, at + 1))
            ++found;
        return found;
    };
    EXPECT_EQ(count("\nmisses  G0 "), 2U) << run.output;
    EXPECT_EQ(count("0 Starboard aft: v start [0, 5]  |  1 Port aft: v start [10, 15]"), 1U) << run.output;
    EXPECT_EQ(count("... and 6 more\n"), 2U) << run.output;  // edges and naked edges
    EXPECT_EQ(count("8 edges (4 G0, 4 G2) where surfaces meet, 8 naked edges. G1 within a gap of 0.001 m and "
                    "an angle of 0.1 degrees: 4 edges miss.\n"),
              1U)
        << run.output;
    EXPECT_EQ(analyze().output.find("more"), std::string::npos);
}

TEST_F(AnalyzeCommand, AGapThatSwallowsTheModelIsNoPass)
{
    writeSample("single-100");
    for (const auto& options : {Names{"--gap", "100"}, Names{"--gap", "100", "--closed"}}) {
        const ProgramRun run = analyze(options);
        EXPECT_EQ(run.exitCode, 3);
        EXPECT_NE(run.messages.find("4 edges are no longer than three gap tolerances"), std::string::npos)
            << run.messages;
        EXPECT_NE(run.output.find("give a smaller --gap"), std::string::npos) << run.output;
    }
    EXPECT_EQ(json({"--gap", "100"}).at("summary").at("short_edges"), 4);
    EXPECT_EQ(json().at("summary").at("short_edges"), 0);
    writeSample("sphere");  // whose poles are short whatever the tolerance
    EXPECT_EQ(json().at("summary").at("short_edges"), 0);
}

TEST_F(AnalyzeCommand, CreasesInsideASurfaceAreListed)
{
    const NurbsSurface roof =
        surfaceOf(clampedIntegerKnots(1, 2), clampedIntegerKnots(1, 1), [](int i, int j) {
            return ControlPoint{{i, j, i == 1 ? 1 : 0}, 1};
        });
    write({roof});
    const ProgramRun run = analyze();
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_NE(run.messages.find("1 crease lies inside a surface"), std::string::npos) << run.messages;
    EXPECT_NE(run.output.find("0 Part 0: u = 1, 90 degrees"), std::string::npos) << run.output;
    const Json crease = json().at("creases").at(0);
    EXPECT_EQ(crease.at("direction"), "u");
    EXPECT_NEAR(crease.at("angle_max_deg"), 90, 1e-9);
    for (const char* smooth : {"sphere", "torus", "nine-16"}) {  // of double knots, some of them
        writeSample(smooth);
        EXPECT_TRUE(json().at("creases").empty()) << smooth;
    }
}

TEST_F(AnalyzeCommand, LeavesHiddenSurfacesOutAndSaysSo)
{
    write({ramp(0), ramp(0.5, -1), ramp(0, -1)});
    EXPECT_EQ(exitCode(), 3);
    Json model = Json::parse(readFile(file));
    model.at("objects").at(1).at("visible") = false;
    writeFile(file, model.dump());
    const ProgramRun run = analyze({"--json"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_NE(run.messages.find("1 surface is hidden"), std::string::npos) << run.messages;
    const Json json = Json::parse(run.output);
    ASSERT_EQ(json.at("edges").size(), 1U);
    EXPECT_EQ(json.at("edges").at(0).at("b").at("surface"), 2);  // as `info` counts them
}

TEST_F(AnalyzeCommand, RefusesWrongCalls)
{
    writeSample("sphere");
    expectWrongCall({"analyze"});
    expectWrongCall({"analyze", file, file});
    for (const char* option : {"--gap", "--angle", "--require", "--rows"})
        for (const char* wrong : {"", "x", "-1", "nan", "inf", "1e999", "0.1mm"})
            expectWrongCall({"analyze", file, option, wrong});
    expectWrongCall({"analyze", file, "--angle", "91"});
    expectWrongCall({"analyze", file, "--require", "G3"});
    expectWrongCall({"analyze", file, "--require", "none"});
    expectWrongCall({"analyze", file, "--rows", "0"});
}

TEST_F(AnalyzeCommand, ImportsMayBreakByHalfADegree)
{
    KNOTSPAN_NEED_MODELS(models);
    const ProgramRun run = runProgram({"analyze", *models / "newell_teapot.step", "--json"});
    EXPECT_EQ(run.exitCode, 3);  // lid, spout and handle are set on with a kink
    const Json json = Json::parse(run.output);
    EXPECT_EQ(json.at("summary").at("angle_deg"), 0.5);
    EXPECT_EQ(json.at("edges").size(), 48U);
    EXPECT_EQ(json.at("summary").at("continuity").at("G0"), 4);
}

TEST_F(AnalyzeCommand, AnalyzesOrRefusesEveryRealFileWithoutACrash)
{
    KNOTSPAN_NEED_MODELS(models);
    size_t analyzed = 0;
    for (const auto& entry : fs::directory_iterator(*models)) {
        const auto start = std::chrono::steady_clock::now();
        const ProgramRun run = runProgram({"analyze", entry.path(), "--json"});
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        SCOPED_TRACE(entry.path().filename().string() + " " + run.messages);
        EXPECT_LT(time.count(), kHang);
        if (run.exitCode == 1) {
            EXPECT_EQ(run.output, "");
            EXPECT_EQ(run.messages.rfind("knotspan: ", 0), 0U);
            continue;
        }
        ++analyzed;
        RecordProperty(entry.path().stem().string() + "_s", std::to_string(time.count()));
        ASSERT_TRUE(run.exitCode == 0 || run.exitCode == 3) << run.exitCode;
        const Json summary = Json::parse(run.output).at("summary");
        EXPECT_EQ(summary.at("passes"), run.exitCode == 0);
        EXPECT_EQ(summary.at("misses").empty(), run.exitCode == 0);
        EXPECT_EQ(summary.at("edges").get<size_t>() + summary.at("naked_edges").get<size_t>() > 0, true);
    }
    EXPECT_GE(analyzed, 10U);
}
