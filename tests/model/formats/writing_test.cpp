// Writing replaces a file whole or not at all.
#include <sys/stat.h>

#include <gtest/gtest.h>

#include "model/formats/format_list.h"
#include "model/samples/sample_list.h"
#include "tests/support.h"

namespace knotspan {
namespace {
namespace fs = std::filesystem;

std::string refusal(const fs::path& path)
{
    const auto result = formats::write(findSample("sphere")->make(), path);
    return result ? "" : result.error().sentence();
}

size_t filesIn(const fs::path& folder)
{
    return static_cast<size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(Writing, LeavesOneFileAndNothingBesideIt)
{
    const testing::TemporaryFolder folder;
    EXPECT_EQ(refusal(folder / "a.knotspan"), "");
    EXPECT_EQ(refusal(folder / "a.knotspan"), "");
    EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(Writing, RefusesPlacesThatAreNoFilesWithASentenceAndLeavesNothing)
{
    const testing::TemporaryFolder folder;
    fs::create_directory(folder / "folder.knotspan");
    EXPECT_EQ(refusal(folder / "folder.knotspan"),
              (folder / "folder.knotspan").string() +
                  ": This is a folder, not a file. Choose a file's name.");
    const auto nowhere = folder / "no" / "such" / "place.knotspan";
    EXPECT_EQ(refusal(nowhere), nowhere.string() + ": There is no folder " + nowhere.parent_path().string() +
                                    ". Create it first.");
    ASSERT_EQ(::mkfifo((folder / "pipe.knotspan").c_str(), 0600), 0);
    EXPECT_EQ(refusal(folder / "pipe.knotspan"),
              (folder / "pipe.knotspan").string() + ": This is no ordinary file. Choose another name.");
    EXPECT_EQ(filesIn(folder.path()), 2u);
}

TEST(Writing, RefusesFormatsItCannotWriteWithThoseItCan)
{
    const testing::TemporaryFolder folder;
    EXPECT_NE(refusal(folder / "a.xyz").find("Knotspan can write .knotspan"), std::string::npos);
    EXPECT_NE(refusal(folder / "a").find("Knotspan can write .knotspan"), std::string::npos);
    EXPECT_EQ(filesIn(folder.path()), 0u);
}

TEST(Writing, ReplacesWhatALinkPointsToAndKeepsTheLink)
{
    const testing::TemporaryFolder folder;
    testing::writeFile(folder / "real.knotspan", "old");
    fs::create_symlink("real.knotspan", folder / "link.knotspan");
    EXPECT_EQ(refusal(folder / "link.knotspan"), "");
    EXPECT_TRUE(fs::is_symlink(folder / "link.knotspan"));
    EXPECT_TRUE(formats::read(folder / "real.knotspan"));
}

TEST(Writing, KeepsTheAccessRightsOfTheFileItReplaces)
{
    const testing::TemporaryFolder folder;
    const auto path = folder / "a.knotspan";
    testing::writeFile(path, "old");
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
    EXPECT_EQ(refusal(path), "");
    EXPECT_EQ(fs::status(path).permissions(),
              fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
}

TEST(Writing, FailsWithASentenceWhenTheDiskIsFull)
{
    if (!fs::exists("/dev/full"))
        GTEST_SKIP() << "no full device here";
    const testing::TemporaryFolder folder;
    const formats::Format* format = formats::find("a.knotspan");
    ASSERT_NE(format, nullptr);
    const auto result = format->write(findSample("hull")->make(), "/dev/full");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().sentence(),
              "The file cannot be written. Check that the disk has room and try again.");
}

}  // namespace
}  // namespace knotspan
