#include "model/geometry/knot_insertion.h"
#include "tests/ui/match_dialog_harness.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

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

TEST(MatchDialog, ItsEdgeIsTheOneThatTheViewportMarks)
{
    Opened opened;
    ShownFriends& shown = opened.window.shownFriends();
    const auto isMarked = [&] {
        const auto number = numberAmong(opened.window.friends().friends(), *opened.dialog->edge());
        return number && shown.chosen() == number;
    };
    opened.chooseOneThatWorks();
    EXPECT_TRUE(isMarked());
    EXPECT_FALSE(shown.lines().empty());
    const int another = opened.box("edge").currentIndex() == 0 ? 1 : 0;
    opened.box("edge").setCurrentIndex(another);
    Q_EMIT opened.box("edge").activated(another);
    opened.wait();
    EXPECT_EQ(opened.box("edge").currentIndex(), another);
    EXPECT_TRUE(isMarked());
    QTest::keyClick(opened.dialog, Qt::Key_Escape);
    EXPECT_FALSE(shown.chosen());
    EXPECT_TRUE(shown.lines().empty());
}

TEST(MatchDialog, ALaterSelectionCountsMoreThanTheChosenEdge)
{
    Opened opened;
    QTest::keyClick(opened.dialog, Qt::Key_Escape);
    ShownFriends& shown = opened.window.shownFriends();
    const SceneFriends& friends = opened.window.friends().friends();
    const FriendEdge& edge = friends.edges().back();
    const ObjectId first = opened.start.objects().begin()->first;
    ASSERT_NE(friends.objects()[edge.a.surface], first);
    shown.choose(friends.edges().size() - 1);
    opened.window.selection().setObjects({friends.objects()[edge.a.surface]});
    EXPECT_TRUE(shown.chosen());  // it has the edge
    opened.window.selection().setObjects({first});
    EXPECT_FALSE(shown.chosen());
    EXPECT_TRUE(shown.lines().empty());
    opened.window.action("edit.matchEdge")->trigger();
    opened.wait();
    ASSERT_TRUE(opened.dialog->edge());
    EXPECT_TRUE(opened.dialog->edge()->a == first || opened.dialog->edge()->b == first);
    QTest::keyClick(opened.dialog, Qt::Key_Escape);

    shown.choose(0);
    opened.window.action("edit.deselect")->trigger();
    EXPECT_FALSE(shown.chosen());
}

TEST(MatchDialog, SaysWhatElseItChanges)
{
    Opened opened;
    opened.window.files().openSample("hull");
    opened.window.selection().setObjects({opened.scene().objects().begin()->first});
    opened.wait();
    const auto find = [&] {
        for (int row = 0; row < opened.box("edge").count(); ++row)
            if (opened.box("edge").itemText(row).contains("v start of \"Port aft\""))
                return row;
        return -1;
    };
    const int row = find();
    ASSERT_GE(row, 0);
    opened.box("edge").setCurrentIndex(row);
    Q_EMIT opened.box("edge").activated(row);
    opened.wait();
    ASSERT_TRUE(opened.button("apply").isEnabled()) << opened.details();
    EXPECT_TRUE(says(opened.details(), "Also changes: ")) << opened.details();
    EXPECT_TRUE(says(opened.details(), "with \"Port midships\": G2 to G0")) << opened.details();
}

// Its index names another point then.
TEST(MatchDialog, LetsGoOfAControlPointWhoseNetGetsFiner)
{
    Opened opened;
    QTest::keyClick(opened.dialog, Qt::Key_Escape);
    const auto& [id, object] = *opened.start.objects().begin();
    Selection& selection = opened.window.selection();
    selection.setPoints(pointOf(opened.start, {id, {1, 1}}));
    opened.window.action("edit.matchEdge")->trigger();
    opened.wait();
    EXPECT_FALSE(selection.points().isEmpty());  // of a net that keeps its shape
    auto finer = std::make_shared<SceneObject>(*object);
    finer->surface = withKnotInserted(finer->surface, Direction::U, 0.5);
    Edit edit;
    edit.set(id, std::move(finer));
    opened.window.document().apply(edit, "Refine");
    EXPECT_TRUE(selection.points().isEmpty());
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
