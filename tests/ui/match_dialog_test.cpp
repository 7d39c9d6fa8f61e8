#include "ui/match_dialog.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "model/geometry/knot_insertion.h"
#include "tests/ui/window_harness.h"
#include "ui/document_files.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

// The window with the patchwork, one cushion selected, and the dialog.
struct Opened {
    Answers answers;
    MainWindow window{answering(answers)};
    Scene start;
    MatchDialog* dialog = nullptr;

    Opened()
    {
        window.files().openSample("nine-16");
        start = scene();
        window.show();
        window.selection().setObjects({start.objects().begin()->first});
        window.action("edit.matchEdge")->trigger();
        dialog = window.findChild<MatchDialog*>();
        wait();
    }

    void wait() const
    {
        EXPECT_TRUE(QTest::qWaitFor([this] { return !dialog->isLooking(); }, 10'000));
    }
    [[nodiscard]] const Scene& scene() { return window.document().scene(); }
    [[nodiscard]] int steps() { return window.document().undoStack().count(); }
    [[nodiscard]] QComboBox& box(const char* name) const { return *dialog->findChild<QComboBox*>(name); }
    [[nodiscard]] QPushButton& button(const char* name) const
    {
        return *dialog->findChild<QPushButton*>(name);
    }
    [[nodiscard]] std::string details() const
    {
        return dialog->findChild<QLabel*>("details")->text().toStdString();
    }
    void click(const char* name) const { QTest::mouseClick(&button(name), Qt::LeftButton); }
    [[nodiscard]] bool isSmooth()
    {
        const auto edge = foundAgain(scene(), *dialog->edge(), {});
        return edge && edge->edge.areFriends();
    }
    // The first that Match can mend as the dialog stands.
    void chooseOneThatWorks() const
    {
        wait();
        for (int row = 0; row < box("edge").count() && !button("apply").isEnabled(); ++row) {
            box("edge").setCurrentIndex(row);
            Q_EMIT box("edge").activated(row);
            wait();
        }
        ASSERT_TRUE(button("apply").isEnabled()) << details();
    }
};

bool says(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

TEST(MatchDialog, ShowsWhatMovesBeforeItIsAppliedAndApplyIsOneStep)
{
    Opened opened;
    ASSERT_EQ(opened.box("edge").count(), 2);
    opened.chooseOneThatWorks();
    EXPECT_TRUE(says(opened.details(), "Now: G0, largest angle")) << opened.details();
    EXPECT_TRUE(says(opened.details(), "Then: largest angle")) << opened.details();
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

TEST(MatchDialog, EscapeTakesThePreviewBackToTheBit)
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

TEST(MatchDialog, WithoutThePreviewNothingMovesUntilApply)
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

TEST(MatchDialog, MovesTheSideThatIsChosen)
{
    Opened opened;
    opened.chooseOneThatWorks();
    for (const int row : {0, 1, 2}) {
        opened.box("move").setCurrentIndex(row);
        EXPECT_TRUE(opened.dialog->isLooking());
        opened.wait();
        const ObjectEdge edge = *opened.dialog->edge();
        EXPECT_EQ(opened.scene().find(edge.a) != opened.start.find(edge.a), row != 1) << row;
        EXPECT_EQ(opened.scene().find(edge.b) != opened.start.find(edge.b), row != 0) << row;
        EXPECT_TRUE(opened.isSmooth());
    }
    opened.click("apply");
    EXPECT_EQ(opened.steps(), 1);  // however many were looked at
}

TEST(MatchDialog, ReachesG2AndSaysSo)
{
    Opened opened;
    opened.chooseOneThatWorks();
    opened.box("target").setCurrentIndex(2);
    opened.wait();
    ASSERT_TRUE(opened.button("apply").isEnabled()) << opened.details();
    opened.click("apply");
    opened.wait();
    EXPECT_TRUE(says(opened.details(), "Now: G2")) << opened.details();
}

TEST(MatchDialog, SaysWhyItCannot)
{
    Opened opened;
    // Flat sheets that lie on each other fold back at their edge.
    const SharedObject one = opened.start.objects().begin()->second;
    Scene folded;
    folded.add(*one);
    folded.add(*one);
    opened.window.document().reset(folded, "folded");
    EXPECT_TRUE(says(opened.details(), "Now") || says(opened.details(), "Select")) << opened.details();
    opened.window.selection().setObjects({folded.objects().begin()->first});
    opened.wait();
    ASSERT_TRUE(opened.dialog->edge().has_value());
    EXPECT_FALSE(opened.button("apply").isEnabled());
    EXPECT_TRUE(says(opened.details(), "The surfaces fold back on each other along the edge."))
        << opened.details();
    EXPECT_FALSE(opened.dialog->isPreviewing());
    EXPECT_TRUE(opened.scene() == folded);
}

TEST(MatchDialog, WhateverElseIsDoneKeepsThePreviewAsAStep)
{
    Opened opened;
    opened.chooseOneThatWorks();
    const Scene shown = opened.scene();
    const ObjectId last = opened.start.objects().rbegin()->first;
    opened.window.selection().setObjects({last});
    opened.chooseOneThatWorks();
    const Scene other = opened.scene();
    EXPECT_FALSE(other == shown);
    opened.window.action("edit.delete")->trigger();
    EXPECT_EQ(opened.steps(), 2);
    EXPECT_FALSE(opened.dialog->isPreviewing());
    opened.wait();
    EXPECT_TRUE(says(opened.details(), "no longer there")) << opened.details();
    opened.window.document().undo();
    EXPECT_TRUE(opened.scene() == other);
    opened.window.document().undo();
    EXPECT_TRUE(opened.scene() == opened.start);
    opened.wait();
    EXPECT_TRUE(says(opened.details(), "Now: G0")) << opened.details();
    EXPECT_TRUE(opened.scene() == opened.start);  // it waits for the hand before it shows anything again
}

// Its index names another point then.
TEST(MatchDialog, LetsGoOfAControlPointWhoseNetGetsFiner)
{
    Opened opened;
    QTest::keyClick(opened.dialog, Qt::Key_Escape);
    const auto& [id, object] = *opened.start.objects().begin();
    Selection& selection = opened.window.selection();
    selection.setControlPoint(PickedControlPoint{id, {1, 1}}, object.get());
    opened.window.action("edit.matchEdge")->trigger();
    opened.wait();
    EXPECT_TRUE(selection.controlPoint().has_value());  // of a net that keeps its shape
    auto finer = std::make_shared<SceneObject>(*object);
    finer->surface = withKnotInserted(finer->surface, Direction::U, 0.5);
    Edit edit;
    edit.set(id, std::move(finer));
    opened.window.document().apply(edit, "Refine");
    EXPECT_FALSE(selection.controlPoint().has_value());
    EXPECT_TRUE(selection.contains(id));
}

TEST(MatchDialog, TakesTheEdgeThatIsChosenAmongTheFriends)
{
    Opened opened;
    opened.chooseOneThatWorks();
    const SceneFriends& friends = opened.window.friends().friends();
    QTest::keyClick(opened.dialog, Qt::Key_Escape);
    const size_t number = friends.edges().size() - 1;
    opened.window.shownFriends().choose(number);
    opened.window.action("edit.matchEdge")->trigger();
    opened.wait();
    const auto isChosen = [&](size_t k) {
        const SceneFriends& now = opened.window.friends().friends();
        return opened.dialog->edge()->a == now.objects()[now.edges()[k].a.surface] &&
               opened.dialog->edge()->b == now.objects()[now.edges()[k].b.surface];
    };
    EXPECT_TRUE(isChosen(number));
    opened.window.shownFriends().choose(0);  // while it is open
    opened.wait();
    EXPECT_TRUE(isChosen(0));
    const int another = opened.box("edge").currentIndex() == 0 ? 1 : 0;
    opened.box("edge").setCurrentIndex(another);
    Q_EMIT opened.box("edge").activated(another);
    opened.wait();
    EXPECT_FALSE(isChosen(0));  // the dialog's own choice counts until another is made elsewhere
}

TEST(MatchDialog, AnotherModelTakesTheEdgesAway)
{
    Opened opened;
    opened.window.files().openSample("hull");
    EXPECT_FALSE(opened.dialog->edge().has_value());
    EXPECT_EQ(opened.box("edge").count(), 0);
    opened.wait();
    EXPECT_TRUE(says(opened.details(), "Select an object")) << opened.details();
    EXPECT_FALSE(opened.button("apply").isEnabled());
}

TEST(MatchDialog, EveryControlSaysWhatItIs)
{
    const Opened opened;
    for (const char* name :
         {"edge", "target", "move", "gap", "angle", "curvature", "preview", "apply", "close"}) {
        const auto* widget = opened.dialog->findChild<QWidget*>(name);
        ASSERT_NE(widget, nullptr) << name;
        EXPECT_FALSE(widget->accessibleName().isEmpty()) << name;
        EXPECT_FALSE(widget->toolTip().isEmpty()) << name;
    }
}

}  // namespace
}  // namespace knotspan
