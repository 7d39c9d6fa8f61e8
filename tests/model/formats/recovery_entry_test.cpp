#include "model/formats/recovery_entry.h"

#include <chrono>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "model/samples/sample_list.h"
#include "tests/child.h"
#include "tests/full_disk.h"
#include "tests/model/formats/writers.h"
#include "tests/support.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;
using formats::RecoveryEntry;
using formats::RecoveryNote;
namespace fs = std::filesystem;

RecoveryNote noteOf(const std::string& title)
{
    return {title, "/models/" + title + ".knotspan", true, 1'000'000};
}

Scene sample(const std::string& name)
{
    return findSample(name)->make();
}

bool keep(RecoveryEntry& entry, const std::string& name)
{
    const auto written = entry.write(sample(name), noteOf(name), entry.epoch());
    EXPECT_TRUE(written) << written.error().sentence();
    return written.has_value();
}

// The only one in the folder.
fs::path onlyFolderIn(const fs::path& folder)
{
    return fs::directory_iterator(folder)->path();
}

TEST(RecoveryEntry, IsFoundOnceItsProcessIsKilled)
{
    const TemporaryFolder folder;
    Child child([&] {
        const auto entry = RecoveryEntry::create(folder / "recovery");
        if (!entry || !keep(**entry, "torus") || !keep(**entry, "nine-16"))
            return 1;
        std::this_thread::sleep_for(std::chrono::minutes(1));
        return 0;
    });
    const auto kept = [&] {
        std::error_code none;
        for (const auto& path : fs::recursive_directory_iterator(folder.path(), none))
            if (path.path().filename() == "model-2.knotspan")
                return true;
        return false;
    };
    for (int k = 0; k < 2000 && !kept() && !child.hasEnded(); ++k)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_TRUE(RecoveryEntry::leftBehind(folder / "recovery").empty());  // it lives
    // The note follows the snapshot.
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    child.kill();
    const auto found = RecoveryEntry::leftBehind(folder / "recovery");
    ASSERT_EQ(found.size(), 1U);
    const auto note = found.front()->note();
    ASSERT_TRUE(note) << note.error().sentence();
    EXPECT_EQ(note->title, "nine-16");
    EXPECT_EQ(note->file, "/models/nine-16.knotspan");
    EXPECT_TRUE(note->isImported);
    EXPECT_EQ(note->seconds, 1'000'000);
    const auto scene = found.front()->read();
    ASSERT_TRUE(scene) << scene.error().sentence();
    EXPECT_TRUE(*scene == sample("nine-16"));
    EXPECT_TRUE(RecoveryEntry::leftBehind(folder / "recovery").empty());  // this process has it now
    found.front()->remove();
    EXPECT_TRUE(fs::is_empty(folder / "recovery"));
}

TEST(RecoveryEntry, HoldsOneSnapshotWholeWheneverItsProcessIsKilled)
{
    const TemporaryFolder folder;
    std::mt19937 random(8);
    std::uniform_int_distribution<int> moments(0, 40'000);
    int found = 0;
    int second = 0;
    int interrupted = 0;
    for (int kill = 0; kill < 80; ++kill) {
        Child child([&] {
            const auto entry = RecoveryEntry::create(folder.path());
            while (entry && keep(**entry, "nine-16") && keep(**entry, "torus")) {
            }
            return 1;
        });
        std::this_thread::sleep_for(std::chrono::microseconds(moments(random)));
        EXPECT_FALSE(child.hasEnded());
        child.kill();
        for (const auto& path : fs::recursive_directory_iterator(folder.path()))
            interrupted += path.path().extension() == ".saving" ? 1 : 0;
        const auto entries = RecoveryEntry::leftBehind(folder.path());
        ASSERT_LE(entries.size(), 1U);
        if (entries.empty())
            continue;
        ++found;
        const auto note = entries.front()->note();
        const auto scene = entries.front()->read();
        ASSERT_TRUE(note && scene);
        EXPECT_TRUE(*scene == sample(note->title));  // and not the other's
        second += note->title == "torus" ? 1 : 0;
        // It goes on from there.
        EXPECT_TRUE(keep(*entries.front(), "sphere"));
        EXPECT_EQ(filesIn(onlyFolderIn(folder.path())), 3U);  // lock, note, snapshot
        entries.front()->remove();
        EXPECT_TRUE(fs::is_empty(folder.path()));
    }
    EXPECT_GT(found, 20);
    EXPECT_GT(second, 5);
    EXPECT_GT(interrupted, 5);
    RecordProperty("interrupted", interrupted);
}

TEST(RecoveryEntry, WithoutASnapshotIsClearedAway)
{
    const TemporaryFolder folder;
    Child child([&] { return RecoveryEntry::create(folder.path()) ? 0 : 1; });
    EXPECT_EQ(child.wait(), 0);
    EXPECT_FALSE(fs::is_empty(folder.path()));
    fs::create_directory(folder / "no-lock-yet");
    writeFile(folder / "readme", "not ours");
    EXPECT_TRUE(RecoveryEntry::leftBehind(folder.path()).empty());
    EXPECT_EQ(filesIn(folder.path()), 1U);
    EXPECT_TRUE(RecoveryEntry::leftBehind(folder / "absent").empty());
}

TEST(RecoveryEntry, DoesNotBringBackWhatWasForgotten)
{
    const TemporaryFolder folder;
    {
        const auto entry = RecoveryEntry::create(folder.path());
        ASSERT_TRUE(entry);
        ASSERT_TRUE(keep(**entry, "torus"));
        const int before = (*entry)->epoch();
        (*entry)->forget();
        EXPECT_TRUE((*entry)->write(sample("torus"), noteOf("torus"), before));
        EXPECT_FALSE((*entry)->note());
        EXPECT_EQ(filesIn(onlyFolderIn(folder.path())), 1U);  // the lock
        ASSERT_TRUE(keep(**entry, "nine-16"));
    }
    const auto found = RecoveryEntry::leftBehind(folder.path());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front()->note()->title, "nine-16");
}

TEST(RecoveryEntry, IsNotBroughtBackByAWriteThatIsUnderWay)
{
    const TemporaryFolder folder;
    const Scene scene = sample("knot");
    for (int k = 0; k < 20; ++k) {
        const auto entry = RecoveryEntry::create(folder.path());
        ASSERT_TRUE(entry);
        std::thread writing([&] { EXPECT_TRUE((*entry)->write(scene, noteOf("knot"), 0)); });
        std::this_thread::sleep_for(std::chrono::milliseconds(3 * k));
        (*entry)->forget();
        writing.join();
        EXPECT_EQ(filesIn(onlyFolderIn(folder.path())), 1U);  // the lock
        (*entry)->remove();
    }
}

TEST(RecoveryEntry, OnAFullDiskKeepsTheSnapshotBefore)
{
    const TemporaryFolder folder;
    const auto entry = RecoveryEntry::create(folder.path());
    ASSERT_TRUE(entry);
    ASSERT_TRUE(keep(**entry, "torus"));
    for (const rlim_t room : {0, 20, 1000}) {
        Result<void> written;
        {
            const testing::FullDisk full(room);
            written = (*entry)->write(sample("nine-16"), noteOf("nine-16"), (*entry)->epoch());
        }
        ASSERT_FALSE(written);
        EXPECT_NE(written.error().sentence().find("disk has room"), std::string::npos);
        EXPECT_EQ((*entry)->note()->title, "torus");
        EXPECT_TRUE(*(*entry)->read() == sample("torus"));
        EXPECT_EQ(filesIn(onlyFolderIn(folder.path())), 3U);
    }
    EXPECT_TRUE(keep(**entry, "nine-16"));
}

TEST(RecoveryEntry, SaysWhatIsWrongWithADamagedOneAndLeavesIt)
{
    const TemporaryFolder folder;
    for (const char* const name : {"torus", "nine-16"}) {
        const auto entry = RecoveryEntry::create(folder.path());
        ASSERT_TRUE(entry && keep(**entry, name));
    }
    for (const auto& path : fs::recursive_directory_iterator(folder.path()))
        if (path.path().filename() == "model-1.knotspan")
            fs::resize_file(path, 1000);
    for (int k = 0; k < 2; ++k) {
        const auto found = RecoveryEntry::leftBehind(folder.path());
        ASSERT_EQ(found.size(), 2U);
        EXPECT_TRUE(found.front()->note());
        const auto scene = found.front()->read();
        ASSERT_FALSE(scene);
        EXPECT_NE(scene.error().sentence().find("model-1.knotspan"), std::string::npos);
    }
    for (const char* const text : {"", "{", "[]", "{}", "{\"title\": 1}",
                                   "{\"title\": \"a\", \"file\": \"\", \"imported\": false, \"seconds\": 1, "
                                   "\"snapshot\": 9999999999999}"}) {
        for (const auto& path : fs::recursive_directory_iterator(folder.path()))
            if (path.path().filename() == "model.json")
                writeFile(path, text);
        const auto found = RecoveryEntry::leftBehind(folder.path());
        ASSERT_EQ(found.size(), 2U);
        EXPECT_FALSE(found.front()->note()) << text;
        EXPECT_FALSE(found.front()->read()) << text;
    }
}

TEST(RecoveryEntry, CannotBeMadeWhereNoFolderCan)
{
    const TemporaryFolder folder;
    writeFile(folder / "file", "");
    const auto entry = RecoveryEntry::create(folder / "file/recovery");
    ASSERT_FALSE(entry);
    EXPECT_EQ(
        entry.error().sentence().rfind((folder / "file/recovery").string() + ": The folder for recovery", 0),
        0U)
        << entry.error().sentence();
}

}  // namespace
}  // namespace knotspan
