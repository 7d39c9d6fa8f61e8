// What is written as STEP, IGES and BREP is read as the same model.
#include <gtest/gtest.h>

#include "model/analysis/trimmed_area.h"
#include "model/formats/format_list.h"
#include "model/formats/scene_difference.h"
#include "model/samples/sample_list.h"
#include "tests/model/formats/odd_scenes.h"
#include "tests/support.h"

namespace knotspan {
namespace {

using formats::SceneDifference;

const std::vector<std::string> kCad{".step", ".igs", ".brep"};

formats::Import writtenAndRead(const Scene& scene, const std::string& extension)
{
    const testing::TemporaryFolder folder;
    const auto written = formats::write(scene, folder / ("a" + extension));
    EXPECT_TRUE(written) << (written ? "" : written.error().sentence());
    auto read = formats::readWithNotes(folder / ("a" + extension));
    EXPECT_TRUE(read) << (read ? "" : read.error().sentence());
    return read ? std::move(*read) : formats::Import();
}

SceneDifference differenceAfter(const Scene& scene, const std::string& extension)
{
    Scene back = writtenAndRead(scene, extension).scene;
    if (!formats::find("a" + extension)->namesUnits)
        back.setUnits(scene.units());
    const auto difference = formats::differenceBetween(scene, back);
    EXPECT_TRUE(difference) << (difference ? "" : difference.error().sentence());
    return difference.value_or(SceneDifference{1, 1, 1, 1, 0, 0});
}

TEST(CadRoundTrip, KeepsEverySampleInEveryFormatThatHoldsSurfaces)
{
    for (const Sample& sample : samples()) {
        const Scene scene = sample.make();
        for (const std::string extension : {".step", ".igs", ".brep", ".obj", ".knotspan"}) {
            SCOPED_TRACE(sample.name + extension);
            const SceneDifference difference = differenceAfter(scene, extension);
            EXPECT_LE(difference.largest(), 1e-12);
            EXPECT_LE(difference.knots, 0);
            EXPECT_LE(difference.weights, 0);
            EXPECT_EQ(difference.names, extension == ".brep" ? static_cast<int>(scene.objects().size()) : 0);
            if (extension != ".brep" && extension != ".obj") {
                EXPECT_EQ(difference.colours, 0);
            }
        }
    }
}

TEST(CadRoundTrip, KeepsWhatIsHardToTheLastDigits)
{
    for (const testing::OddScene& odd : testing::oddSurfaces()) {
        for (const std::string& extension : kCad) {
            SCOPED_TRACE(odd.name + " " + extension);
            EXPECT_LE(differenceAfter(odd.scene, extension).largest(), 3e-16);
        }
    }
}

TEST(CadRoundTrip, KeepsTrimLoopsCurveByCurve)
{
    for (const testing::OddScene& odd : testing::trimmedScenes()) {
        for (const std::string& extension : kCad) {
            SCOPED_TRACE(odd.name + " " + extension);
            EXPECT_LE(differenceAfter(odd.scene, extension).largest(), 3e-16);
        }
    }
}

// A hole in the middle of a square of 4 x 4, and nothing around it: what is left is 15 of 16.
TEST(CadRoundTrip, KeepsWhatIsAroundHolesThatHaveNoOuterLoop)
{
    const KnotVector knots = KnotVector::clampedUniform(1, 1);
    const auto square =
        NurbsSurface::create(knots, knots, {{{0, 0, 0}}, {{0, 4, 0}}, {{4, 0, 0}}, {{4, 4, 0}}}).value();
    const std::vector<TrimPoint> corners{
        {{0.375, 0.375}}, {{0.375, 0.625}}, {{0.625, 0.625}}, {{0.625, 0.375}}, {{0.375, 0.375}}};
    const TrimLoop hole{false, {TrimCurve::create(KnotVector::clampedUniform(1, 4), corners).value()}};
    Scene scene;
    scene.add({.name = "plate", .surface = square, .trimLoops = {hole}});
    for (const std::string extension : {".step", ".igs", ".brep", ".obj", ".knotspan"}) {
        SCOPED_TRACE(extension);
        EXPECT_LE(differenceAfter(scene, extension).largest(), 1e-12);
        const Scene back = writtenAndRead(scene, extension).scene;
        ASSERT_EQ(back.objects().size(), 1U);
        const SceneObject& object = *back.objects().begin()->second;
        EXPECT_NEAR(trimmedArea(object.surface, object.trimLoops, object.transform).value, 15, 1e-9);
    }
}

TEST(CadRoundTrip, NamesTheFilesUnitAndComesBackInMillimetres)
{
    for (const std::string unit : {"um", "mm", "cm", "m", "km", "in", "ft", "mi", "mil", "uin"}) {
        Scene scene = testing::sceneOf(
            testing::wavySurface(KnotVector::clampedUniform(3, 2), KnotVector::clampedUniform(2, 2), 1));
        scene.setUnits(unit);
        for (const std::string& extension : kCad) {
            SCOPED_TRACE(unit + extension);
            const formats::Import back = writtenAndRead(scene, extension);
            EXPECT_EQ(back.scene.units(), "mm");
            EXPECT_EQ(back.report.fileUnits, extension == ".brep" ? "" : unit);
            const auto difference = formats::differenceBetween(scene, back.scene);
            ASSERT_TRUE(difference);
            EXPECT_LE(difference->largest(), 5e-16);
        }
    }
}

TEST(CadRoundTrip, TakesAUnitThatNobodyKnowsForMillimetres)
{
    Scene scene = findSample("nine-16")->make();
    scene.setUnits("parsec");
    const formats::Import back = writtenAndRead(scene, ".step");
    EXPECT_EQ(back.report.fileUnits, "mm");
    scene.setUnits("mm");
    EXPECT_LE(formats::differenceBetween(scene, back.scene).value().largest(), 0);
}

TEST(CadRoundTrip, KeepsNamesInEveryScript)
{
    const std::vector<std::string> names{
        "Spant № 3 \"Bug\" 船 \\",
        "It's",
        "a''b",
        "\\X2\\00FC\\X0\\",
        "emoji 😀🚀 x",
        "knotspan text 1",
        "same",
        "same",
        "a name longer than the seventy-two characters that OpenCASCADE puts on "
        "a line of a STEP file, für immer und ewig und noch länger"};
    Scene scene;
    for (const std::string& name : names)
        scene.add(
            {name, {}, Mat4(1.0), true, findSample("single-100")->make().find(ObjectId{0})->surface, {}});
    for (const std::string extension : {".step", ".igs"}) {
        SCOPED_TRACE(extension);
        EXPECT_EQ(differenceAfter(scene, extension).names, 0);
    }
}

TEST(CadRoundTrip, CallsObjectsWithoutNamesFaces)
{
    const NurbsSurface surface = findSample("single-100")->make().find(ObjectId{0})->surface;
    Scene scene;
    scene.add({"", {}, Mat4(1.0), true, surface, {}});
    scene.add({"two\nlines", {}, Mat4(1.0), true, surface, {}});
    for (const std::string extension : {".step", ".igs"}) {
        const Scene back = writtenAndRead(scene, extension).scene;
        ASSERT_EQ(back.objects().size(), 2u);
        EXPECT_EQ(back.find(ObjectId{0})->name, "Face 1");
        EXPECT_EQ(back.find(ObjectId{1})->name, "two lines");
    }
}

// What other programs made, read and written again: the trim curves that CAD systems really make.
TEST(CadRoundTrip, KeepsRealModels)
{
    KNOTSPAN_NEED_MODELS(folder);
    for (const std::string name : {"NIST_MBE_PMI_3.stp", "screw.step", "ap214_mapped_items.stp",
                                   "hammer.iges", "occt_shell1.step", "gismo_duck_brep.obj"}) {
        const auto model = formats::read(*folder / name);
        ASSERT_TRUE(model) << model.error().sentence();
        for (const std::string& extension : kCad) {
            SCOPED_TRACE(name + extension);
            EXPECT_LE(differenceAfter(*model, extension).largest(), 1e-15);
        }
    }
}

}  // namespace
}  // namespace knotspan
