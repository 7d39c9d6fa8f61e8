// Windows that are killed, and what the next one offers.
#include <chrono>
#include <random>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "model/formats/format_list.h"
#include "model/formats/recovery_entry.h"
#include "model/samples/sample_list.h"
#include "tests/child.h"
#include "tests/support.h"
#include "tests/ui/recovery/edited_window.h"
#include "tests/ui/recovery/recovering_window.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;
using formats::RecoveryEntry;
namespace fs = std::filesystem;
using std::chrono::milliseconds;

class KilledWindow : public ::testing::Test {
protected:
    KilledWindow()
    {
        EXPECT_TRUE(formats::write(opened_, file_));
        before_ = readFile(file_);
    }

    [[nodiscard]] std::unique_ptr<Child> editing(int steps) const
    {
        return std::make_unique<Child>([&] {
            ::setenv("TMPDIR", folder_.path().c_str(), 1);  // nobody tidies up after it
            ::execl("/proc/self/exe", "test", "edit", file_.c_str(), place_.c_str(),
                    std::to_string(steps).c_str(), nullptr);
            return 127;
        });
    }

    // The notes in the folder: one a process that has a snapshot.
    [[nodiscard]] std::vector<fs::path> notes() const
    {
        std::vector<fs::path> found;
        std::error_code none;
        for (const auto& path : fs::recursive_directory_iterator(place_, none))
            if (path.path().filename() == "model.json")
                found.push_back(path.path());
        return found;
    }
    template <class Condition>
    static void waitUntil(Child& child, const Condition& holds)
    {
        for (int k = 0; k < 8000 && !child.hasEnded(); ++k) {
            if (holds())
                return;
            std::this_thread::sleep_for(milliseconds(5));
        }
        ADD_FAILURE() << "it did not come to that";
    }
    void waitForSnapshot(Child& child, size_t processes = 1) const
    {
        waitUntil(child, [&] { return notes().size() >= processes; });
    }
    // Until the snapshot that is noted has seen that many moves.
    void waitForStep(Child& child, int step) const
    {
        waitUntil(child, [&] {
            for (const fs::path& note : notes())
                for (const auto& path : fs::directory_iterator(note.parent_path())) {
                    const std::string name = path.path().stem().string();
                    const auto dash = name.rfind('-');
                    if (dash == std::string::npos || path.path().extension() != ".knotspan" ||
                        readFile(note).find("\"snapshot\": " + name.substr(dash + 1) + "}") ==
                            std::string::npos)
                        continue;
                    if (const auto scene = formats::read(path); scene && stepsIn(*scene) == step)
                        return true;
                }
            return false;
        });
    }

    TemporaryFolder folder_;
    fs::path file_ = folder_ / "bracket.knotspan";
    fs::path place_ = folder_ / "data/Knotspan/Knotspan/recovery";
    Scene opened_ = findSample("nine-16")->make();
    std::string before_;
};

TEST_F(KilledWindow, IsOfferedAndRecoveredToTheBit)
{
    {
        const auto child = editing(5);
        waitForStep(*child, 5);
        child->kill();
    }
    RecoveringWindow next(place_);
    EXPECT_TRUE(
        next.offer().startsWith("Knotspan ended unexpectedly. Recover bracket.knotspan as it was at "))
        << next.offer().toStdString();
    next.click("recover");
    EXPECT_EQ(next.window().message(), QString());
    EXPECT_TRUE(next.document().scene() == editedScene(opened_, 5));
    EXPECT_TRUE(next.document().isModified());
    EXPECT_EQ(next.document().title(), "bracket.knotspan");
    EXPECT_EQ(next.document().file(), file_);
    EXPECT_EQ(next.offer(), "");
    EXPECT_EQ(readFile(file_), before_);  // until the user says so

    EXPECT_TRUE(next.document().save());
    EXPECT_TRUE(*formats::read(file_) == editedScene(opened_, 5));
    EXPECT_TRUE(next.window().close());
    EXPECT_TRUE(fs::is_empty(place_));
}

TEST_F(KilledWindow, AtAnyMomentLeavesASnapshotThatIsWhole)
{
    std::mt19937 random(8);
    std::uniform_int_distribution<int> moments(0, 150'000);
    int latest = 0;
    constexpr int kKills = 12;
    for (int kill = 0; kill < kKills; ++kill) {
        {
            const auto child = editing(1'000'000);
            waitForSnapshot(*child);
            std::this_thread::sleep_for(std::chrono::microseconds(moments(random)));
            EXPECT_FALSE(child->hasEnded());
            child->kill();
        }
        const auto entries = RecoveryEntry::leftBehind(place_);
        ASSERT_EQ(entries.size(), 1U);
        const auto scene = entries.front()->read();
        ASSERT_TRUE(scene) << scene.error().sentence();
        EXPECT_GT(stepsIn(*scene), 0);
        EXPECT_TRUE(*scene == editedScene(opened_, stepsIn(*scene)));
        latest = std::max(latest, stepsIn(*scene));
        entries.front()->remove();
    }
    EXPECT_GT(latest, 1);
    EXPECT_EQ(readFile(file_), before_);
}

TEST_F(KilledWindow, IsOneOfSeveralThatAreOfferedEachForItself)
{
    const auto living = editing(3);
    waitForSnapshot(*living);
    for (int k = 0; k < 2; ++k) {
        const auto child = editing(3);
        waitForSnapshot(*child, static_cast<size_t>(k) + 2);
        child->kill();
    }
    RecoveringWindow next(place_);
    int offers = 0;
    for (; !next.offer().isEmpty() && offers < 5; ++offers)
        next.click("discard-recovery");
    EXPECT_EQ(offers, 2);
    living->kill();
    EXPECT_EQ(RecoveryEntry::leftBehind(place_).size(), 1U);
}

// The program itself; nobody is there to answer it.
TEST_F(KilledWindow, IsOfferedByTheProgramAsLongAsNobodyAnswers)
{
    {
        const auto child = editing(5);
        waitForSnapshot(*child);
        child->kill();
    }
    const fs::path lock = fs::directory_iterator(place_)->path() / "lock";
    ASSERT_TRUE(formats::FileLock::take(lock));
    {
        Child program([&] {
            ::setenv("TMPDIR", folder_.path().c_str(), 1);
            ::setenv("XDG_DATA_HOME", (folder_ / "data").c_str(), 1);
            ::execl(KNOTSPAN_PROGRAM, "knotspan", file_.c_str(), nullptr);
            return 127;
        });
        bool isTaken = false;
        for (int k = 0; k < 2000 && !isTaken && !program.hasEnded(); ++k) {
            std::this_thread::sleep_for(milliseconds(10));
            isTaken = !formats::FileLock::take(lock);
        }
        EXPECT_TRUE(isTaken);
        EXPECT_FALSE(program.hasEnded());
        program.kill();
    }
    EXPECT_EQ(RecoveryEntry::leftBehind(place_).size(), 1U);
}

}  // namespace
}  // namespace knotspan
