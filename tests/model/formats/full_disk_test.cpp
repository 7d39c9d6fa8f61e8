// A save on a full disk fails with a sentence; the old file stays, bit for bit, and nothing lies beside it.
#include <gtest/gtest.h>

#include <sched.h>
#include <sys/mount.h>

#include "tests/child.h"
#include "tests/full_disk.h"
#include "tests/model/formats/writers.h"
#include "tests/support.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;
namespace fs = std::filesystem;

TEST(FullDisk, LeavesTheOldFileInEveryFormat)
{
    for (const Writer& writer : writers()) {
        const TemporaryFolder folder;
        const fs::path path = folder / ("model." + writer.extension);
        ASSERT_TRUE(writer.write(Model::one, path)) << writer.name;
        const rlim_t size = fs::file_size(path);
        writeFile(path, "the old file");
        for (const rlim_t room : {rlim_t{0}, rlim_t{1}, size / 2, size - 1}) {
            Result<void> written;
            {
                const testing::FullDisk full(room);
                written = writer.write(Model::one, path);
            }
            ASSERT_FALSE(written) << writer.name << " " << room << " of " << size;
            const std::string sentence = written.error().sentence();
            EXPECT_EQ(sentence.rfind(path.string() + ": The ", 0), 0U) << sentence;
            EXPECT_FALSE(written.error().remedy.empty()) << sentence;
            EXPECT_EQ(readFile(path), "the old file") << writer.name << " " << room;
            EXPECT_EQ(filesIn(folder.path()), 1U) << writer.name << " " << room;
        }
        EXPECT_TRUE(writer.write(Model::one, path)) << writer.name;
    }
}

// A disk of this process's own; false where this user may not have one.
bool mountSmallDisk(const fs::path& place)
{
    if (::unshare(CLONE_NEWNS) != 0 && ::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0)
        return false;
    // Its comings and goings stay here.
    return ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
           ::mount("small", place.c_str(), "tmpfs", 0, "size=64k") == 0;
}

// 0: as it should be; otherwise the number of what is not.
int saveUntilFull(const fs::path& disk, const fs::path& said)
{
    const auto writer = writers().front();
    const fs::path path = disk / "model.knotspan";
    writeFile(path, "the old file");
    writeFile(disk / "filler", std::string(size_t{56} << 10, 'x'));
    const auto written = writer.write(Model::one, path);
    if (written)
        return 1;
    writeFile(said, written.error().sentence());
    if (readFile(path) != "the old file")
        return 2;
    if (filesIn(disk) != 2)
        return 3;
    fs::remove(disk / "filler");
    const fs::path reference = said.parent_path() / "reference.knotspan";
    const bool both = writer.write(Model::one, path) && writer.write(Model::one, reference);
    return both && isWhole(path, reference) && filesIn(disk) == 1 ? 0 : 4;
}

TEST(FullDisk, LeavesTheOldFileOnARealOneToo)
{
    constexpr int kNoDisk = 50;
    const TemporaryFolder folder;
    fs::create_directory(folder / "disk");
    Child child([&] {
        return mountSmallDisk(folder / "disk") ? saveUntilFull(folder / "disk", folder / "said") : kNoDisk;
    });
    const int result = child.wait();
    if (result == kNoDisk)
        GTEST_SKIP() << "this user may not mount a small disk: run this test as root";
    EXPECT_EQ(result, 0);
    EXPECT_EQ(readFile(folder / "said"),
              (folder / "disk/model.knotspan").string() +
                  ": The file cannot be written. Check that the disk has room and try again.");
}

}  // namespace
}  // namespace knotspan
