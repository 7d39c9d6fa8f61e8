// Keep friends, by pointer and key in the window.
#include <gtest/gtest.h>

#include <QAction>
#include <QSettings>
#include <QStatusBar>

#include <glm/geometric.hpp>

#include "model/friends/scene_friends.h"
#include "model/geometry/knot_insertion.h"
#include "model/scene/edit.h"
#include "tests/ui/window_harness.h"
#include "ui/document_files.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

struct Kept {
    Answers answers;
    std::unique_ptr<MainWindow> window;

    explicit Kept(const std::string& sample) : window(shownWindow(answers, sample)) { keep(true); }
    ~Kept() { QSettings().remove("keepFriends"); }

    void keep(bool on)
    {
        QAction& action = *window->action("edit.keepFriends");
        if (action.isChecked() != on)
            action.trigger();
    }
    [[nodiscard]] const Scene& scene() const { return window->document().scene(); }
    [[nodiscard]] int steps() const { return window->document().undoStack().count(); }
};

// A control point in the first two rows beside an edge, looked at from near.
std::optional<VisiblePoint> pointBesideAnEdge(Kept& kept)
{
    for (const auto& [id, object] : kept.scene().objects()) {
        kept.window->selection().setObjects({id});
        kept.window->viewport().fitSelection();
        settle(*kept.window);
        const auto point = visiblePoint(*kept.window, id);
        const auto isBeside = [](int k, int count) { return k < 2 || k >= count - 2; };
        if (point && (isBeside(point->index.i, object->surface.countU()) ||
                      isBeside(point->index.j, object->surface.countV())))
            return point;
    }
    return std::nullopt;
}

size_t movedObjects(const Scene& before, const Scene& after)
{
    size_t count = 0;
    for (const auto& [id, object] : before.objects())
        count += object == after.find(id) ? 0U : 1U;
    return count;
}

TEST(KeepFriendsInTheWindow, IsASwitchThatTheSettingsRemember)
{
    Answers answers;
    {
        MainWindow window(answering(answers));
        EXPECT_FALSE(window.viewport().toolSettings().keepFriends);
        window.action("edit.keepFriends")->trigger();
        EXPECT_TRUE(window.viewport().toolSettings().keepFriends);
        EXPECT_TRUE(window.action("edit.keepFriends")->isChecked());
        EXPECT_TRUE(window.statusBar()->currentMessage().startsWith("Keep friends is on"));
    }
    MainWindow window(answering(answers));
    EXPECT_TRUE(window.action("edit.keepFriends")->isChecked());
    window.action("edit.keepFriends")->trigger();
    EXPECT_FALSE(window.viewport().toolSettings().keepFriends);
    EXPECT_TRUE(window.statusBar()->currentMessage().startsWith("Keep friends is off"));
    QSettings().remove("keepFriends");
}

TEST(KeepFriendsInTheWindow, KeepsEveryEdgeOfTheKnotSmoothThroughADragOfOneStep)
{
    Kept kept("knot");
    KNOTSPAN_NEED_RENDERER(*kept.window);
    const auto point = pointBesideAnEdge(kept);
    ASSERT_TRUE(point.has_value());
    const Scene before = kept.scene();
    SceneFriends friends;
    friends.follow(before);
    const size_t edges = friends.edges().size();
    Hand hand(*kept.window);
    hand.press(point->pixel);
    for (const Vec2 way : {Vec2(4, 3), Vec2(9, -6), Vec2(14, 2)}) {
        hand.move(point->pixel + way);
        EXPECT_GE(movedObjects(before, kept.scene()), 2U);
        friends.follow(kept.scene());
        EXPECT_EQ(friends.edges().size(), edges);
        for (const FriendEdge& edge : friends.edges())
            ASSERT_TRUE(edge.areFriends()) << edge.angleBoundDeg;
    }
    hand.release();
    EXPECT_EQ(kept.steps(), 1);
    EXPECT_EQ(kept.window->message(), "");
    kept.window->document().undo();
    EXPECT_TRUE(kept.scene() == before);
}

TEST(KeepFriendsInTheWindow, EscapeTakesBackAllThatFollowed)
{
    Kept kept("hull");
    KNOTSPAN_NEED_RENDERER(*kept.window);
    const auto point = pointBesideAnEdge(kept);
    ASSERT_TRUE(point.has_value());
    const Scene before = kept.scene();
    Hand hand(*kept.window);
    hand.press(point->pixel);
    hand.move(point->pixel + Vec2(20, 10));
    EXPECT_GE(movedObjects(before, kept.scene()), 1U);
    kept.window->action("edit.deselect")->trigger();
    EXPECT_EQ(movedObjects(before, kept.scene()), 0U);  // the very same objects
    hand.move(point->pixel + Vec2(30, 10));
    hand.release();
    EXPECT_EQ(movedObjects(before, kept.scene()), 0U);
    EXPECT_EQ(kept.steps(), 0);
    EXPECT_FALSE(kept.window->document().isModified());
}

// Every object but one gets more knots both ways: edges of that one have other knots on their two sides.
Scene withOtherKnotsAround(const Scene& scene, ObjectId left)
{
    Scene changed = scene;
    for (const auto& [id, object] : scene.objects()) {
        if (id == left)
            continue;
        auto finer = std::make_shared<SceneObject>(*object);
        for (const Direction direction : {Direction::U, Direction::V}) {
            const KnotVector& knots =
                direction == Direction::U ? finer->surface.knotsU() : finer->surface.knotsV();
            const double between = knots.domainStart() + 0.37 * (knots.domainEnd() - knots.domainStart());
            finer->surface = withKnotInserted(finer->surface, direction, between);
        }
        changed.exchange(id, std::move(finer));
    }
    return changed;
}

TEST(KeepFriendsInTheWindow, SaysWhyAPointStaysAndMovesItWhenSwitchedOff)
{
    Kept kept("knot");
    KNOTSPAN_NEED_RENDERER(*kept.window);
    const auto found = pointBesideAnEdge(kept);
    ASSERT_TRUE(found.has_value());
    const Camera camera = kept.window->viewport().frame().camera;
    kept.window->document().reset(withOtherKnotsAround(kept.scene(), found->object), "refined");
    settle(*kept.window);
    kept.window->viewport().setCamera(camera);
    kept.window->selection().setObjects({found->object});
    settle(*kept.window);
    const auto point = visiblePoint(*kept.window, found->object);
    ASSERT_TRUE(point.has_value());
    const Scene before = kept.scene();

    Hand hand(*kept.window);
    hand.press(point->pixel);
    hand.move(point->pixel + Vec2(8, 3));
    EXPECT_EQ(movedObjects(before, kept.scene()), 0U);
    const QString name = QString::fromStdString(kept.scene().find(point->object)->name);
    const QString hint = kept.window->statusBar()->currentMessage();
    EXPECT_TRUE(hint.contains("cannot follow")) << hint.toStdString();
    EXPECT_TRUE(hint.contains('"' + name + '"')) << hint.toStdString();
    EXPECT_EQ(kept.window->message(), "");  // the picture stays under the hand
    hand.release();
    EXPECT_EQ(kept.window->message(), hint);
    EXPECT_EQ(kept.steps(), 0);
    EXPECT_FALSE(kept.window->document().isModified());

    kept.keep(false);
    settle(*kept.window);
    const auto again = visiblePoint(*kept.window, point->object);
    ASSERT_TRUE(again.has_value());
    hand.drag(again->pixel, again->pixel + Vec2(8, 3));
    EXPECT_EQ(movedObjects(before, kept.scene()), 1U);
    EXPECT_EQ(kept.steps(), 1);
    EXPECT_EQ(kept.window->message(), "");
}

}  // namespace
}  // namespace knotspan
