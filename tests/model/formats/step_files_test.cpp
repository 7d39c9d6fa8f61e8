#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gtest/gtest.h>

#include "model/cad/step_format.h"
#include "tests/model/formats/step_solids.h"
#include "tests/support.h"

namespace fs = std::filesystem;
using namespace knotspan;
using namespace knotspan::testing;

namespace {

struct Expected {
    size_t faces = 0;
    size_t ksQuads = 0;
};

// The STEP files of the manifest: name, what OpenCASCADE counted.
std::map<std::string, Expected> manifest(const fs::path& folder)
{
    std::map<std::string, Expected> rows;
    std::istringstream lines(readFile(folder / "manifest.tsv"));
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> columns;
        std::istringstream text(line);
        for (std::string column; std::getline(text, column, '\t');)
            columns.push_back(column);
        if (columns.size() < 12 || (columns[1] != "STEP" && columns[1] != "STP"))
            continue;
        rows[columns[0]] = {std::stoul(columns[6]), columns[11].empty() ? 0 : std::stoul(columns[11])};
    }
    return rows;
}

// What the function wrote to standard output, which belongs to data.
template <class Function>
std::string outputOf(const Function& function)
{
    ::testing::internal::CaptureStdout();
    function();
    return ::testing::internal::GetCapturedStdout();
}

void expectRefusedQuietly(const fs::path& path)
{
    const std::string output = outputOf([&] {
        const auto import = formats::readStep(path);
        ASSERT_FALSE(import.has_value()) << path;
        EXPECT_FALSE(import.error().what.empty());
        EXPECT_EQ(import.error().sentence().find('\n'), std::string::npos);
    });
    EXPECT_EQ(output, "");
}

}  // namespace

TEST(StepFiles, EveryRealFileGivesTheFacesOfItsManifestOrIsRefusedWithASentence)
{
    KNOTSPAN_NEED_MODELS(folder);
    const auto rows = manifest(*folder);
    ASSERT_FALSE(rows.empty());
    // Where our count is another than the manifest's, and why.
    const std::map<std::string, size_t> ours{
        // Faces that are a part of a B-spline surface are cut to it; the manifest counts the whole surface.
        {"NIST_MBE_PMI_11.stp", 26},        {"NIST_MBE_PMI_3.stp", 154},   {"NIST_MBE_PMI_5.stp", 295},
        {"ap214_nurbs_native_seam.stp", 2}, {"ap214_mapped_items.stp", 8},  // four faces, each placed twice
        {"occt_shell1.step", 99},  // unclamped: the manifest counts the knots outside the domain, too
    };
    for (const auto& row : rows) {
        const std::string& name = row.first;
        const Expected& expected = row.second;
        SCOPED_TRACE(name);
        std::optional<Result<formats::Import>> import;
        const std::string output = outputOf([&] { import = formats::readStep(*folder / name); });
        EXPECT_EQ(output, "");
        if (expected.faces == 0) {
            EXPECT_FALSE(import->has_value());
            continue;
        }
        ASSERT_TRUE(import->has_value()) << import->error().sentence();
        const Scene& scene = (*import)->scene;
        EXPECT_EQ(scene.objects().size(), expected.faces);
        const auto other = ours.find(name);
        EXPECT_EQ(scene.ksQuadCount(), other == ours.end() ? expected.ksQuads : other->second);
        EXPECT_EQ((*import)->report.exact, (*import)->report.faces);
        EXPECT_EQ((*import)->report.untrimmed, 0);
        // Beside its unit there is nothing to say.
        EXPECT_EQ((*import)->notes.size(), (*import)->report.fileUnits == "mm" ? 0U : 1U)
            << ::testing::PrintToString((*import)->notes);
    }
}

TEST(StepFiles, ATruncatedFileIsRefusedQuietly)
{
    KNOTSPAN_NEED_MODELS(models);
    const TemporaryFolder folder;
    const std::string whole = readFile(*models / "screw.step");
    for (size_t sixteenth = 0; sixteenth < 16; ++sixteenth) {
        writeFile(folder / "cut.step", whole.substr(0, whole.size() * sixteenth / 16));
        expectRefusedQuietly(folder / "cut.step");
    }
}

TEST(StepFiles, AFileWithoutItsMiddleIsReadOrRefusedQuietly)
{
    KNOTSPAN_NEED_MODELS(models);
    const TemporaryFolder folder;
    const std::string whole = readFile(*models / "screw.step");
    for (size_t sixteenth = 1; sixteenth < 16; ++sixteenth) {
        writeFile(folder / "hole.step", whole.substr(0, whole.size() * sixteenth / 16) +
                                            whole.substr(whole.size() * (sixteenth + 1) / 17));
        const std::string output = outputOf([&] {
            const auto import = formats::readStep(folder / "hole.step");
            EXPECT_TRUE(import.has_value() || !import.error().what.empty());
        });
        EXPECT_EQ(output, "");
    }
}

TEST(StepFiles, ACurveOnASurfaceThatIsMissingIsRefusedBeforeOpenCascadeCrashesOnIt)
{
    KNOTSPAN_NEED_MODELS(models);
    const TemporaryFolder folder;
    std::string text = readFile(*models / "screw.step");
    const std::string reference = "DEFINITIONAL_REPRESENTATION('',(#798)";
    const size_t place = text.find(reference);
    ASSERT_NE(place, std::string::npos);
    writeFile(folder / "pcurve.step",
              text.replace(place, reference.size(), "DEFINITIONAL_REPRESENTATION('',(#1156)"));
    expectRefusedQuietly(folder / "pcurve.step");
}

TEST(StepFiles, RandomBytesAreRefusedQuietly)
{
    const TemporaryFolder folder;
    std::mt19937 random(7);
    for (int round = 0; round < 8; ++round) {
        std::string bytes(4000, '\0');
        for (char& byte : bytes)
            byte = static_cast<char>(random());
        writeFile(folder / "noise.step", bytes);
        expectRefusedQuietly(folder / "noise.step");
        // With the frame of a STEP file around it, OpenCASCADE gets to see it.
        writeFile(folder / "framed.step", "ISO-10303-21;\n" + bytes + "\nEND-ISO-10303-21;\n");
        expectRefusedQuietly(folder / "framed.step");
    }
}

TEST(StepFiles, WhatIsNoFileIsRefusedQuietly)
{
    const TemporaryFolder folder;
    expectRefusedQuietly(folder.path());
    expectRefusedQuietly(folder / "absent.step");
    writeFile(folder / "empty.step", "");
    expectRefusedQuietly(folder / "empty.step");
    writeFile(folder / "header.step",
              "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
              "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n");
    expectRefusedQuietly(folder / "header.step");
}

TEST(StepFiles, ReadingTwiceGivesEqualScenes)
{
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(2, 7).Solid();
    EXPECT_EQ(throughStep(cylinder).scene, throughStep(cylinder).scene);
}
