#include <sstream>

#include <gtest/gtest.h>

#include "model/formats/bpt_format.h"
#include "model/formats/format_list.h"
#include "tests/support.h"

namespace knotspan {
namespace {

// Point (i, j) lies at (i, j, i * j + patch).
std::string patches(int count, int degreeU = 3, int degreeV = 3)
{
    std::ostringstream text;
    text << count << '\n';
    for (int k = 0; k < count; ++k) {
        text << degreeU << ' ' << degreeV << '\n';
        for (int i = 0; i <= degreeU; ++i)
            for (int j = 0; j <= degreeV; ++j)
                text << i << ' ' << j << ' ' << i * j + k << '\n';
    }
    return text.str();
}

std::string refusal(const std::string& text)
{
    const auto import = formats::sceneFromBpt(text);
    return import ? "" : import.error().sentence();
}

// One patch, with another word instead of the digit at `place`.
std::string with(size_t place, const std::string& word)
{
    const std::string text = patches(1);
    return text.substr(0, place) + word + text.substr(place + 1);
}

TEST(Bpt, GivesEachPatchAsASurface)
{
    const testing::TemporaryFolder folder;
    testing::writeFile(folder / "a.bpt", patches(3));
    const auto scene = formats::read(folder / "a.bpt");
    ASSERT_TRUE(scene) << scene.error().sentence();
    ASSERT_EQ(scene->objects().size(), 3u);
    int k = 0;
    for (const auto& [id, object] : scene->objects()) {
        EXPECT_EQ(object->name, std::string("Patch ") + static_cast<char>('1' + k));
        EXPECT_EQ(object->surface.knotsU(), KnotVector::clampedUniform(3, 1));
        EXPECT_EQ(object->surface.knotsV(), KnotVector::clampedUniform(3, 1));
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                EXPECT_EQ(object->surface.controlPoint(i, j), (ControlPoint{Vec3(i, j, i * j + k), 1}));
        ++k;
    }
}

TEST(Bpt, MayHaveOtherDegreesAndLineEnds)
{
    std::string text;
    for (const char c : patches(2, 2, 5))
        text += c == '\n' ? "\r\n" : std::string(1, c);
    const auto import = formats::sceneFromBpt(text);
    ASSERT_TRUE(import) << import.error().sentence();
    const NurbsSurface& surface = import->scene.find(ObjectId{1})->surface;
    EXPECT_EQ(surface.degreeU(), 2);
    EXPECT_EQ(surface.degreeV(), 5);
    EXPECT_EQ(surface.controlPoint(2, 5).position, Vec3(2, 5, 11));
}

TEST(Bpt, IsRefusedWithTheLineWhereItIsNone)
{
    const std::string again = ". Export or copy the model again.";
    EXPECT_EQ(refusal(""), "line 1: The file ends where The number of patches should stand" + again);
    EXPECT_EQ(refusal("0"),
              "line 1: The number of patches is no whole number from 1 to 1000000, but \"0\"" + again);
    EXPECT_EQ(refusal("x"),
              "line 1: The number of patches is no whole number from 1 to 1000000, but \"x\"" + again);
    EXPECT_EQ(refusal("1000000\n3 3\n"),
              "line 1: The file says that it has 1000000 patches, but it is too short for them" + again);
    EXPECT_EQ(refusal(with(2, "0")),
              "line 2: Patch 1's degree is no whole number from 1 to 15, but \"0\"" + again);
    EXPECT_EQ(refusal(patches(1) + "1"),
              "line 19: There is more behind the 1 patches that the file says it has" + again);
    EXPECT_EQ(refusal(with(0, "2") + patches(1).substr(2, 30)),
              "line 24: The file ends where Patch 2's next coordinate should stand" + again);
    EXPECT_EQ(refusal(with(6, "nan")), "line 3: The coordinate is no finite number, but \"nan\"" + again);
    EXPECT_EQ(refusal(with(6, "1e400")), "line 3: The coordinate is no finite number, but \"1e400\"" + again);
}

}  // namespace
}  // namespace knotspan
