#include <QCheckBox>
#include <QDoubleSpinBox>

#include "model/formats/format_list.h"
#include "tests/ui/match_dialog_harness.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

TEST(MatchPreview, ShowsWhatMovesBeforeItIsAppliedAndApplyIsOneStep)
{
    Opened opened;
    ASSERT_EQ(opened.box("edge").count(), 2);
    opened.chooseOneThatWorks();
    EXPECT_TRUE(says(opened.details(), "Now: G0, largest angle")) << opened.details();
    EXPECT_TRUE(says(opened.details(), "Then: largest angle")) << opened.details();
    EXPECT_TRUE(says(opened.details(), " % (")) << opened.details();  // as the limit is given
    EXPECT_TRUE(opened.dialog->findChild<QDoubleSpinBox*>("gap")->suffix().endsWith(
        QString::fromStdString(opened.scene().units())));
    EXPECT_TRUE(says(opened.details(), "moves by")) << opened.details();
    EXPECT_TRUE(says(opened.details(), "of the control points along")) << opened.details();
    EXPECT_TRUE(opened.dialog->isPreviewing());
    EXPECT_TRUE(opened.isSmooth());  // as the viewport shows it
    const Scene shown = opened.scene();

    opened.click("apply");
    opened.wait();
    EXPECT_FALSE(opened.dialog->isPreviewing());
    EXPECT_TRUE(opened.scene() == shown);
    EXPECT_EQ(opened.steps(), 1);
    EXPECT_EQ(opened.window.document().undoText(), "Match edge");
    EXPECT_TRUE(says(opened.details(), "Done.")) << opened.details();
    EXPECT_TRUE(says(opened.details(), "Now: G1")) << opened.details();
    opened.window.action("edit.undo")->trigger();
    EXPECT_TRUE(opened.scene() == opened.start);
}

TEST(MatchPreview, EscapeTakesThePreviewBackToTheBit)
{
    Opened opened;
    opened.chooseOneThatWorks();
    EXPECT_FALSE(opened.scene() == opened.start);
    QTest::keyClick(opened.dialog, Qt::Key_Escape);
    EXPECT_FALSE(opened.dialog->isVisible());
    for (const auto& [id, object] : opened.start.objects())
        EXPECT_EQ(opened.scene().find(id), object);  // the very same
    EXPECT_EQ(opened.steps(), 0);
    EXPECT_FALSE(opened.window.document().isModified());
}

TEST(MatchPreview, WithoutThePreviewNothingMovesUntilApply)
{
    Opened opened;
    opened.chooseOneThatWorks();
    QTest::mouseClick(opened.dialog->findChild<QCheckBox*>("preview"), Qt::LeftButton, {}, QPoint(8, 8));
    EXPECT_FALSE(opened.dialog->isPreviewing());
    EXPECT_TRUE(opened.scene() == opened.start);
    opened.click("apply");
    EXPECT_TRUE(opened.isSmooth());
    EXPECT_EQ(opened.steps(), 1);
}

TEST(MatchPreview, WhateverElseIsDoneTakesThePreviewBack)
{
    Opened opened;
    opened.chooseOneThatWorks();
    const Scene shown = opened.scene();
    const ObjectId last = opened.start.objects().rbegin()->first;
    opened.window.selection().setObjects({last});
    opened.chooseOneThatWorks();
    EXPECT_FALSE(opened.scene() == shown);
    EXPECT_TRUE(opened.dialog->isPreviewing());
    opened.window.action("edit.delete")->trigger();
    EXPECT_FALSE(opened.dialog->isPreviewing());
    EXPECT_EQ(opened.steps(), 1);
    Scene without = opened.start;
    without.exchange(last, nullptr);
    EXPECT_TRUE(opened.scene() == without);
    opened.wait();
    EXPECT_TRUE(says(opened.details(), "no longer there")) << opened.details();
    opened.window.document().undo();
    EXPECT_TRUE(opened.scene() == opened.start);
    opened.wait();
    EXPECT_TRUE(says(opened.details(), "Now: G0")) << opened.details();
    EXPECT_TRUE(opened.scene() == opened.start);  // it waits for the hand before it shows anything again
}

TEST(MatchPreview, AFileHasNothingOfAPreview)
{
    const TemporaryFolder folder;
    Opened opened;
    opened.chooseOneThatWorks();
    const Scene shown = opened.scene();
    EXPECT_FALSE(opened.window.isWindowModified());
    opened.answers.fileToSave = QString::fromStdString((folder / "nine.knotspan").string());
    opened.window.action("file.saveAs")->trigger();
    const auto saved = formats::read(folder / "nine.knotspan");
    ASSERT_TRUE(saved);
    EXPECT_TRUE(*saved == opened.start);
    EXPECT_TRUE(opened.dialog->isPreviewing());
    EXPECT_TRUE(opened.scene() == shown);
    opened.click("apply");
    opened.wait();
    EXPECT_TRUE(opened.window.document().isModified());
    EXPECT_EQ(opened.steps(), 1);
    EXPECT_TRUE(opened.scene() == shown);
}

TEST(MatchPreview, ADragBeginsWithTheModelAsItIsWithoutThePreview)
{
    Opened opened;
    KNOTSPAN_NEED_RENDERER(opened.window);
    opened.chooseOneThatWorks();
    const ObjectId id = opened.dialog->edge()->b;
    EXPECT_NE(opened.scene().find(id), opened.start.find(id));
    opened.window.resize(820, 460);
    opened.window.selection().setObjects({id});
    opened.window.selection().setPoints(pointOf(opened.scene(), {id, {0, 0}}));
    settle(opened.window);
    const auto point = visiblePoint(opened.window, id);
    ASSERT_TRUE(point);
    Hand(opened.window).drag(point->pixel, point->pixel + Vec2(8, 20));
    EXPECT_FALSE(opened.dialog->isPreviewing());
    EXPECT_EQ(opened.steps(), 1);
    for (const auto& [other, object] : opened.start.objects()) {
        if (other == id)
            continue;
        EXPECT_EQ(opened.scene().find(other), object);
    }
    const auto& before = opened.start.find(id)->surface.controlPoints();
    const auto& after = opened.scene().find(id)->surface.controlPoints();
    ASSERT_EQ(after.size(), before.size());
    int moved = 0;
    for (size_t k = 0; k < before.size(); ++k)
        moved += before[k] == after[k] ? 0 : 1;
    EXPECT_EQ(moved, 1);
}

TEST(MatchPreview, TellsTheNewVerdictOnceItIsApplied)
{
    Opened opened;
    opened.chooseOneThatWorks();
    const int row = opened.box("edge").currentIndex();
    EXPECT_TRUE(opened.box("edge").itemText(row).startsWith("G0: "));
    opened.click("apply");
    opened.wait();
    EXPECT_EQ(opened.box("edge").currentIndex(), row);
    EXPECT_TRUE(opened.box("edge").itemText(row).startsWith("G1: "))
        << opened.box("edge").itemText(row).toStdString();
    EXPECT_FALSE(says(opened.details(), "Then:")) << opened.details();
}

}  // namespace
}  // namespace knotspan
