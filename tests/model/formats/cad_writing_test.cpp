// Writing STEP, IGES and BREP: what is refused, what the files say beside the shapes.
#include <gtest/gtest.h>

#include "model/cad/step_texts.h"
#include "model/formats/format_list.h"
#include "model/geometry/primitives.h"
#include "model/samples/sample_list.h"
#include "tests/model/formats/odd_scenes.h"
#include "tests/support.h"

namespace knotspan {
namespace {

const std::vector<std::string> kCad{".step", ".igs", ".brep"};

std::string refusal(const Scene& scene, const std::string& extension)
{
    const testing::TemporaryFolder folder;
    const auto written = formats::write(scene, folder / ("a" + extension));
    EXPECT_FALSE(written);
    EXPECT_FALSE(std::filesystem::exists(folder / ("a" + extension)));
    return written ? "" : written.error().what;
}

TEST(CadWriting, TheSameModelGivesTheSameBytes)
{
    for (const std::string& extension : kCad) {
        const testing::TemporaryFolder folder;
        const Scene scene = findSample("hull")->make();
        ASSERT_TRUE(formats::write(scene, folder / ("a" + extension)));
        ASSERT_TRUE(formats::write(scene, folder / ("b" + extension)));
        EXPECT_EQ(testing::readFile(folder / ("a" + extension)),
                  testing::readFile(folder / ("b" + extension)));
    }
}

TEST(CadWriting, FilesSayThatKnotspanWroteThem)
{
    const testing::TemporaryFolder folder;
    for (const std::string& extension : kCad) {
        ASSERT_TRUE(formats::write(findSample("torus")->make(), folder / ("a" + extension)));
        EXPECT_NE(testing::readFile(folder / ("a" + extension)).substr(0, 1000).find("Knotspan"),
                  std::string::npos);
    }
}

TEST(CadWriting, PrintsNothing)
{
    ::testing::internal::CaptureStdout();
    const testing::TemporaryFolder folder;
    for (const std::string& extension : kCad)
        EXPECT_TRUE(formats::write(findSample("nine-16")->make(), folder / ("a" + extension)));
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

TEST(CadWriting, FailsWithASentenceWhenTheDiskIsFull)
{
    if (!std::filesystem::exists("/dev/full"))
        GTEST_SKIP() << "no full device here";
    for (const std::string& extension : kCad) {
        const auto result = formats::find("a" + extension)->write(findSample("hull")->make(), "/dev/full");
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().sentence(),
                  "The file cannot be written. Check that the disk has room and try again.");
    }
}

TEST(CadWriting, RefusesAnEmptyModel)
{
    for (const std::string& extension : kCad)
        EXPECT_EQ(refusal(Scene(), extension), "There is nothing to write: the model has no surfaces");
}

TEST(CadWriting, RefusesWhatIsTooFarAwayOrTooSmall)
{
    Scene far;
    far.add({"far", {}, Mat4(1.0), true, sphere({0, 0, 0}, 1e60), {}});
    for (const std::string& extension : kCad)
        EXPECT_EQ(refusal(far, extension), "The control points of \"far\" are too far away to be written");
    Scene small;
    small.add({"dust", {}, Mat4(1.0), true, sphere({0, 0, 0}, 1e-8), {}});
    EXPECT_EQ(refusal(small, ".step"),
              "\"dust\" is smaller than a millionth of a millimetre, too small for STEP");
    EXPECT_EQ(refusal(small, ".igs"),
              "\"dust\" is smaller than a millionth of a millimetre, too small for IGES");
}

TEST(CadWriting, RefusesNumbersThatItsTextHasNoRoomFor)
{
    const KnotVector tiny = *KnotVector::create(1, {0, 0, 1e-120, 1e-120});
    const Scene scene = testing::sceneOf(testing::wavySurface(tiny, KnotVector::clampedUniform(1, 1), 0));
    for (const std::string& extension : kCad)
        EXPECT_EQ(refusal(scene, extension), "\"Fläche\" has numbers that OpenCASCADE cannot hold");
}

TEST(CadWriting, KeepsTheOldFileWhereTheNewOneCannotBeWritten)
{
    const testing::TemporaryFolder folder;
    testing::writeFile(folder / "a.step", "precious");
    EXPECT_FALSE(formats::write(Scene(), folder / "a.step"));
    EXPECT_EQ(testing::readFile(folder / "a.step"), "precious");
}

TEST(StepTexts, AreAsciiWithTheStandardsEscapes)
{
    EXPECT_EQ(formats::stepText("Deck 1"), "'Deck 1'");
    EXPECT_EQ(formats::stepText("It's \\ here"), "'It''s \\\\ here'");
    EXPECT_EQ(formats::stepText("Rückwand"), "'R\\X2\\00FC\\X0\\ckwand'");
    EXPECT_EQ(formats::stepText("船首"), "'\\X2\\82399996\\X0\\'");
    EXPECT_EQ(formats::stepText("ü😀"), "'\\X2\\00FC\\X0\\\\X4\\0001F600\\X0\\'");
    EXPECT_EQ(formats::stepText("two\nlines"), "'two lines'");
}

TEST(StepTexts, TakeThePlacesOfTheirStandInsOnly)
{
    formats::StepTexts texts;
    const std::string first = texts.standInFor("ü");
    const std::string second = texts.standInFor("'" + first + "'");
    EXPECT_EQ(texts.replacedIn("#1 = A('" + first + "','" + second + "','');"),
              "#1 = A('\\X2\\00FC\\X0\\','''" + first + "''','');");
    EXPECT_EQ(texts.replacedIn("'knotspan text 99'"), "'knotspan text 99'");
}

}  // namespace
}  // namespace knotspan
