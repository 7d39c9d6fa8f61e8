// A save that is killed at any moment leaves the old file or the new one, whole, and no litter that grows.
#include <chrono>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "model/files/file_replacement.h"
#include "tests/child.h"
#include "tests/model/formats/writers.h"
#include "tests/support.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;
namespace fs = std::filesystem;
using std::chrono::microseconds;
using std::chrono::steady_clock;

// Saves one model, then the other, until it is killed.
int saveForEver(const Writer& writer, const fs::path& path)
{
    while (true)
        for (const Model model : {Model::other, Model::one})
            if (!writer.write(model, path))
                return 1;
}

struct Killed {
    int kills = 0;
    int one = 0;
    int other = 0;
    int broken = 0;
    int interrupted = 0;  // where something half-written lay beside
    size_t mostFiles = 0;
    int failed = 0;  // saves that failed before they were killed
};

class InterruptedWriting : public ::testing::Test {
protected:
    // How long a save of that writer takes.
    [[nodiscard]] microseconds prepare(const Writer& writer)
    {
        const auto start = steady_clock::now();
        EXPECT_TRUE(writer.write(Model::one, references_ / ("one." + writer.extension)));
        const auto taken = steady_clock::now() - start;
        EXPECT_TRUE(writer.write(Model::other, references_ / ("other." + writer.extension)));
        EXPECT_TRUE(writer.write(Model::one, fileOf(writer)));
        return std::chrono::duration_cast<microseconds>(taken);
    }
    [[nodiscard]] fs::path fileOf(const Writer& writer) const
    {
        return folder_ / ("model." + writer.extension);
    }

    [[nodiscard]] Killed kill(const Writer& writer, int times)
    {
        const microseconds usual = prepare(writer);
        std::uniform_int_distribution<std::int64_t> moments(0, 2000 + 3 * usual.count());
        Killed killed;
        for (; killed.kills < times; ++killed.kills) {
            Child child([&] { return saveForEver(writer, fileOf(writer)); });
            std::this_thread::sleep_for(microseconds(moments(random_)));
            killed.failed += child.hasEnded() ? 1 : 0;
            child.kill();
            const bool one = isWhole(fileOf(writer), references_ / ("one." + writer.extension));
            const bool other = !one && isWhole(fileOf(writer), references_ / ("other." + writer.extension));
            killed.one += one ? 1 : 0;
            killed.other += other ? 1 : 0;
            killed.broken += one || other ? 0 : 1;
            killed.mostFiles = std::max(killed.mostFiles, filesIn(folder_.path()));
            killed.interrupted += filesIn(folder_.path()) > 1 ? 1 : 0;
        }
        EXPECT_TRUE(writer.write(Model::one, fileOf(writer)));
        return killed;
    }

    TemporaryFolder folder_;
    TemporaryFolder references_;
    std::mt19937 random_{8};
};

TEST_F(InterruptedWriting, LeavesTheOldFileOrTheNewOneWhole)
{
    const Writer writer = writers().front();
    ASSERT_EQ(writer.extension, "knotspan");
    const Killed killed = kill(writer, 150);
    EXPECT_EQ(killed.broken, 0);
    EXPECT_EQ(killed.failed, 0);
    // The moments were such that both could be.
    EXPECT_GT(killed.one, 0);
    EXPECT_GT(killed.other, 0);
    EXPECT_GT(killed.interrupted, 10);
    RecordProperty("interrupted", killed.interrupted);
}

TEST_F(InterruptedWriting, LeavesAtMostOneFileBesideWhichTheNextSaveRemoves)
{
    const Killed killed = kill(writers().front(), 40);
    EXPECT_GT(killed.interrupted, 3);
    EXPECT_EQ(killed.mostFiles, 2U);
    EXPECT_EQ(filesIn(folder_.path()), 1U);
}

TEST_F(InterruptedWriting, SparesTheOldFileInEveryFormat)
{
    for (const Writer& writer : writers()) {
        const Killed killed = kill(writer, 12);
        EXPECT_EQ(killed.broken, 0) << writer.name;
        EXPECT_EQ(killed.failed, 0) << writer.name;
        EXPECT_EQ(killed.mostFiles, filesIn(folder_.path()) + (killed.interrupted > 0 ? 1 : 0))
            << writer.name;
        fs::remove(fileOf(writer));
        EXPECT_EQ(filesIn(folder_.path()), 0U) << writer.name;
    }
}

TEST_F(InterruptedWriting, ProcessesThatSaveTheSameFileLeaveEachOthersAlone)
{
    const Writer writer = writers().front();
    static_cast<void>(prepare(writer));
    std::uniform_int_distribution<std::int64_t> moments(0, 30'000);
    for (int round = 0; round < 15; ++round) {
        const auto work = [&] { return saveForEver(writer, fileOf(writer)); };
        Child first(work);
        Child second(work);
        Child third(work);
        std::this_thread::sleep_for(microseconds(moments(random_)));
        third.kill();
        std::this_thread::sleep_for(microseconds(moments(random_)));
        EXPECT_FALSE(first.hasEnded());  // which it does where a save fails
        EXPECT_FALSE(second.hasEnded());
        first.kill();
        second.kill();
        EXPECT_TRUE(isWhole(fileOf(writer), references_ / "one.knotspan") ||
                    isWhole(fileOf(writer), references_ / "other.knotspan"));
    }
    EXPECT_TRUE(writer.write(Model::one, fileOf(writer)));
    EXPECT_EQ(filesIn(folder_.path()), 1U);
}

TEST_F(InterruptedWriting, AnExceptionLeavesNothingBeside)
{
    writeFile(folder_ / "model.txt", "old");
    const auto throwing = [](const fs::path&) -> Result<void> { throw std::bad_alloc(); };
    EXPECT_THROW(static_cast<void>(formats::replaceFile(folder_ / "model.txt", throwing)), std::bad_alloc);
    EXPECT_EQ(readFile(folder_ / "model.txt"), "old");
    EXPECT_EQ(filesIn(folder_.path()), 1U);
}

TEST_F(InterruptedWriting, TakesNoFileOfTheUsersForLeftBehind)
{
    const Writer writer = writers().front();
    for (const char* const name : {".model.knotspan", ".model.knotspan.backup", "model.knotspan.saving",
                                   ".other.knotspan.saving", ".model.knotspan.saving.txt"})
        writeFile(folder_ / name, "mine");
    EXPECT_TRUE(writer.write(Model::one, fileOf(writer)));
    EXPECT_EQ(filesIn(folder_.path()), 6U);
}

}  // namespace
}  // namespace knotspan
