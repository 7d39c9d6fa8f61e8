// Damaged files through the program's own importer: a sentence or a model each, and this process goes on.
#include <random>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <IGESControl_Writer.hxx>
#include <gtest/gtest.h>

#include "model/formats/isolated_import.h"
#include "tests/model/formats/import_scripts.h"
#include "tests/model/formats/real_importer.h"
#include "tests/model/formats/step_solids.h"

namespace knotspan::testing {
namespace {

class HostileImports : public ::testing::Test {
protected:
    HostileImports()
    {
        const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(5, 10).Shape();
        writeStep(shape, folder_ / "good.step");
        IGESControl_Writer iges;
        iges.AddShape(shape);
        iges.Write((folder_ / "good.igs").c_str());
        BRepTools::Write(shape, (folder_ / "good.brep").c_str());
    }
    ~HostileImports() override { EXPECT_EQ(childProcesses(), 0); }

    // What reading that content says; empty where it is read.
    [[nodiscard]] std::string said(const std::string& content, const std::string& extension)
    {
        const auto path = folder_ / ("bad." + extension);
        writeFile(path, content);
        // Small files: what takes seconds hangs.
        const formats::ProcessLimits limits{std::uint64_t{1} << 30, 4, 20, std::uint64_t{1} << 30};
        auto import = formats::importIsolated(path, {}, limits);
        if (import) {
            EXPECT_FALSE(import->scene.objects().empty());
            return {};
        }
        const std::string sentence = import.error().sentence();
        EXPECT_FALSE(sentence.empty());
        EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
        EXPECT_EQ(sentence.find("is no model"), std::string::npos) << sentence;  // the importer talks sense
        crashes_ += sentence.find("crashed") != std::string::npos ? 1 : 0;
        hangs_ += sentence.find("takes longer") != std::string::npos ? 1 : 0;
        return sentence;
    }

    void expectSurvived(const std::string& extension, int changes)
    {
        const std::string whole = readFile(folder_ / ("good." + extension));
        ASSERT_EQ(said(whole, extension), "");
        for (size_t sixteenth = 0; sixteenth < 16; ++sixteenth)
            EXPECT_NE(said(whole.substr(0, whole.size() * sixteenth / 16), extension), "") << sixteenth;
        std::mt19937 random(3);
        for (int change = 0; change < changes; ++change) {
            std::string changed = whole;
            const size_t at = random() % changed.size();
            changed[at] = static_cast<char>(random());
            static_cast<void>(said(changed, extension));
        }
        RecordProperty("crashes", crashes_);
        RecordProperty("hangs", hangs_);
    }

    const RealImporter importer_;
    TemporaryFolder folder_;
    int crashes_ = 0;
    int hangs_ = 0;
};

TEST_F(HostileImports, StepIsReadOrRefused)
{
    expectSurvived("step", 100);
}

TEST_F(HostileImports, IgesIsReadOrRefused)
{
    expectSurvived("igs", 30);
}

TEST_F(HostileImports, BrepIsReadOrRefused)
{
    expectSurvived("brep", 30);
}

TEST_F(HostileImports, StepRecordsThatReferToThemselvesAreReadOrRefused)
{
    std::string text = readFile(folder_ / "good.step");
    // The first reference of every list of references becomes the record's own number.
    std::string cyclic;
    std::string number;
    for (size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '#' && (at == 0 || text[at - 1] == '\n'))
            number = text.substr(at, text.find_first_of(" =", at) - at);
        if (text[at] == '(' && at + 1 < text.size() && text[at + 1] == '#' && !number.empty()) {
            cyclic += "(" + number;
            at = text.find_first_of(",)", at) - 1;
            continue;
        }
        cyclic += text[at];
    }
    EXPECT_NE(cyclic, text);
    EXPECT_NE(said(cyclic, "step"), "");
}

TEST_F(HostileImports, AClaimedMillionPointsAndDeepNestingAreRefused)
{
    const std::string start =
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
        "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n";
    const std::string end = "ENDSEC;\nEND-ISO-10303-21;\n";
    std::string row = "(#1";
    for (int k = 1; k < 1000; ++k)
        row += ",#1";
    row += ")";
    std::string points = "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=B_SPLINE_SURFACE_WITH_KNOTS('',3,3,(" + row;
    for (int k = 1; k < 1000; ++k)
        points += "," + row;
    points += "),.UNSPECIFIED.,.F.,.F.,.F.,(4,4),(4,4),(0.,1.),(0.,1.),.UNSPECIFIED.);\n";
    EXPECT_NE(said(start + points + end, "step"), "");
    const std::string deep(200'000, '(');
    EXPECT_NE(said(start + "#1=CARTESIAN_POINT(''," + deep + "0." + std::string(200'000, ')') + ");\n" + end,
                   "step"),
              "");
}

}  // namespace
}  // namespace knotspan::testing
