// What the window says of models that were left behind, and what its buttons do.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QToolButton>

#include "model/formats/recovery_entry.h"
#include "model/samples/sample_list.h"
#include "model/scene/control_point_editing.h"
#include "tests/support.h"
#include "tests/ui/recovery/recovering_window.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;
using formats::RecoveryEntry;
namespace fs = std::filesystem;

class WindowRecovery : public ::testing::Test {
protected:
    // As a process leaves it that dies.
    void leave(const std::string& sample, std::int64_t seconds, const fs::path& file = {}) const
    {
        const auto entry = RecoveryEntry::create(place_);
        ASSERT_TRUE(entry);
        ASSERT_TRUE(
            (*entry)->write(findSample(sample)->make(), {"Sample: " + sample, file, false, seconds}, 0));
    }
    void damage(const std::string& name) const
    {
        for (const auto& path : fs::recursive_directory_iterator(place_))
            if (path.path().filename() == name)
                fs::resize_file(path, 20);
    }
    [[nodiscard]] size_t left() const { return RecoveryEntry::leftBehind(place_).size(); }
    static void goOn(int milliseconds)
    {
        QElapsedTimer clock;
        clock.start();
        while (clock.elapsed() < milliseconds)
            QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
    }
    static void edit(Document& document)
    {
        const auto& [id, object] = *document.scene().objects().begin();
        Edit edit;
        edit.set(id, withControlPointAt(*object, {0, 0}, Vec3(7, 2, 3)).value());
        document.apply(edit, "move");
    }

    TemporaryFolder folder_;
    fs::path place_ = folder_ / "recovery";
};

TEST_F(WindowRecovery, OffersNothingWhereNothingWasLeft)
{
    RecoveringWindow window(place_);
    EXPECT_EQ(window.offer(), "");
}

TEST_F(WindowRecovery, OffersTheLatestFirstAndEachUntilItIsAnswered)
{
    leave("torus", 1000);
    leave("nine-16", 2000);
    leave("sphere", 500);
    {
        RecoveringWindow window(place_);
        EXPECT_TRUE(window.offer().contains("nine-16")) << window.offer().toStdString();
        EXPECT_TRUE(window.offer().contains("1970")) << window.offer().toStdString();
        EXPECT_EQ(left(), 0U);  // no other window offers them meanwhile
        window.click("recover-later");
        EXPECT_TRUE(window.offer().contains("torus"));
        window.click("discard-recovery");
        EXPECT_TRUE(window.offer().contains("sphere"));
        EXPECT_EQ(left(), 1U);
        window.window().close();
    }
    EXPECT_EQ(left(), 2U);
}

TEST_F(WindowRecovery, AsksBeforeTheOpenModelIsLost)
{
    leave("torus", 1000);
    RecoveringWindow window(place_);
    edit(window.document());
    window.answers.saveChanges = SaveAnswer::cancel;
    window.click("recover");
    EXPECT_EQ(window.answers.askedToSave, 1);
    EXPECT_EQ(window.document().title(), "Sample: single-100");
    EXPECT_TRUE(window.offer().contains("torus"));
    window.answers.saveChanges = SaveAnswer::discard;
    window.click("recover");
    EXPECT_TRUE(window.document().scene() == findSample("torus")->make());
    EXPECT_TRUE(window.document().file().empty());
    EXPECT_EQ(window.document().title(), "Sample: torus");
    EXPECT_TRUE(window.window().isWindowModified());
    EXPECT_TRUE(window.window().close());
    EXPECT_EQ(left(), 0U);
}

TEST_F(WindowRecovery, KeepsARecoveredModelUntilItIsSaved)
{
    leave("torus", 1000);
    {
        RecoveringWindow window(place_);
        window.click("recover");
        goOn(50);
    }  // without close(): it dies
    EXPECT_EQ(left(), 1U);
    RecoveringWindow window(place_);
    window.click("recover");
    window.answers.fileToSave = QString::fromStdString((folder_ / "torus.knotspan").string());
    EXPECT_TRUE(window.window().files().saveAs());
    goOn(50);
    EXPECT_TRUE(window.window().close());
    EXPECT_EQ(left(), 0U);
}

TEST_F(WindowRecovery, SaysWhatIsWrongWithADamagedSnapshotWhichStays)
{
    leave("torus", 1000);
    damage("model-1.knotspan");
    {
        RecoveringWindow window(place_);
        const Scene before = window.document().scene();
        window.click("recover");
        EXPECT_TRUE(window.window().message().startsWith("The model cannot be recovered: "))
            << window.window().message().toStdString();
        EXPECT_TRUE(window.document().scene() == before);
        EXPECT_TRUE(window.offer().contains("torus"));
        window.window().close();
    }
    EXPECT_EQ(left(), 1U);
    damage("model.json");
    {
        RecoveringWindow window(place_);
        EXPECT_TRUE(window.offer().contains("cannot be read")) << window.offer().toStdString();
        EXPECT_FALSE(window.has("recover"));
        EXPECT_TRUE(window.has("discard-recovery"));
        window.window().close();
    }
    EXPECT_EQ(left(), 1U);
    RecoveringWindow window(place_);
    window.click("discard-recovery");
    EXPECT_EQ(window.offer(), "");
    EXPECT_TRUE(fs::is_empty(place_));
}

TEST_F(WindowRecovery, SaysOnceThatNothingCanBeKept)
{
    writeFile(place_, "in the way");
    RecoveringWindow window(place_);
    goOn(50);
    EXPECT_EQ(window.window().message(), "");
    edit(window.document());
    for (int k = 0; k < 1000 && window.window().message().isEmpty(); ++k)
        goOn(20);
    EXPECT_TRUE(window.window().message().startsWith("No copy of the unsaved changes could be kept"))
        << window.window().message().toStdString();
    window.window().findChild<QWidget*>("message-bar")->findChild<QToolButton*>()->click();
    goOn(100);
    EXPECT_EQ(window.window().message(), "");
}

}  // namespace
}  // namespace knotspan
