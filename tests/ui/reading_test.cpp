// Files that another process reads: the window lives meanwhile, and whatever becomes of it, the open model
// stays.
#include <sstream>

#include <gtest/gtest.h>

#include <QAction>
#include <QElapsedTimer>
#include <QPushButton>
#include <QTimer>

#include "model/formats/import_lines.h"
#include "model/samples/sample_list.h"
#include "tests/model/formats/import_scripts.h"
#include "tests/support.h"
#include "tests/ui/window_harness.h"
#include "ui/document_files.h"
#include "ui/reading_line.h"
#include "ui/recent_files.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class WindowReading : public ::testing::Test {
protected:
    WindowReading()
    {
        writeFile(file_, "ISO-10303-21;");
        window_ = std::make_unique<MainWindow>(answering(answers_));
        window_->files().openSample("single-100");
        before_ = window_->document().scene();
    }
    ~WindowReading() override
    {
        window_.reset();
        EXPECT_EQ(childProcessesLeft(), 0);
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
    [[nodiscard]] bool ends()
    {
        return becomes([this] { return !window_->files().isReading(); });
    }
    [[nodiscard]] ReadingLine& line() { return *window_->findChild<ReadingLine*>("reading-line"); }
    [[nodiscard]] std::string message() const { return window_->message().toStdString(); }
    [[nodiscard]] bool isUntouched() const { return window_->document().scene() == before_; }

    // A script that talks, waits, and gives the sample of that name.
    [[nodiscard]] std::string givingLater(const std::string& sample, const std::string& wait)
    {
        formats::Import import;
        import.scene = findSample(sample)->make();
        import.notes = {"Something was approximated."};
        std::ostringstream lines;
        for (const auto& [id, object] : import.scene.objects())
            lines << formats::objectLine(*object);
        lines << formats::endLine(import);
        writeFile(folder_ / "answer", lines.str());
        return "echo 'progress {\"stage\": \"Converting face 12 of 340\", \"done\": 0.5}'\n" + wait +
               "\ncat " + (folder_ / "answer").string();
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "model.step";
    Answers answers_;
    std::unique_ptr<MainWindow> window_;
    Scene before_;
};

TEST_F(WindowReading, GoesOnBesideTheWindowAndIsTakenOver)
{
    const ScriptedImporter importer(folder_, givingLater("nine-16", "sleep 1"));
    QElapsedTimer clock;
    clock.start();
    window_->files().open({file_});
    EXPECT_LT(clock.restart(), 1000);
    EXPECT_TRUE(window_->files().isReading());
    EXPECT_TRUE(isUntouched());
    // The window's own clock ticks on.
    int ticks = 0;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&ticks] { ++ticks; });
    timer.start(20);
    ASSERT_TRUE(
        becomes([this] { return line().isVisibleTo(window_.get()) && line().text().contains("face 12"); }));
    EXPECT_EQ(line().text(), "model.step: Converting face 12 of 340");
    ASSERT_TRUE(ends());
    EXPECT_GT(ticks, 5);
    EXPECT_FALSE(line().isVisibleTo(window_.get()));
    EXPECT_TRUE(window_->document().scene() == findSample("nine-16")->make());
    EXPECT_EQ(window_->document().title(), "model.step");
    EXPECT_EQ(message(), "model.step: Something was approximated.");
    EXPECT_TRUE(recentFiles::all().contains(QString::fromStdString(file_.string())));
}

TEST_F(WindowReading, IsCancelledByTheButtonAtOnce)
{
    const ScriptedImporter importer(folder_, givingLater("nine-16", "sleep 600"));
    window_->files().open({file_});
    ASSERT_TRUE(becomes([this] { return line().text().contains("face 12"); }));
    QElapsedTimer clock;
    clock.start();
    window_->findChild<QPushButton*>("cancel-reading")->click();
    EXPECT_LT(clock.elapsed(), 1000 * kHang);
    RecordProperty("cancel_ms", static_cast<int>(clock.elapsed()));
    EXPECT_FALSE(window_->files().isReading());
    EXPECT_EQ(childProcessesLeft(), 0);
    EXPECT_TRUE(isUntouched());
    EXPECT_EQ(message(), "Reading model.step was cancelled. The model is as it was.");
    EXPECT_EQ(line().text(), "");
}

TEST_F(WindowReading, ThatFailsIsSaidAndLeavesTheModel)
{
    for (const char* const script : {"kill -11 $$", "echo rubbish", "exit 1"}) {
        const ScriptedImporter importer(folder_, script);
        window_->files().open({file_});
        ASSERT_TRUE(ends());
        EXPECT_EQ(message().rfind(file_.string() + ": The importer", 0), 0U) << message();
        EXPECT_TRUE(isUntouched());
    }
    EXPECT_FALSE(recentFiles::all().contains(QString::fromStdString(file_.string())));
}

TEST_F(WindowReading, RefusesAnotherFileMeanwhile)
{
    const ScriptedImporter importer(folder_, givingLater("nine-16", "sleep 600"));
    window_->files().open({file_});
    window_->files().open({sampleFile(folder_, "torus")});
    EXPECT_EQ(message(),
              "model.step is still being read. Wait until it is there, or cancel it, and try again.");
    window_->files().openSample("torus");
    answers_.filesToOpen = {"another.step"};
    window_->files().askAndOpen();
    window_->files().askAndAdd();
    EXPECT_TRUE(isUntouched());
    EXPECT_TRUE(window_->files().isReading());
    window_->files().cancelReading();
    window_->files().openSample("torus");
    EXPECT_FALSE(isUntouched());
}

TEST_F(WindowReading, AddsToWhatTheModelHasBecome)
{
    const ScriptedImporter importer(folder_, givingLater("nine-16", "sleep 0.3"));
    answers_.filesToOpen = {QString::fromStdString(file_.string())};
    window_->files().askAndAdd();
    window_->action("edit.selectAll")->trigger();
    window_->action("edit.delete")->trigger();
    EXPECT_TRUE(window_->document().scene().objects().empty());
    ASSERT_TRUE(ends());
    EXPECT_EQ(window_->document().scene().objects().size(), 9U);
    window_->action("edit.undo")->trigger();
    window_->action("edit.undo")->trigger();
    EXPECT_TRUE(isUntouched());
}

TEST_F(WindowReading, AsksAgainWhereTheModelWasChangedMeanwhile)
{
    const ScriptedImporter importer(folder_, givingLater("nine-16", "sleep 0.3"));
    answers_.saveChanges = SaveAnswer::cancel;
    window_->files().open({file_});
    window_->action("edit.selectAll")->trigger();
    window_->action("edit.delete")->trigger();
    ASSERT_TRUE(ends());
    EXPECT_EQ(answers_.askedToSave, 1);
    EXPECT_TRUE(window_->document().scene().objects().empty());
    answers_.saveChanges = SaveAnswer::discard;
}

TEST_F(WindowReading, SeveralFilesComeOneAfterTheOther)
{
    const ScriptedImporter importer(folder_, givingLater("nine-16", "sleep 0.1"));
    writeFile(folder_ / "second.igs", "x");
    window_->files().open(
        {file_, sampleFile(folder_, "single-100"), folder_ / "absent.step", folder_ / "second.igs"});
    ASSERT_TRUE(becomes([this] { return window_->document().scene().objects().size() == 19; }));
    ASSERT_TRUE(ends());
    EXPECT_NE(message().find("absent.step: There is no such file"), std::string::npos) << message();
}

TEST_F(WindowReading, IsEndedByClosingTheWindow)
{
    const ScriptedImporter importer(folder_, givingLater("nine-16", "sleep 600"));
    window_->files().open({file_});
    ASSERT_TRUE(becomes([this] { return line().text().contains("face 12"); }));
    EXPECT_TRUE(window_->close());
    EXPECT_FALSE(window_->files().isReading());
    EXPECT_EQ(childProcessesLeft(), 0);
    window_->files().open({file_});
    window_.reset();
    EXPECT_EQ(childProcessesLeft(), 0);
}

}  // namespace
}  // namespace knotspan
