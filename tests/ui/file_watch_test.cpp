// The model's file, changed by another program.
#include <gtest/gtest.h>

#include <QAction>
#include <QElapsedTimer>
#include <QPushButton>

#include "model/formats/format_list.h"
#include "model/samples/sample_list.h"
#include "tests/ui/window_harness.h"
#include "ui/document_files.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class ChangedFile : public ::testing::Test {
protected:
    ChangedFile() : path_(sampleFile(folder_, "nine-16")), window_(answering(answers_))
    {
        window_.files().open({path_});
    }

    template <class Condition>
    [[nodiscard]] static bool becomes(const Condition& condition, int milliseconds = 20'000)
    {
        QElapsedTimer clock;
        clock.start();
        while (!condition() && clock.elapsed() < milliseconds)
            QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
        return condition();
    }
    [[nodiscard]] bool offers()
    {
        return becomes([&] { return window_.message().contains("changed by another program"); });
    }
    void changeElsewhere(const std::string& sample) const
    {
        ASSERT_TRUE(formats::write(findSample(sample)->make(), path_));
    }
    void press() { window_.findChild<QPushButton*>("message-action")->click(); }

    TemporaryFolder folder_;
    std::filesystem::path path_;
    Answers answers_;
    MainWindow window_;
};

TEST_F(ChangedFile, IsToldAndReadAgainAtAPress)
{
    EXPECT_TRUE(window_.message().isEmpty());
    changeElsewhere("torus");
    ASSERT_TRUE(offers());
    EXPECT_TRUE(window_.document().scene() == findSample("nine-16")->make()) << "nothing by itself";
    press();
    EXPECT_TRUE(window_.document().scene() == findSample("torus")->make());
    EXPECT_FALSE(window_.document().isModified());
    EXPECT_TRUE(window_.message().isEmpty());
    window_.document().undo();
    EXPECT_TRUE(window_.document().scene() == findSample("nine-16")->make());
    EXPECT_TRUE(window_.document().isModified());
    changeElsewhere("sphere");
    EXPECT_TRUE(offers()) << "a second time";
}

TEST_F(ChangedFile, LosesNothingOfWhatWasDoneHere)
{
    const ObjectId first = window_.document().scene().objects().begin()->first;
    window_.selection().setObjects({first});
    window_.action("edit.delete")->trigger();
    const Scene mine = window_.document().scene();
    changeElsewhere("torus");
    ASSERT_TRUE(offers());
    EXPECT_TRUE(window_.message().contains("Undo brings your model back"));
    press();
    EXPECT_TRUE(window_.document().scene() == findSample("torus")->make());
    window_.document().undo();
    EXPECT_TRUE(window_.document().scene() == mine);
    EXPECT_EQ(answers_.askedToSave, 0);
}

TEST_F(ChangedFile, ByTheWindowItselfIsNothingToTell)
{
    const ObjectId first = window_.document().scene().objects().begin()->first;
    window_.selection().setObjects({first});
    window_.action("edit.delete")->trigger();
    ASSERT_TRUE(window_.files().save());
    EXPECT_FALSE(becomes([&] { return !window_.message().isEmpty(); }, 1500))
        << window_.message().toStdString();
}

TEST_F(ChangedFile, IsNotSavedOverUnasked)
{
    window_.selection().setObjects({window_.document().scene().objects().begin()->first});
    window_.action("edit.delete")->trigger();
    changeElsewhere("torus");
    ASSERT_TRUE(offers());
    answers_.overwrite = false;
    EXPECT_FALSE(window_.files().save());
    EXPECT_EQ(answers_.askedToOverwrite, 1);
    EXPECT_TRUE(formats::read(path_).value() == findSample("torus")->make());
    EXPECT_TRUE(window_.document().isModified());
    answers_.overwrite = true;
    EXPECT_TRUE(window_.files().save());
    EXPECT_TRUE(formats::read(path_).value().objects().size() == 8);
    EXPECT_TRUE(window_.message().isEmpty()) << "nothing is to be reloaded any more";
    window_.document().undo();
    EXPECT_TRUE(window_.files().save());
    EXPECT_EQ(answers_.askedToOverwrite, 2) << "the file is the window's own again";
}

TEST_F(ChangedFile, ThatIsNoModelAnyMoreLeavesTheOpenOneAlone)
{
    writeFile(path_, "{");
    ASSERT_TRUE(offers());
    press();
    EXPECT_TRUE(window_.document().scene() == findSample("nine-16")->make());
    EXPECT_TRUE(window_.message().contains("nine-16.knotspan")) << window_.message().toStdString();
    std::filesystem::remove(path_);
    EXPECT_FALSE(becomes([&] { return window_.message().contains("another program"); }, 1200))
        << "a file that is gone is not offered";
}

TEST_F(ChangedFile, MayBeReadAgainByTheMenu)
{
    changeElsewhere("torus");
    window_.action("file.reload")->trigger();
    EXPECT_TRUE(window_.document().scene() == findSample("torus")->make());
    window_.files().openSample("sphere");
    EXPECT_FALSE(window_.action("file.reload")->isEnabled());
}

}  // namespace
}  // namespace knotspan
