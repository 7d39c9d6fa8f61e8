// `knotspan convert` over many files, through standard streams, and what it reports.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "model/formats/format_list.h"
#include "tests/app/run_program.h"
#include "tests/support.h"

using namespace knotspan;
using namespace knotspan::testing;
namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

std::vector<Json> linesOf(const std::string& text)
{
    std::vector<Json> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(Json::parse(line));
    return lines;
}

void makeSample(const std::string& name, const fs::path& path)
{
    ASSERT_EQ(runProgram({"sample", name, "-o", path}).exitCode, 0);
}

}  // namespace

TEST(ConvertCommand, ReportsOfAMeshWhatWasAskedProvedAndMeasured)
{
    const TemporaryFolder folder;
    makeSample("torus", folder / "a.knotspan");
    for (const std::string extension : {"stl", "obj", "ply", "off", "vtp", "glb"}) {
        const std::string output = folder / ("a." + extension);
        const ProgramRun run = runProgram(
            {"convert", folder / "a.knotspan", output, "--deviation", "0.01", "--verify", "--json"});
        ASSERT_EQ(run.exitCode, 0) << extension << run.messages;
        const Json report = linesOf(run.output).at(0);
        std::vector<std::string> names;
        for (const auto& [name, value] : report.items())
            names.push_back(name);
        EXPECT_EQ(names, (std::vector<std::string>{"boundary_edges", "deviation", "error", "input",
                                                   "non_manifold_edges", "notes", "ok", "output", "peak_mb",
                                                   "seconds", "triangles", "verify", "vertices"}));
        EXPECT_EQ(report.at("output"), output);
        EXPECT_EQ(report.at("ok"), true);
        EXPECT_EQ(report.at("boundary_edges"), 0);
        EXPECT_EQ(report.at("deviation").at("asked"), 0.01);
        EXPECT_LE(report.at("deviation").at("measured"), 0.01);
        EXPECT_GT(report.at("peak_mb"), 1);
        // A closed body: what goes round it is Euler's number of a torus.
        const Json info = Json::parse(runProgram({"info", output, "--json"}).output).at("meshes").at(0);
        EXPECT_EQ(info.at("triangles"), report.at("triangles"));
        EXPECT_EQ(info.at("vertices"), report.at("vertices"));
        EXPECT_EQ(info.at("closed"), true);
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 7);
}

TEST(ConvertCommand, GoesOnWithTheOthersWhereOneOfManyFails)
{
    const TemporaryFolder folder;
    std::vector<std::string> call{"convert"};
    for (const std::string name : {"sphere", "torus", "nine-16"}) {
        makeSample(name, folder / (name + ".knotspan"));
        call.push_back(folder / (name + ".knotspan"));
    }
    writeFile(folder / "broken.step", "ISO-10303-21;");
    call.insert(call.begin() + 2, folder / "broken.step");
    fs::create_directory(folder / "out");
    for (const char* argument : {"--to", "obj", "-d"})
        call.emplace_back(argument);
    call.push_back(folder / "out");
    for (const char* jobs : {"1", "3"}) {
        std::vector<std::string> all = call;
        all.insert(all.end(), {"--jobs", jobs, "--json", "--verify"});
        const ProgramRun run = runProgram(all);
        EXPECT_EQ(run.exitCode, 1);
        const auto reports = linesOf(run.output);
        ASSERT_EQ(reports.size(), 4U) << run.output << run.messages;
        for (size_t k = 0; k < 4; ++k) {
            EXPECT_EQ(reports[k].at("input"), call[k + 1]) << jobs;
            EXPECT_EQ(reports[k].at("ok"), k != 1) << jobs;
        }
        EXPECT_NE(reports[1].at("error").get<std::string>().find("broken.step"), std::string::npos);
        EXPECT_NE(run.messages.find("broken.step"), std::string::npos);
        EXPECT_LE(reports[0].at("verify").at("largest_difference"), 1e-12);
        EXPECT_EQ(std::distance(fs::directory_iterator(folder / "out"), {}), 3);
    }
}

TEST(ConvertCommand, ReadsAndWritesStandardStreamsByteForByte)
{
    const TemporaryFolder folder;
    makeSample("sphere", folder / "a.knotspan");
    ASSERT_EQ(runProgram({"convert", folder / "a.knotspan", folder / "a.obj"}).exitCode, 0);
    const ProgramRun surfaces =
        runProgram({"convert", "-", "-", "--from", "knotspan", "--to", "obj"}, folder / "a.knotspan");
    EXPECT_EQ(surfaces.exitCode, 0) << surfaces.messages;
    EXPECT_EQ(surfaces.output, readFile(folder / "a.obj"));
    ASSERT_EQ(runProgram({"convert", folder / "a.knotspan", folder / "a.stl"}).exitCode, 0);
    const ProgramRun mesh = runProgram({"convert", folder / "a.knotspan", "-", "--to", "stl"});
    EXPECT_EQ(mesh.exitCode, 0) << mesh.messages;
    EXPECT_EQ(mesh.output, readFile(folder / "a.stl"));
    EXPECT_EQ(mesh.messages.rfind("-: ", 0), 0U) << mesh.messages;
    ASSERT_EQ(runProgram({"convert", "-", folder / "b.ply", "--from", ".stl"}, folder / "a.stl").exitCode, 0);
    EXPECT_EQ(formats::read(folder / "b.ply")->meshes().begin()->second->mesh->triangles.size(),
              formats::read(folder / "a.stl")->meshes().begin()->second->mesh->triangles.size());

    const ProgramRun broken =
        runProgram({"convert", "-", folder / "c.obj", "--from", "step"}, folder / "a.stl");
    EXPECT_EQ(broken.exitCode, 1);
    EXPECT_EQ(broken.messages.rfind("knotspan: -: ", 0), 0U) << broken.messages;
    EXPECT_FALSE(fs::exists(folder / "c.obj"));
    const std::string a = folder / "a.knotspan";
    expectWrongCall({"convert", "-", folder / "c.obj"});
    expectWrongCall({"convert", "-", folder / "c.obj", "--from", "banana"});
    expectWrongCall({"convert", a, folder / "c.obj", "--from", "step"});
    expectWrongCall({"convert", a, "-"});
    expectWrongCall({"convert", a, "-", "--to", "bpt"});
    expectWrongCall({"convert", a, "-", "--to", "obj", "--json"});
    expectWrongCall({"convert", a, "-", "--to", "obj", "-d", folder.path()});
}

TEST(ConvertCommand, TurnsMeshesIntoMeshesAndIntoNoSurfaces)
{
    const TemporaryFolder folder;
    makeSample("torus", folder / "a.knotspan");
    ASSERT_EQ(runProgram({"convert", folder / "a.knotspan", folder / "a.ply"}).exitCode, 0);
    for (const char* name : {"b.obj", "b.glb", "b.knotspan"}) {
        const ProgramRun run = runProgram({"convert", folder / "a.ply", folder / name, "--verify"});
        ASSERT_EQ(run.exitCode, 0) << run.messages;
        EXPECT_EQ(formats::read(folder / name)->meshes().begin()->second->mesh->triangles,
                  formats::read(folder / "a.ply")->meshes().begin()->second->mesh->triangles)
            << name;
    }
    expectFailure({"convert", folder / "a.ply", folder / "c.step"}, folder / "c.step");
    EXPECT_FALSE(fs::exists(folder / "c.step"));
}
