#include "model/document/autosave.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>

#include "model/formats/format_list.h"
#include "model/formats/recovery_entry.h"
#include "model/samples/sample_list.h"
#include "model/scene/control_point_editing.h"
#include "tests/full_disk.h"
#include "tests/support.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;
using formats::RecoveryEntry;
using std::chrono::milliseconds;

Edit moveTo(const Document& document, double x)
{
    const auto& [id, object] = *document.scene().objects().begin();
    Edit edit;
    edit.set(id, withControlPointAt(*object, {0, 0}, Vec3(x, 2, 3)).value());
    return edit;
}

class Autosaving : public ::testing::Test {
protected:
    Autosaving()
    {
        static int count = 0;
        static QCoreApplication application(count, nullptr);
        document_.reset(findSample("nine-16")->make(), "Sample: nine-16");
        start();
    }

    void start(milliseconds interval = milliseconds(10))
    {
        autosave_ = std::make_unique<Autosave>(document_, place_, interval);
        QObject::connect(autosave_.get(), &Autosave::kept, [this] { ++kept_; });
        QObject::connect(autosave_.get(), &Autosave::failed, [this](const QString& sentence) {
            ++failed_;
            sentence_ = sentence.toStdString();
        });
    }
    // Handles events until it holds; false after twenty seconds.
    template <class Condition>
    [[nodiscard]] static bool becomes(const Condition& condition)
    {
        QElapsedTimer clock;
        clock.start();
        while (!condition() && clock.elapsed() < 20'000)
            QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
        return condition();
    }
    [[nodiscard]] bool keepsAnother()
    {
        return becomes([this, before = kept_] { return kept_ > before; });
    }
    static void goOn(milliseconds time)
    {
        QElapsedTimer clock;
        clock.start();
        while (clock.elapsed() < time.count())
            QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
    }
    // What another process finds when this one has died.
    [[nodiscard]] std::vector<std::shared_ptr<RecoveryEntry>> leftBehind()
    {
        autosave_.reset();
        return RecoveryEntry::leftBehind(place_);
    }

    TemporaryFolder folder_;
    std::filesystem::path place_ = folder_ / "data/recovery";
    Document document_;
    std::unique_ptr<Autosave> autosave_;
    int kept_ = 0;
    int failed_ = 0;
    std::string sentence_;
};

TEST_F(Autosaving, KeepsWhatIsNotSaved)
{
    ASSERT_TRUE(document_.saveAs(folder_ / "bracket.knotspan"));
    document_.apply(moveTo(document_, 1.0 / 3), "move");
    ASSERT_TRUE(keepsAnother());
    document_.apply(moveTo(document_, 2.0 / 3), "move");
    ASSERT_TRUE(keepsAnother());
    const auto entries = leftBehind();
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_TRUE(*entries.front()->read() == document_.scene());
    const auto note = entries.front()->note();
    EXPECT_EQ(note->title, "bracket.knotspan");
    EXPECT_EQ(note->file, folder_ / "bracket.knotspan");
    EXPECT_FALSE(note->isImported);
}

TEST_F(Autosaving, KeepsNothingOfWhatIsSavedUndoneOrReplaced)
{
    goOn(milliseconds(60));
    EXPECT_FALSE(std::filesystem::exists(place_));
    const std::vector<std::function<void()>> endings = {
        [&] { EXPECT_TRUE(document_.saveAs(folder_ / "it.knotspan")); },
        [&] { document_.undo(); },
        [&] { document_.reset(findSample("torus")->make(), "Sample: torus"); },
    };
    for (const auto& end : endings) {
        document_.apply(moveTo(document_, 1.0 / 3), "move");
        ASSERT_TRUE(keepsAnother());
        end();
        goOn(milliseconds(40));
        for (const auto& path : std::filesystem::recursive_directory_iterator(place_))
            EXPECT_TRUE(path.is_directory() || path.path().filename() == "lock") << path.path();
    }
    EXPECT_TRUE(leftBehind().empty());
    EXPECT_TRUE(std::filesystem::is_empty(place_));
}

TEST_F(Autosaving, KeepsNothingOfADocumentThatGoesInPeace)
{
    document_.apply(moveTo(document_, 1.0 / 3), "move");
    ASSERT_TRUE(keepsAnother());
    autosave_->endInPeace();
    EXPECT_TRUE(std::filesystem::is_empty(place_));
}

TEST_F(Autosaving, KeepsTheSameOnce)
{
    document_.apply(moveTo(document_, 1), "move");
    ASSERT_TRUE(keepsAnother());
    goOn(milliseconds(100));
    EXPECT_EQ(kept_, 1);
}

TEST_F(Autosaving, KeepsNeitherAPreviewNorARunningDrag)
{
    document_.apply(moveTo(document_, 1), "move");
    const Scene settled = document_.scene();
    static_cast<void>(document_.preview(moveTo(document_, 2), "try"));
    ASSERT_TRUE(keepsAnother());
    EXPECT_TRUE(document_.isPreviewing());  // it goes on
    const int gesture = document_.newGesture();
    document_.apply(moveTo(document_, 3), "drag", gesture);
    goOn(milliseconds(60));
    EXPECT_EQ(kept_, 1);  // nothing new
    autosave_.reset();
    {
        const auto entries = RecoveryEntry::leftBehind(place_);
        ASSERT_EQ(entries.size(), 1U);
        EXPECT_TRUE(*entries.front()->read() == settled);
        EXPECT_FALSE(settled == document_.scene());
    }
    start();
    document_.finishGesture(gesture);
    ASSERT_TRUE(keepsAnother());
}

TEST_F(Autosaving, KeepsThatEverythingWasDeleted)
{
    Edit all;
    for (const auto& [id, object] : document_.scene().objects())
        all.set(id, nullptr);
    document_.apply(all, "delete");
    ASSERT_TRUE(keepsAnother());
    EXPECT_TRUE(leftBehind().front()->read()->objects().empty());
}

TEST_F(Autosaving, SaysOnceThatItFailsAndGoesOnTrying)
{
    writeFile(folder_ / "data", "in the way");
    document_.apply(moveTo(document_, 1), "move");
    ASSERT_TRUE(becomes([&] { return failed_ > 0; }));
    goOn(milliseconds(100));
    EXPECT_EQ(failed_, 1);
    EXPECT_NE(sentence_.find("The folder for recovery cannot be used"), std::string::npos) << sentence_;
    std::filesystem::remove(folder_ / "data");
    ASSERT_TRUE(keepsAnother());
    {
        const testing::FullDisk full(100);
        document_.apply(moveTo(document_, 2), "move");
        ASSERT_TRUE(becomes([&] { return failed_ > 1; }));
        goOn(milliseconds(100));
    }
    EXPECT_EQ(failed_, 2);
    EXPECT_NE(sentence_.find("disk has room"), std::string::npos) << sentence_;
    ASSERT_TRUE(keepsAnother());
}

TEST_F(Autosaving, MakesAnotherEntryWhereItsOwnWasClearedAway)
{
    document_.apply(moveTo(document_, 1), "move");
    ASSERT_TRUE(keepsAnother());
    std::filesystem::remove_all(place_);
    document_.apply(moveTo(document_, 2), "move");
    ASSERT_TRUE(keepsAnother());
    const auto entries = leftBehind();
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_TRUE(*entries.front()->read() == document_.scene());
}

TEST_F(Autosaving, AdoptsTheEntryThatTheDocumentWasRecoveredFrom)
{
    document_.apply(moveTo(document_, 1), "move");
    ASSERT_TRUE(keepsAnother());
    const Scene lost = document_.scene();
    auto entries = leftBehind();
    ASSERT_EQ(entries.size(), 1U);
    start();
    const auto note = *entries.front()->note();
    document_.recover(*entries.front()->read(), "/models/bracket.knotspan", "bracket.knotspan", false);
    autosave_->adopt(std::move(entries.front()));
    EXPECT_TRUE(document_.isModified());
    EXPECT_EQ(document_.file(), "/models/bracket.knotspan");
    goOn(milliseconds(60));
    entries = leftBehind();  // dies again
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_TRUE(*entries.front()->read() == lost);
    start();
    autosave_->adopt(std::move(entries.front()));
    EXPECT_TRUE(document_.saveAs(folder_ / "it.knotspan"));
    EXPECT_TRUE(leftBehind().empty());
}

// Tenths of a second of writing, in which the window's own clock goes on.
TEST_F(Autosaving, WritesBesideTheWindow)
{
    const Scene knot = findSample("knot")->make();
    Scene large;
    for (int k = 0; k < 12; ++k)
        for (const auto& [id, object] : knot.objects())
            large.add(*object);
    QElapsedTimer clock;
    clock.start();
    ASSERT_TRUE(formats::write(large, folder_ / "large.knotspan"));
    const qint64 writing = clock.elapsed();
    document_.reset(large, "large");
    document_.apply(moveTo(document_, 1), "move");
    int ticks = 0;
    QTimer ticking;
    QObject::connect(&ticking, &QTimer::timeout, [&ticks] { ++ticks; });
    ticking.start(2);
    qint64 longest = 0;
    clock.restart();
    const bool keeps = becomes([&] {
        longest = std::max(longest, clock.restart());
        return kept_ > 0;
    });
    ASSERT_TRUE(keeps);
    EXPECT_GT(writing, 100);
    EXPECT_GT(ticks, 20);  // as many as there are before the snapshot begins are five
    RecordProperty("writing_ms", static_cast<int>(writing));
    RecordProperty("longest_pause_ms", static_cast<int>(longest));
}

TEST(Document, ThatCannotBeSavedStaysModified)
{
    const TemporaryFolder folder;
    Document document;
    document.reset(findSample("nine-16")->make(), "nine");
    ASSERT_TRUE(document.saveAs(folder / "it.knotspan"));
    const std::string before = readFile(folder / "it.knotspan");
    document.apply(moveTo(document, 1), "move");
    for (const bool other : {false, true}) {
        Result<void> saved;
        {
            const testing::FullDisk full(100);
            saved = other ? document.saveAs(folder / "other.knotspan") : document.save();
        }
        EXPECT_FALSE(saved);
        EXPECT_TRUE(document.isModified());
        EXPECT_EQ(document.file(), folder / "it.knotspan");
        EXPECT_EQ(document.title(), "it.knotspan");
        EXPECT_EQ(readFile(folder / "it.knotspan"), before);
        EXPECT_FALSE(std::filesystem::exists(folder / "other.knotspan"));
    }
    EXPECT_TRUE(document.save());
    EXPECT_FALSE(document.isModified());
}

}  // namespace
}  // namespace knotspan
