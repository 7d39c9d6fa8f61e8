// Files that cannot be read at all: each is refused with one sentence that names it.
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include <gtest/gtest.h>

#include "model/formats/format_list.h"
#include "model/samples/sample_list.h"
#include "tests/support.h"

namespace knotspan {
namespace {

std::string refusal(const std::filesystem::path& path)
{
    const auto result = formats::read(path);
    return result ? "" : result.error().sentence();
}

TEST(BadFiles, ThatAreMissingAreRefused)
{
    const testing::TemporaryFolder folder;
    const auto path = folder / "none.knotspan";
    EXPECT_EQ(refusal(path), path.string() + ": There is no such file. Check the name.");
}

TEST(BadFiles, ThatAreFoldersAreRefused)
{
    const testing::TemporaryFolder folder;
    const auto path = folder / "folder.knotspan";
    std::filesystem::create_directory(path);
    EXPECT_EQ(refusal(path), path.string() + ": This is a folder, not a file. Choose a file in it.");
}

TEST(BadFiles, ThatAreEmptyAreRefused)
{
    const testing::TemporaryFolder folder;
    const auto path = folder / "empty.knotspan";
    testing::writeFile(path, "");
    EXPECT_EQ(refusal(path), path.string() + ": The file is empty. Choose another file.");
}

TEST(BadFiles, ThatMayNotBeReadAreRefused)
{
    const testing::TemporaryFolder folder;
    const auto path = folder / "secret.knotspan";
    testing::writeFile(path, "{}");
    ::chmod(path.c_str(), 0);
    if (::access(path.c_str(), R_OK) == 0)
        GTEST_SKIP() << "this user may read everything";
    EXPECT_EQ(refusal(path),
              path.string() + ": The file cannot be opened: Permission denied. Check who may read it.");
}

TEST(BadFiles, ThatAreNoFilesButPipesAreRefusedAtOnce)
{
    const testing::TemporaryFolder folder;
    const auto path = folder / "pipe.knotspan";
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    EXPECT_EQ(refusal(path), path.string() + ": This is no ordinary file. Copy its content to a file first.");
}

TEST(BadFiles, OfAnUnknownFormatAreRefusedWithTheKnownOnes)
{
    const testing::TemporaryFolder folder;
    testing::writeFile(folder / "model.xyz", "x");
    testing::writeFile(folder / "model", "x");
    EXPECT_NE(refusal(folder / "model.xyz")
                  .find("Knotspan does not know the format .xyz. Knotspan can read "
                        ".knotspan"),
              std::string::npos);
    EXPECT_NE(refusal(folder / "model").find("The name has no extension that tells the format"),
              std::string::npos);
}

TEST(BadFiles, OfTenGigabytesAreRefusedWithoutReadingThem)
{
    const testing::TemporaryFolder folder;
    const auto path = folder / "huge.knotspan";
    testing::writeFile(path, "{");
    std::error_code error;
    std::filesystem::resize_file(path, std::uintmax_t{10} << 30, error);  // a hole: it takes no room
    if (error)
        GTEST_SKIP() << "this disk has no files with holes: " << error.message();
    EXPECT_EQ(refusal(path), path.string() + ": The file is larger than 2 GiB. Split the model into several "
                                             "files.");
    std::filesystem::resize_file(path, std::uintmax_t{600} << 20);
    EXPECT_EQ(refusal(path), path.string() +
                                 ": The file is larger than the 512 MiB that a .knotspan file may "
                                 "have. Split the model into several files.");
}

TEST(BadFiles, CutOffAnywhereAreRefused)
{
    const testing::TemporaryFolder folder;
    ASSERT_TRUE(formats::write(findSample("hull")->make(), folder / "hull.knotspan"));
    const std::string whole = testing::readFile(folder / "hull.knotspan");
    const auto path = folder / "cut.knotspan";
    for (size_t part = 1; part < 64; ++part) {
        testing::writeFile(path, whole.substr(0, whole.size() * part / 64));
        EXPECT_EQ(refusal(path),
                  path.string() + ": The file ends in the middle of the model. Use another copy of it.")
            << part;
    }
    testing::writeFile(path, whole.substr(0, whole.size() - 3));
    EXPECT_NE(refusal(path), "");
}

TEST(BadFiles, OfRandomBytesAreRefused)
{
    const testing::TemporaryFolder folder;
    const auto path = folder / "noise.knotspan";
    std::string noise;
    unsigned state = 12345;
    for (int i = 0; i < 100'000; ++i) {
        state = state * 1664525u + 1013904223u;
        noise.push_back(static_cast<char>(state >> 24));
    }
    testing::writeFile(path, noise);
    EXPECT_NE(refusal(path).find("The file is damaged at line 1, column "), std::string::npos)
        << refusal(path);
}

TEST(BadFiles, WithAnyOneByteChangedAreReadOrRefusedButNeverCrash)
{
    const testing::TemporaryFolder folder;
    ASSERT_TRUE(formats::write(findSample("single-100")->make(), folder / "s.knotspan"));
    const std::string whole = testing::readFile(folder / "s.knotspan");
    const auto path = folder / "changed.knotspan";
    int refused = 0;
    for (size_t at = 0; at < whole.size(); at += 13) {
        std::string changed = whole;
        changed[at] = "\0{}[],\"-9eE.x\xff"[at % 14];
        testing::writeFile(path, changed);
        const auto result = formats::read(path);
        refused += result ? 0 : 1;
        if (!result) {
            EXPECT_NE(result.error().sentence().find(path.string() + ": "), std::string::npos);
        }
    }
    EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace knotspan
