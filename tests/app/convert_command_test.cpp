#include <cmath>

#include <gtest/gtest.h>

#include "model/formats/format_list.h"
#include "model/geometry/primitives.h"
#include "model/samples/sample_list.h"
#include "tests/app/run_program.h"
#include "tests/support.h"

using namespace knotspan;
using namespace knotspan::testing;
namespace fs = std::filesystem;

namespace {

// A wall and two ends, the upper one half a thousandth above it.
void writeGappedCan(const fs::path& path)
{
    const double half = std::sqrt(0.5);
    std::vector<TrimPoint> round;
    for (int k = 0; k <= 8; ++k) {
        const double angle = k % 8 * M_PI / 4;
        const double reach = k % 2 == 0 ? 0.25 : 0.25 / half;
        round.push_back({Vec2(0.5) + reach * Vec2(std::cos(angle), std::sin(angle)), k % 2 == 0 ? 1 : half});
    }
    const TrimCurve circle =
        TrimCurve::create(KnotVector::create(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}).value(), round).value();
    Scene scene;
    scene.add({.name = "wall", .surface = cylinder({0, 0, 0}, 2, 3)});
    scene.add({.name = "below",
               .surface = plane({-4, 4, 0}, {8, 0, 0}, {0, -8, 0}),
               .trimLoops = {{true, {circle}}}});
    scene.add({.name = "above",
               .surface = plane({-4, -4, 3 + 5e-4}, {8, 0, 0}, {0, 8, 0}),
               .trimLoops = {{true, {circle}}}});
    ASSERT_TRUE(formats::write(scene, path));
}

}  // namespace

TEST(ConvertCommand, KnotspanToKnotspanIsTheSameFile)
{
    const TemporaryFolder folder;
    ASSERT_EQ(runProgram({"sample", "extremes", "-o", folder / "a.knotspan"}).exitCode, 0);
    for (const bool verify : {false, true}) {
        std::vector<std::string> call{"convert", folder / "a.knotspan", folder / "b.knotspan"};
        if (verify)
            call.emplace_back("--verify");
        const ProgramRun run = runProgram(call);
        EXPECT_EQ(run.exitCode, 0) << run.messages;
        EXPECT_EQ(run.messages, "");
        const std::string place = folder / "b.knotspan";
        EXPECT_EQ(run.output, verify ? place + ": read back, the same model to the bit\n" : "");
        EXPECT_EQ(readFile(folder / "a.knotspan"), readFile(folder / "b.knotspan"));
        fs::remove(folder / "b.knotspan");
    }
}

TEST(ConvertCommand, WritesOverNeitherItsInputNorAProtectedFile)
{
    const TemporaryFolder folder;
    const std::string a = folder / "a.knotspan";
    ASSERT_EQ(runProgram({"sample", "sphere", "-o", a}).exitCode, 0);
    const std::string before = readFile(a);
    expectFailure({"convert", a, a}, a);
    fs::create_symlink(a, folder / "link.obj");
    expectFailure({"convert", a, folder / "link.obj"}, folder / "link.obj");
    expectFailure({"convert", a, "--to", "knotspan", "-d", folder / ""}, a);
    EXPECT_EQ(readFile(a), before);

    const std::string kept = folder / "kept.obj";
    writeFile(kept, "mine");
    fs::permissions(kept, fs::perms::owner_read);
    expectFailure({"convert", a, kept}, kept);
    EXPECT_EQ(readFile(kept), "mine");
}

// In their report as well as on standard error.
TEST(ConvertCommand, SaysWhatItLeftOut)
{
    const TemporaryFolder folder;
    Scene scene = findSample("nine-16")->make();
    const auto [id, object] = *scene.objects().begin();
    auto hidden = std::make_shared<SceneObject>(*object);
    hidden->visible = false;
    scene.exchange(id, hidden);
    scene.setUnits("m");
    ASSERT_TRUE(formats::write(scene, folder / "a.knotspan"));
    const ProgramRun mesh =
        runProgram({"convert", folder / "a.knotspan", folder / "a.stl", "--verify", "--json"});
    ASSERT_EQ(mesh.exitCode, 0) << mesh.messages;
    for (const std::string& said : {mesh.messages, mesh.output}) {
        EXPECT_NE(said.find("1 hidden object is not in the mesh."), std::string::npos) << said;
        EXPECT_NE(said.find("its numbers are in m."), std::string::npos) << said;
    }
    EXPECT_NE(mesh.output.find("\"same_mesh\":true"), std::string::npos) << mesh.output;
    ASSERT_EQ(runProgram({"convert", folder / "a.knotspan", folder / "a.obj"}).exitCode, 0);
    EXPECT_EQ(formats::read(folder / "a.obj")->units(), "m") << "our own files say so";
}

// 7 digits are too few for some of its surfaces.
TEST(ConvertCommand, KeepsToTheDeviationOrRefuses)
{
    const TemporaryFolder folder;
    ASSERT_EQ(runProgram({"sample", "extremes", "-o", folder / "a.knotspan"}).exitCode, 0);
    expectFailure({"convert", folder / "a.knotspan", folder / "a.stl"}, folder / "a.stl");
    EXPECT_FALSE(fs::exists(folder / "a.stl"));
}

TEST(ConvertCommand, StepBecomesAnEqualKnotspanFile)
{
    KNOTSPAN_NEED_MODELS(models);
    const TemporaryFolder folder;
    const ProgramRun run =
        runProgram({"convert", *models / "screw.step", folder / "screw.knotspan", "--verify"});
    ASSERT_EQ(run.exitCode, 0) << run.messages;
    EXPECT_EQ(*formats::read(folder / "screw.knotspan"), *formats::read(*models / "screw.step"));
}

TEST(ConvertCommand, ManyFilesGoIntoAFolder)
{
    const TemporaryFolder folder;
    for (const char* name : {"sphere", "torus"})
        ASSERT_EQ(runProgram({"sample", name, "-o", folder / (std::string(name) + ".knotspan")}).exitCode, 0);
    fs::create_directory(folder / "out");
    const std::vector<std::string> call{
        "convert",     folder / "sphere.knotspan", folder / "torus.knotspan", "--to", "knotspan", "-d",
        folder / "out"};
    EXPECT_EQ(runProgram(call).exitCode, 0);
    EXPECT_TRUE(fs::exists(folder / "out" / "sphere.knotspan"));
    EXPECT_TRUE(fs::exists(folder / "out" / "torus.knotspan"));
}

TEST(ConvertCommand, WritesNothingWhereItFails)
{
    const TemporaryFolder folder;
    ASSERT_EQ(runProgram({"sample", "sphere", "-o", folder / "a.knotspan"}).exitCode, 0);
    fs::create_directory(folder / "out");
    const std::string a = folder / "a.knotspan";
    const std::string out = folder / "out";
    expectWrongCall({"convert", a});
    expectWrongCall({"convert", a, out + "/b.banana"});
    expectWrongCall({"convert", a, out + "/b.bpt"});
    expectWrongCall({"convert", a, "--to", "knotspan"});
    expectWrongCall({"convert", a, "-d", out});
    expectWrongCall({"convert", a, a, "--to", "knotspan", "-d", out});
    expectWrongCall({"convert", a, out + "/b.knotspan", "--deviation", "0"});
    expectWrongCall({"convert", a, out + "/b.knotspan", "--angle", "nan"});
    expectFailure({"convert", folder / "absent.step", out + "/b.knotspan"}, folder / "absent.step");
    expectFailure({"convert", a, out + "/absent/b.knotspan"}, out + "/absent");
    expectFailure({"convert", a, out + "/absent/b.knotspan", "--verify"}, out + "/absent");
    expectFailure({"convert", a, "--to", "knotspan", "-d", folder / "absent"}, folder / "absent");
    EXPECT_TRUE(fs::is_empty(out));
}

// The file's own edges are further apart: written all the same, and said.
TEST(ConvertCommand, GivesThreeWhereAMeshMissesItsDeviation)
{
    const TemporaryFolder folder;
    writeGappedCan(folder / "a.knotspan");
    for (const std::string extension : {"ply", "stl"}) {
        const std::string output = folder / ("a." + extension);
        const ProgramRun missed =
            runProgram({"convert", folder / "a.knotspan", output, "--deviation", "1e-4", "--json"});
        EXPECT_EQ(missed.exitCode, 3) << missed.messages;
        EXPECT_NE(missed.messages.find("Joined borders are apart"), std::string::npos) << missed.messages;
        EXPECT_NE(missed.output.find("\"kept\":false"), std::string::npos) << missed.output;
        EXPECT_TRUE(fs::exists(output));
        const ProgramRun kept =
            runProgram({"convert", folder / "a.knotspan", output, "--deviation", "1e-2", "--json"});
        EXPECT_EQ(kept.exitCode, 0) << kept.messages;
        EXPECT_NE(kept.output.find("\"kept\":true"), std::string::npos) << kept.output;
    }
    // Among many, a file that fails outweighs one that misses.
    const auto many = [&](const std::vector<std::string>& files) {
        std::vector<std::string> call{"convert", "--to", "ply", "-d", folder / "", "--deviation", "1e-4"};
        call.insert(call.end(), files.begin(), files.end());
        return runProgram(call).exitCode;
    };
    ASSERT_EQ(runProgram({"sample", "sphere", "-o", folder / "b.knotspan"}).exitCode, 0);
    EXPECT_EQ(many({folder / "a.knotspan", folder / "b.knotspan"}), 3);
    EXPECT_EQ(many({folder / "a.knotspan", folder / "none.knotspan"}), 1);
    EXPECT_EQ(many({folder / "b.knotspan"}), 0);
}
