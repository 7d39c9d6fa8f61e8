// Surfaces trimmed by the borders of others that are selected with them; what is left is found by picks.
#include <glm/geometric.hpp>

#include <QStatusBar>

#include "model/geometry/primitives.h"
#include "model/trimming/trim_region.h"
#include "tests/ui/one_surface_test.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class BorderTrimTest : public ::testing::Test {
protected:
    void SetUp() override
    {
        window = shownWindow(answers, "single-100");
        if (window->viewport().renderer() == nullptr)
            GTEST_SKIP() << "no Vulkan device here";
        const ObjectId sample = window->document().scene().objects().begin()->first;
        Edit edit;
        edit.set(sample, nullptr);
        edit.set(ground, object("ground", plane({-2, -2, 0}, {4, 0, 0}, {0, 4, 0})));
        edit.set(disc, object("disc", cone({0.5, 0.3, 1}, 0.8, 0, 0)));
        edit.set(other, object("other", cone({-1, -1, 2}, 0.5, 0, 0)));
        edit.set(ball, object("ball", sphere({0, 0, 3}, 0.5)));
        window->document().apply(edit, "Begin");
        act("view.top");
        if (!window->viewport().frame().camera.orthographic)
            act("view.orthographic");
        settle(*window);
        start = scene();
        begun = steps();
    }
    static SharedObject object(const char* name, NurbsSurface surface)
    {
        SceneObject made{.surface = std::move(surface)};
        made.name = name;
        return std::make_shared<SceneObject>(std::move(made));
    }
    [[nodiscard]] const Scene& scene() { return window->document().scene(); }
    [[nodiscard]] int steps() { return window->document().undoStack().count(); }
    void act(const char* name) { window->action(name)->trigger(); }
    // One after the other.
    void select(const std::vector<ObjectId>& ids)
    {
        window->selection().clear();
        std::set<ObjectId> chosen;
        for (const ObjectId id : ids) {
            chosen.insert(id);
            window->selection().setObjects(chosen);
        }
    }
    [[nodiscard]] std::string said() { return window->statusBar()->currentMessage().toStdString(); }
    [[nodiscard]] bool says(const char* words) { return said().find(words) != std::string::npos; }
    // Of a grid of places of the ground those that are left though `isAway` says otherwise, or the reverse.
    template <class IsAway>
    int wrongPlaces(const IsAway& isAway)
    {
        const SharedObject face = scene().find(ground);
        const TrimRegion region(face->trimLoops, face->surface);
        int wrong = 0;
        for (double x = -1.99; x < 2; x += 0.05)
            for (double y = -1.99; y < 2; y += 0.05)
                wrong += region.contains((x + 2) / 4, (y + 2) / 4) == isAway(Vec2(x, y));
        return wrong;
    }

    const ObjectId ground{101};
    const ObjectId disc{102};
    const ObjectId other{103};
    const ObjectId ball{104};
    Answers answers;
    std::unique_ptr<MainWindow> window;
    Scene start;
    int begun = 0;
};

bool isInDisc(const Vec2& at)
{
    return glm::distance(at, Vec2(0.5, 0.3)) < 0.8;
}
bool isInOther(const Vec2& at)
{
    return glm::distance(at, Vec2(-1, -1)) < 0.5;
}

TEST_F(BorderTrimTest, TheSurfaceSelectedLastIsTrimmedByTheOthersInOneStep)
{
    select({disc, other, ground});
    act("edit.trimBySelected");
    EXPECT_EQ(steps(), begun + 1) << said();
    EXPECT_TRUE(says("Keep inside selected")) << said();
    EXPECT_EQ(scene().find(ground)->trimLoops.size(), 2U);
    EXPECT_EQ(wrongPlaces([](const Vec2& at) { return isInDisc(at) || isInOther(at); }), 0);
    EXPECT_EQ(scene().find(disc), start.find(disc));
    const Scene trimmed = scene();
    act("edit.undo");
    EXPECT_TRUE(scene() == start);
    act("edit.redo");
    EXPECT_TRUE(scene() == trimmed);
}

TEST_F(BorderTrimTest, WhatLiesInsideCanStay)
{
    select({disc, ground});
    act("edit.keepInsideSelected");
    EXPECT_EQ(steps(), begun + 1) << said();
    EXPECT_TRUE(says("Trim by selected")) << said();
    EXPECT_EQ(wrongPlaces([](const Vec2& at) { return !isInDisc(at); }), 0);
    act("edit.undo");
    EXPECT_TRUE(scene() == start);
}

// As Trim by selected takes away what is inside any of them.
TEST_F(BorderTrimTest, WhatLiesInsideAnyOfSeveralCanStay)
{
    select({disc, other, ground});
    act("edit.keepInsideSelected");
    EXPECT_EQ(steps(), begun + 1) << said();
    EXPECT_EQ(wrongPlaces([](const Vec2& at) { return !isInDisc(at) && !isInOther(at); }), 0);
    act("edit.undo");
    Edit edit;
    edit.set(other, object("other", cone({0, 0, 2}, 0.5, 0, 0)));  // now it reaches into the disc
    window->document().apply(edit, "Move");
    const Scene before = scene();
    act("edit.keepInsideSelected");
    EXPECT_TRUE(says("overlap")) << said();
    EXPECT_TRUE(scene() == before);
}

// The hole is where the picture has the disc, and with perspective too.
TEST_F(BorderTrimTest, TheHoleIsWhatTheDiscHides)
{
    act("view.orthographic");
    ASSERT_FALSE(window->viewport().frame().camera.orthographic);
    settle(*window);
    const PictureSize size = window->viewport().pictureSize();
    const auto hitOf = [&](ObjectId id, double x, double y) {
        const Result<Pick> pick = window->viewport().renderer()->pick(x, y);
        return pick && pick->place && pick->place->object == id;
    };
    std::vector<Vec2> hidden;
    std::vector<Vec2> seen;
    for (double y = 5.5; y < size.height; y += 9)
        for (double x = 5.5; x < size.width; x += 9) {
            bool isNearBorder = false;
            for (const double by : {-2.0, 2.0})
                isNearBorder = isNearBorder || hitOf(disc, x + by, y) != hitOf(disc, x, y) ||
                               hitOf(disc, x, y + by) != hitOf(disc, x, y);
            if (isNearBorder)
                continue;
            if (hitOf(disc, x, y))
                hidden.push_back({x, y});
            else if (hitOf(ground, x, y))
                seen.push_back({x, y});
        }
    ASSERT_GT(hidden.size(), 20U);
    ASSERT_GT(seen.size(), 20U);
    select({disc, ground});
    act("edit.trimBySelected");
    ASSERT_EQ(steps(), begun + 1) << said();
    Edit edit;
    edit.set(disc, nullptr);
    edit.set(ball, nullptr);
    window->document().apply(edit, "Take away");
    settle(*window);
    int wrong = 0;
    for (const Vec2& at : hidden)
        wrong += hitOf(ground, at.x, at.y);
    for (const Vec2& at : seen)
        wrong += !hitOf(ground, at.x, at.y);
    EXPECT_EQ(wrong, 0);
}

TEST_F(BorderTrimTest, SaysWhyNotAndChangesNothing)
{
    const auto refused = [&](const char* words) {
        act("edit.trimBySelected");
        EXPECT_TRUE(says(words)) << said();
        EXPECT_TRUE(scene() == start);
        EXPECT_EQ(steps(), begun);
    };
    window->selection().clear();
    refused("One more surface");
    select({ground});
    refused("One more surface");
    window->selection().clear();
    window->selection().setObjects({disc, ground});
    refused("at once");
    select({ball, ground});
    refused("no border");
    select({disc, other});
    refused("does not meet");
    // One of two is enough to refuse, and is named.
    select({disc, ball, ground});
    refused("ball: ");
    // Which was last is forgotten with it.
    select({disc, other, ground});
    window->selection().setObjects({disc, other});
    refused("at once");
}

TEST_F(BorderTrimTest, WhatIsHiddenIsNotTrimmed)
{
    SceneObject hidden = *scene().find(ground);
    hidden.visible = false;
    Edit edit;
    edit.set(ground, std::make_shared<SceneObject>(hidden));
    window->document().apply(edit, "Hide");
    const Scene before = scene();
    select({disc, ground});
    act("edit.trimBySelected");
    EXPECT_TRUE(says("hidden")) << said();
    EXPECT_TRUE(scene() == before);
}

// What was said of a step is not true any more where it is taken back.
TEST_F(BorderTrimTest, UndoTakesTheMessageBack)
{
    select({disc, ground});
    act("edit.trimBySelected");
    EXPECT_TRUE(says("ground")) << said();
    act("edit.undo");
    EXPECT_EQ(said(), "");
    act("edit.trimBySelected");
    EXPECT_TRUE(says("ground")) << said();
}

}  // namespace
}  // namespace knotspan
