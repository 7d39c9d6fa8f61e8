#include "ui/main_window.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QMimeData>
#include <QTest>

#include "model/formats/format_list.h"
#include "model/samples/sample_list.h"
#include "tests/support.h"
#include "tests/ui/window_harness.h"
#include "ui/document_files.h"
#include "ui/panels/stats_panel.h"
#include "ui/recent_files.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

TEST(MainWindow, ItsGrabShowsTheModel)
{
    Answers answers;
    const auto window = shownWindow(answers, "hull");
    KNOTSPAN_NEED_RENDERER(*window);
    const QImage model = window->viewport().grab().toImage();
    window->document().reset(Scene(), "empty");
    settle(*window);
    const QImage empty = window->viewport().grab().toImage();
    const int all = model.width() * model.height();
    const int drawn = differingPixels(model, empty);
    EXPECT_GT(drawn, all / 30);
    EXPECT_LT(drawn, all * 9 / 10);
    EXPECT_EQ(window->message(), QString());
}

// Macri's uniform grids, which a key makes finer and another coarser.
TEST(MainWindow, PlusAndMinusChangeTheCellsOfThePathCpu)
{
    Answers answers;
    const auto window = shownWindow(answers, "torus");
    KNOTSPAN_NEED_RENDERER(*window);
    auto* more = window->action("view.moreCells");
    auto* fewer = window->action("view.fewerCells");
    ASSERT_NE(more, nullptr);
    ASSERT_NE(fewer, nullptr);
    EXPECT_FALSE(more->isEnabled());
    Frame frame = window->viewport().frame();
    frame.path = PathId::cpu;
    window->viewport().setFrame(frame);
    EXPECT_TRUE(more->isEnabled());
    const auto cells = [&] {
        const SamplingRule rule = window->viewport().frame().sampling;
        return rule.kind == SamplingRule::Kind::fixed ? rule.count : 0;
    };
    more->trigger();
    const int first = cells();
    EXPECT_GT(first, 0);
    more->trigger();
    EXPECT_EQ(cells(), first + 1);
    for (int k = 0; k < 100; ++k)
        fewer->trigger();
    EXPECT_EQ(cells(), 1);
    EXPECT_TRUE(settle(*window));
    EXPECT_EQ(window->message(), QString());
}

// Issue "first light", what it must show, point 3.
TEST(MainWindow, OpensSwitchesDragsUndoesSavesAndReopens)
{
    const TemporaryFolder folder;
    Answers answers;
    answers.fileToSave = QString::fromStdString((folder / "dragged").string());
    MainWindow window(answering(answers));
    KNOTSPAN_NEED_RENDERER(window);
    window.resize(820, 460);
    window.show();
    window.files().open({sampleFile(folder, "torus")});
    ASSERT_TRUE(settle(window));
    ASSERT_EQ(window.message(), QString());
    EXPECT_TRUE(window.windowTitle().startsWith("torus.knotspan"));

    // Every path that the device can run shows the same model.
    auto* path = window.findChild<QComboBox*>("path");
    QImage first;
    for (const PathInfo& info : paths()) {
        if (!window.viewport().renderer()->whyUnavailable(info.id).empty())
            continue;
        path->setCurrentIndex(path->findText(QString::fromStdString(info.name)));
        Q_EMIT path->activated(path->currentIndex());
        ASSERT_TRUE(settle(window));
        EXPECT_EQ(statsOf(window).shown("path").toStdString(), info.name);
        const QImage image = picture(window);
        if (first.isNull())
            first = image;
        EXPECT_LT(differingPixels(image, first, 24), image.width() * image.height() / 100) << info.name;
    }

    const QString drawnAll = statsOf(window).shown("ksquads_drawn");
    for (auto* check : window.findChildren<QCheckBox*>(QRegularExpression("^culling-")))
        check->click();
    ASSERT_TRUE(settle(window));
    EXPECT_EQ(statsOf(window).shown("culling").toStdString().find("none"), std::string::npos);
    EXPECT_NE(statsOf(window).shown("ksquads_drawn"), drawnAll);
    for (auto* check : window.findChildren<QCheckBox*>(QRegularExpression("^culling-")))
        check->click();
    ASSERT_TRUE(settle(window));
    EXPECT_EQ(statsOf(window).shown("ksquads_drawn"), drawnAll);

    const Scene before = window.document().scene();
    const ObjectId object = before.objects().begin()->first;
    window.selection().setObjects({object});
    ASSERT_TRUE(settle(window));
    const auto point = visiblePoint(window, object);
    ASSERT_TRUE(point.has_value());
    const QImage still = picture(window);
    const Vec2 way(24, -18);
    Hand hand(window);
    hand.press(point->pixel);
    hand.move(point->pixel + way * 0.5);
    ASSERT_TRUE(settle(window));
    EXPECT_GT(differingPixels(picture(window), still), 50);  // the surface follows before the hand lets go
    hand.move(point->pixel + way);
    hand.release();
    ASSERT_TRUE(settle(window));
    const PictureSize size = window.viewport().pictureSize();
    const auto arrived =
        window.viewport().frame().camera.toPixel(positionOf(window, *point), size.width, size.height);
    ASSERT_TRUE(arrived.has_value());
    EXPECT_NEAR(arrived->x, point->pixel.x + way.x, 0.01);
    EXPECT_NEAR(arrived->y, point->pixel.y + way.y, 0.01);
    EXPECT_EQ(window.document().undoStack().count(), 1);
    EXPECT_TRUE(window.isWindowModified());
    const Scene dragged = window.document().scene();

    window.action("edit.undo")->trigger();
    ASSERT_TRUE(settle(window));
    EXPECT_TRUE(window.document().scene() == before);
    window.action("edit.redo")->trigger();
    EXPECT_TRUE(window.document().scene() == dragged);
    window.action("file.saveAs")->trigger();
    EXPECT_FALSE(window.isWindowModified());
    EXPECT_EQ(window.message(), QString());

    MainWindow other(answering(answers));
    other.files().open({folder / "dragged.knotspan"});
    EXPECT_TRUE(other.document().scene() == dragged);
}

TEST(MainWindow, SaysWhatIsWrongWithABadFileAndGoesOn)
{
    const TemporaryFolder folder;
    const std::vector<std::pair<std::string, std::string>> bad = {
        {"empty.knotspan", ""},
        {"truncated.knotspan", "{\"format\": \"knotspan\", \"version\": 1, \"objects\": [{\"na"},
        {"version.knotspan",
         "{\"format\": \"knotspan\", \"version\": 99, \"units\": \"mm\", \"objects\": []}"},
        {"other.json", "[1, 2, 3]"},
        {"empty.step", ""},
        {"noise.step", "ISO-10303-21;\nHEADER;\nnonsense"},
    };
    Answers answers;
    MainWindow window(answering(answers));
    window.files().openSample("single-100");
    const Scene before = window.document().scene();
    for (const auto& [name, content] : bad) {
        writeFile(folder / name, content);
        window.files().open({folder / name});
        EXPECT_TRUE(window.message().contains(QString::fromStdString(name)))
            << window.message().toStdString();
        EXPECT_TRUE(window.document().scene() == before) << name;
        EXPECT_FALSE(recentFiles::all().contains(QString::fromStdString((folder / name).string())));
    }
    window.files().open({folder.path()});
    EXPECT_FALSE(window.message().isEmpty());
    window.files().open({folder / "absent.knotspan"});
    EXPECT_FALSE(window.message().isEmpty());
    window.files().open({sampleFile(folder, "nine-16")});
    EXPECT_EQ(window.message(), QString());
    EXPECT_EQ(window.document().scene().objects().size(), 9U);
}

TEST(MainWindow, AddsTheFurtherFilesToTheFirst)
{
    const TemporaryFolder folder;
    Answers answers;
    MainWindow window(answering(answers));
    window.files().open(
        {sampleFile(folder, "nine-16"), folder / "absent.knotspan", sampleFile(folder, "single-100")});
    EXPECT_EQ(window.document().scene().objects().size(), 10U);
    EXPECT_TRUE(window.message().contains("absent.knotspan"));
}

TEST(MainWindow, DroppedFilesAreOpened)
{
    const TemporaryFolder folder;
    Answers answers;
    MainWindow window(answering(answers));
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QString::fromStdString(sampleFile(folder, "single-100").string()))});
    QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window, &drop);
    EXPECT_EQ(window.document().title(), "single-100.knotspan");
}

TEST(MainWindow, AsksBeforeChangesAreLost)
{
    const TemporaryFolder folder;
    Answers answers;
    answers.saveChanges = SaveAnswer::cancel;
    MainWindow window(answering(answers));
    window.files().openSample("nine-16");
    window.show();
    EXPECT_EQ(answers.askedToSave, 0);
    window.action("edit.selectAll")->trigger();
    window.action("edit.delete")->trigger();
    EXPECT_TRUE(window.document().scene().objects().empty());
    window.files().openSample("hull");
    EXPECT_EQ(answers.askedToSave, 1);
    EXPECT_TRUE(window.document().scene().objects().empty());
    EXPECT_FALSE(window.close());
    EXPECT_TRUE(window.isVisible());

    answers.saveChanges = SaveAnswer::save;
    answers.fileToSave = QString::fromStdString((folder / "saved.knotspan").string());
    EXPECT_TRUE(window.close());
    EXPECT_EQ(answers.askedToSave, 3);
    EXPECT_TRUE(std::filesystem::exists(folder / "saved.knotspan"));
}

TEST(MainWindow, ASaveThatFailsKeepsTheWindowOpen)
{
    const TemporaryFolder folder;
    Answers answers;
    answers.saveChanges = SaveAnswer::save;
    answers.fileToSave = QString::fromStdString((folder / "no/such/folder/it.knotspan").string());
    MainWindow window(answering(answers));
    window.files().openSample("nine-16");
    window.action("edit.selectAll")->trigger();
    window.action("edit.delete")->trigger();
    EXPECT_FALSE(window.close());
    EXPECT_FALSE(window.message().isEmpty());
    EXPECT_TRUE(window.document().isModified());
}

TEST(MainWindow, RemembersTheRecentFiles)
{
    const TemporaryFolder folder;
    recentFiles::clear();
    Answers answers;
    MainWindow window(answering(answers));
    for (const char* name : {"nine-16", "single-100", "nine-16"})
        window.files().open({sampleFile(folder, name)});
    const QStringList expected = {QString::fromStdString((folder / "nine-16.knotspan").string()),
                                  QString::fromStdString((folder / "single-100.knotspan").string())};
    EXPECT_EQ(recentFiles::all(), expected);
}

TEST(MainWindow, WorksWithoutADevice)
{
    const TemporaryFolder folder;
    for (const char* name : {"VK_ICD_FILENAMES", "VK_DRIVER_FILES"})
        qputenv(name, "/nowhere/none.json");
    Answers answers;
    answers.fileToSave = QString::fromStdString((folder / "it.knotspan").string());
    {
        MainWindow window(answering(answers));
        ASSERT_EQ(window.viewport().renderer(), nullptr);
        window.files().openSample("nine-16");
        window.show();
        settle(window);
        for (const char* id : {"view.fit", "view.front", "view.nets", "edit.selectAll", "edit.delete",
                               "edit.undo", "file.saveAs", "edit.deselect"})
            window.action(id)->trigger();
        EXPECT_TRUE(std::filesystem::exists(folder / "it.knotspan"));
        settle(window);
        EXPECT_TRUE(window.close());
    }
    MainWindow window(answering(answers));
    window.files().openSample("nine-16");
    window.show();
    for (const char* name : {"VK_ICD_FILENAMES", "VK_DRIVER_FILES"})
        qunsetenv(name);
    window.viewport().restart();
    KNOTSPAN_NEED_RENDERER(window);
    ASSERT_TRUE(settle(window));
    EXPECT_FALSE(statsOf(window).shown("triangles").isEmpty());
}

}  // namespace
}  // namespace knotspan
