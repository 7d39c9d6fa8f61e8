// The program itself as the importer: what comes through it is what the reader gives, to the last bit.
#include <atomic>
#include <chrono>
#include <map>
#include <random>
#include <thread>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <IGESControl_Writer.hxx>
#include <gtest/gtest.h>

#include "model/cad/brep_format.h"
#include "model/cad/iges_format.h"
#include "model/formats/format_list.h"
#include "tests/model/formats/import_scripts.h"
#include "tests/model/formats/real_importer.h"
#include "tests/model/formats/step_solids.h"

namespace knotspan::testing {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

// A box with a round hole, a torus beside it: trimmed, rational, closed.
TopoDS_Shape drilledBox()
{
    const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(gp_Ax2({5, 5, -1}, {0, 0, 1}), 2.5, 12).Shape();
    return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10, 10, 10).Shape(), drill).Shape();
}

void expectSame(const Result<formats::Import>& apart, const Result<formats::Import>& here)
{
    ASSERT_EQ(apart.has_value(), here.has_value())
        << (apart ? here.error().sentence() : apart.error().sentence());
    if (!apart) {
        EXPECT_EQ(apart.error().what, here.error().what);
        EXPECT_EQ(apart.error().remedy, here.error().remedy);
        return;
    }
    EXPECT_TRUE(apart->scene == here->scene);  // compares every double
    EXPECT_EQ(apart->scene.units(), here->scene.units());
    EXPECT_EQ(apart->notes, here->notes);
    EXPECT_EQ(apart->report.faces, here->report.faces);
    EXPECT_EQ(apart->report.exact, here->report.exact);
    EXPECT_EQ(apart->report.approximated, here->report.approximated);
    EXPECT_EQ(apart->report.refused, here->report.refused);
    EXPECT_EQ(apart->report.untrimmed, here->report.untrimmed);
    EXPECT_EQ(apart->report.approximationError, here->report.approximationError);
    EXPECT_EQ(apart->report.refusals.size(), here->report.refusals.size());
    EXPECT_EQ(apart->report.fileUnits, here->report.fileUnits);
    EXPECT_GT(apart->report.seconds, 0);
    EXPECT_GT(here->report.seconds, 0);
    EXPECT_GT(apart->report.peakBytes, 1U << 20);  // of a process that did something
    EXPECT_LT(apart->report.peakBytes, std::uint64_t{4} << 30);
    EXPECT_EQ(here->report.peakBytes, 0U);
}

// Through formats::readWithNotes, in the other process and in this one.
void expectSameApart(const std::filesystem::path& path)
{
    SCOPED_TRACE(path.filename());
    const auto here = formats::readWithNotes(path);
    const RealImporter importer;
    ASSERT_TRUE(formats::isReadApart(path));
    expectSame(formats::readWithNotes(path), here);
    EXPECT_EQ(childProcessesLeft(), 0);
}

TEST(ImportWorker, GivesWhatTheReaderGivesToTheBit)
{
    const TemporaryFolder folder;
    const TopoDS_Shape shape = drilledBox();
    writeStep(shape, folder / "box.step");
    writeStep(BRepPrimAPI_MakeTorus(7, 2).Shape(), folder / "torus.step");
    IGESControl_Writer iges;
    iges.AddShape(shape);
    ASSERT_TRUE(iges.Write((folder / "box.igs").c_str()));
    ASSERT_TRUE(BRepTools::Write(shape, (folder / "box.brep").c_str()));
    for (const char* const name : {"box.step", "torus.step", "box.igs", "box.brep"})
        expectSameApart(folder / name);
}

TEST(ImportWorker, StepIgesAndBrepOfOneSolidGiveTheSameFaces)
{
    const TemporaryFolder folder;
    const TopoDS_Shape shape = drilledBox();
    IGESControl_Writer iges;
    iges.AddShape(shape);
    ASSERT_TRUE(iges.Write((folder / "box.igs").c_str()));
    ASSERT_TRUE(BRepTools::Write(shape, (folder / "box.brep").c_str()));
    const formats::Import step = throughStep(shape);
    const auto fromIges = formats::readIges(folder / "box.igs");
    const auto fromBrep = formats::readBrep(folder / "box.brep");
    ASSERT_TRUE(fromIges) << fromIges.error().sentence();
    ASSERT_TRUE(fromBrep) << fromBrep.error().sentence();
    EXPECT_EQ(step.report.faces, 7);
    for (const formats::Import* import : {&*fromIges, &*fromBrep}) {
        EXPECT_EQ(import->scene.objects().size(), 7U);
        EXPECT_EQ(import->report.exact, 7);
        EXPECT_NEAR(import->scene.bounds().diagonal(), step.scene.bounds().diagonal(), 1e-6);
    }
}

TEST(ImportWorker, RefusalsAreTheReadersOwn)
{
    const TemporaryFolder folder;
    writeFile(folder / "noise.step", "ISO-10303-21; nonsense");
    writeFile(folder / "text.igs", "hello");
    writeFile(folder / "text.brep", "hello");
    for (const char* const name : {"noise.step", "text.igs", "text.brep"})
        expectSameApart(folder / name);
}

TEST(ImportWorker, RealFilesComeThroughToTheBit)
{
    KNOTSPAN_NEED_MODELS(models);
    for (const char* const name :
         {"screw.step", "NIST_MBE_PMI_11.stp", "wing128.igs", "hammer.iges", "newell_teacup.igs",
          "ge6_wire.igs", "terrain.brep", "ap214_csg_invalid.stp"})
        expectSameApart(*models / name);
}

TEST(ImportWorker, RealIgesFilesGiveTheFacesOfTheirManifestExactly)
{
    KNOTSPAN_NEED_MODELS(models);
    const std::map<std::string, int> faces{{"newell_teacup.igs", 26}, {"DTMB-5415_bulbous_bow.iges", 1},
                                           {"wigley.iges", 1},        {"wing.iges", 4},
                                           {"bearing.iges", 213},     {"hammer.iges", 45},
                                           {"wing128.igs", 2},        {"pipe.iges", 4},
                                           {"D150_fuselage.igs", 238}};
    const RealImporter importer;
    for (const auto& [name, count] : faces) {
        const auto import = formats::readWithNotes(*models / name);
        ASSERT_TRUE(import) << import.error().sentence();
        EXPECT_EQ(import->report.faces, count) << name;
        EXPECT_EQ(import->report.exact, count) << name;
        EXPECT_EQ(import->scene.objects().size(), static_cast<size_t>(count)) << name;
    }
}

TEST(ImportWorker, TellsHowFarItIs)
{
    KNOTSPAN_NEED_MODELS(models);
    const RealImporter importer;
    std::vector<std::string> stages;
    double last = -1;
    const auto tell = [&](const std::string& stage, double done) {
        stages.push_back(stage);
        if (done >= 0) {
            EXPECT_GE(done, last - 1e-9);
            EXPECT_LE(done, 1);
            last = done;
        }
    };
    ASSERT_TRUE(formats::readWithNotes(*models / "NIST_MBE_PMI_5.stp", {tell, nullptr}));
    ASSERT_FALSE(stages.empty());
    EXPECT_EQ(stages.front(), "Reading");
    EXPECT_NE(stages.back().find("Converting face "), std::string::npos) << stages.back();
}

TEST(ImportWorker, CancelActsAtOnceAtAnyTime)
{
    KNOTSPAN_NEED_MODELS(models);
    const RealImporter importer;
    std::mt19937 random(11);
    milliseconds slowest{};
    int stopped = 0;
    for (int round = 0; round < 50; ++round) {
        std::atomic<bool> cancelled = false;
        steady_clock::time_point asked;
        const milliseconds after(std::uniform_int_distribution<>(0, 300)(random));
        std::thread user([&] {
            std::this_thread::sleep_for(after);
            asked = steady_clock::now();
            cancelled = true;
        });
        const auto import = formats::readWithNotes(*models / "bearing.iges", {{}, &cancelled});
        const auto ended = steady_clock::now();
        user.join();
        if (import)
            continue;  // it was quicker
        ++stopped;
        EXPECT_NE(import.error().what.find("cancelled"), std::string::npos) << import.error().sentence();
        slowest = std::max(slowest, std::chrono::duration_cast<milliseconds>(ended - asked));
    }
    EXPECT_GT(stopped, 0);
    EXPECT_LT(slowest, std::chrono::seconds(kHang));  // two hundred milliseconds are the promise
    RecordProperty("slowest_ms", static_cast<int>(slowest.count()));
    EXPECT_EQ(childProcessesLeft(), 0);
}

TEST(ImportWorker, IsNotAskedForFormatsOfOurOwn)
{
    const RealImporter importer;
    EXPECT_FALSE(formats::isReadApart("model.knotspan"));
    EXPECT_FALSE(formats::isReadApart("model.obj"));
    EXPECT_TRUE(formats::isReadApart("MODEL.STP"));
    EXPECT_TRUE(formats::isReadApart("model.iges"));
    EXPECT_TRUE(formats::isReadApart("model.brep"));
}

}  // namespace
}  // namespace knotspan::testing
