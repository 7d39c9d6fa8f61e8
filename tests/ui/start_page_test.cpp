// The start page, and the pictures of files that it shows.
#include "ui/start_page.h"

#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include <QAction>
#include <QFileInfo>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QThreadPool>

#include "model/samples/sample_list.h"
#include "tests/ui/window_harness.h"
#include "ui/document_files.h"
#include "ui/model_pictures.h"
#include "ui/recent_files.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class StartPageTest : public ::testing::Test {
protected:
    StartPageTest()
    {
        recentFiles::clear();
        window.resize(1000, 700);
    }
    ~StartPageTest() override
    {
        QThreadPool::globalInstance()->waitForDone();
        QSettings().clear();
    }

    void show()
    {
        window.showStartPage();
        window.show();
        QCoreApplication::processEvents();
    }
    [[nodiscard]] QListWidget& list(const char* id) { return *window.findChild<QListWidget*>(id); }
    void click(QListWidget& entries, int row)
    {
        entries.scrollToItem(entries.item(row));
        QTest::mouseClick(entries.viewport(), Qt::LeftButton, {},
                          entries.visualItemRect(entries.item(row)).center());
        QCoreApplication::processEvents();
    }
    [[nodiscard]] bool waitUntilKept(const std::filesystem::path& file)
    {
        return QTest::qWaitFor([&] { return modelPictures::isKept(file); }, 60'000);
    }

    Answers answers;
    TemporaryFolder folder;
    MainWindow window{answering(answers)};
};

int colours(const QImage& image)
{
    std::set<QRgb> found;
    for (int y = 0; y < image.height(); y += 4)
        for (int x = 0; x < image.width(); x += 4)
            found.insert(image.pixel(x, y));
    return static_cast<int>(found.size());
}

TEST_F(StartPageTest, StandsInTheViewportsPlaceUntilThereIsAModel)
{
    EXPECT_FALSE(window.isStartPageShown());
    show();
    EXPECT_TRUE(window.isStartPageShown());
    EXPECT_FALSE(window.viewport().isVisible());
    EXPECT_TRUE(window.action("help.start")->isChecked());
    window.files().openSample("torus");
    EXPECT_FALSE(window.isStartPageShown());
    EXPECT_TRUE(window.viewport().isVisible());
    EXPECT_FALSE(window.action("help.start")->isChecked());
    window.action("help.start")->trigger();
    EXPECT_TRUE(window.isStartPageShown());
    window.action("help.start")->trigger();
    EXPECT_FALSE(window.isStartPageShown());
    EXPECT_FALSE(window.document().scene().objects().empty());
}

TEST_F(StartPageTest, HasEverySampleWithAPictureOfItsOwn)
{
    show();
    ASSERT_EQ(list("start-samples").count(), static_cast<int>(samples().size()));
    std::set<int> seen;
    for (const Sample& sample : samples()) {
        const QImage picture = modelPictures::ofSample(sample.name);
        EXPECT_EQ(picture.size(), modelPictures::kSize) << sample.name;
        EXPECT_GT(colours(picture), 20) << sample.name;
        seen.insert(colours(picture));
    }
    EXPECT_GT(seen.size(), samples().size() / 2);
}

TEST_F(StartPageTest, AClickOpensASampleAndSoDoesEnter)
{
    show();
    click(list("start-samples"), 3);
    EXPECT_EQ(window.document().title().toStdString(), "Sample: " + samples()[3].name);
    EXPECT_FALSE(window.isStartPageShown());
    show();
    QListWidget& entries = list("start-samples");
    QTest::keyClick(&entries, Qt::Key_Home);
    QTest::keyClick(&entries, Qt::Key_Right);
    QTest::keyClick(&entries, Qt::Key_Return);
    EXPECT_EQ(window.document().title().toStdString(), "Sample: " + samples()[1].name);
    EXPECT_FALSE(window.isStartPageShown());
}

TEST_F(StartPageTest, NewBeginsWithAnEmptyModelAndAsksBeforeChangesAreLost)
{
    show();
    window.findChild<QPushButton*>("start-new")->click();
    EXPECT_FALSE(window.isStartPageShown());
    EXPECT_TRUE(window.document().scene().objects().empty());
    window.files().openSample("torus");
    Edit edit;
    edit.set(window.document().scene().objects().begin()->first, nullptr);
    window.document().apply(edit, "Remove");
    answers.saveChanges = SaveAnswer::cancel;
    window.action("file.new")->trigger();
    EXPECT_EQ(answers.askedToSave, 1);
    EXPECT_EQ(window.document().title(), "Sample: torus");
    answers.saveChanges = SaveAnswer::discard;
    window.action("file.new")->trigger();
    EXPECT_NE(window.document().title(), "Sample: torus");
    EXPECT_FALSE(window.document().isModified());
}

TEST_F(StartPageTest, AnOpenedFileIsShownWithThePictureOfTheViewport)
{
    KNOTSPAN_NEED_RENDERER(window);
    const auto file = sampleFile(folder, "torus");
    window.show();
    window.files().open({file});
    settle(window);
    ASSERT_TRUE(waitUntilKept(file));
    const QImage kept = modelPictures::of(file);
    EXPECT_EQ(kept.size(), modelPictures::kSize);
    EXPECT_GT(colours(kept), 20);
    show();
    QListWidget& recent = list("start-recent");
    ASSERT_EQ(recent.count(), 1);
    const QImage withPicture = recent.item(0)->icon().pixmap(modelPictures::kSize).toImage();
    EXPECT_GT(colours(withPicture), 20);
    // Another program writes it: what was kept is not what it is.
    std::ofstream(file, std::ios::app) << "\n\n";
    EXPECT_FALSE(modelPictures::isKept(file));
    EXPECT_TRUE(modelPictures::of(file).isNull());
    window.showStartPage(false);
    show();
    EXPECT_NE(recent.item(0)->icon().pixmap(modelPictures::kSize).toImage(), withPicture);
}

TEST_F(StartPageTest, NoPictureIsKeptOfWhatTheFileDoesNotHold)
{
    KNOTSPAN_NEED_RENDERER(window);
    const auto file = sampleFile(folder, "nine-16");
    window.show();
    window.files().open({file});
    Edit edit;
    edit.set(window.document().scene().objects().begin()->first, nullptr);
    window.document().apply(edit, "Remove");
    settle(window);
    QTest::qWait(1500);
    QThreadPool::globalInstance()->waitForDone();
    EXPECT_FALSE(modelPictures::isKept(file));
    ASSERT_TRUE(window.files().save());
    EXPECT_TRUE(waitUntilKept(file));
}

TEST_F(StartPageTest, ARecentFileOpensAndOneThatIsGoneSaysSoAndIsTakenOffTheList)
{
    const auto here = sampleFile(folder, "torus");
    const auto gone = folder / "gone.step";
    recentFiles::remember(here);
    recentFiles::remember(gone);
    show();
    QListWidget& recent = list("start-recent");
    ASSERT_EQ(recent.count(), 2);
    EXPECT_EQ(recent.item(0)->text(), "gone.step");
    click(recent, 0);
    EXPECT_TRUE(window.message().contains("gone.step is no longer in")) << window.message().toStdString();
    EXPECT_TRUE(window.isStartPageShown());
    ASSERT_EQ(recent.count(), 1);
    EXPECT_EQ(recentFiles::all().size(), 1);
    click(recent, 0);
    EXPECT_EQ(window.document().source(), here);
    EXPECT_FALSE(window.isStartPageShown());
}

TEST_F(StartPageTest, PicturesOfFilesThatAreNotRecentGo)
{
    const auto first = sampleFile(folder, "torus");
    const auto second = sampleFile(folder, "nine-16");
    QImage picture(640, 480, QImage::Format_RGB32);
    picture.fill(Qt::red);
    recentFiles::remember(first);
    modelPictures::keep(first, picture);
    EXPECT_TRUE(modelPictures::isKept(first));
    recentFiles::forget(QString::fromStdString(first.string()));
    modelPictures::keep(second, picture);
    EXPECT_TRUE(modelPictures::isKept(second));
    EXPECT_FALSE(modelPictures::isKept(first));
}

TEST_F(StartPageTest, EveryControlSaysWhatItIs)
{
    for (const char* id : {"start-open", "start-new", "start-recent", "start-samples"}) {
        const auto* widget = window.findChild<QWidget*>(id);
        ASSERT_NE(widget, nullptr) << id;
        EXPECT_FALSE(widget->accessibleName().isEmpty()) << id;
        EXPECT_FALSE(widget->toolTip().isEmpty()) << id;
    }
}

}  // namespace
}  // namespace knotspan
