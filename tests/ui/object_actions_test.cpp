// The menu Object.
#include <gtest/gtest.h>

#include <QAction>

#include "model/samples/sample_list.h"
#include "tests/ui/window_harness.h"
#include "ui/document_files.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

TEST(ObjectActions, TellTheSelectedObjectsWhichSidesToShow)
{
    Answers answers;
    MainWindow window(answering(answers));
    window.files().openSample("nine-16");
    const Scene before = window.document().scene();
    const ObjectId first = before.objects().begin()->first;
    const ObjectId last = before.objects().rbegin()->first;
    const auto sidesOf = [&](ObjectId id) { return window.document().scene().find(id)->sides; };
    EXPECT_FALSE(window.action("object.sidesFront")->isEnabled());
    window.selection().setObjects({first});
    EXPECT_TRUE(window.action("object.sidesAutomatic")->isChecked());
    const std::pair<const char*, Sides> kActions[] = {{"object.sidesFront", Sides::front},
                                                      {"object.sidesBack", Sides::back},
                                                      {"object.sidesBoth", Sides::both}};
    for (const auto& [id, sides] : kActions) {
        window.action(id)->trigger();
        EXPECT_EQ(sidesOf(first), sides);
        EXPECT_EQ(sidesOf(last), Sides::automatic);
        EXPECT_TRUE(window.action(id)->isChecked());
        EXPECT_FALSE(window.action("object.sidesAutomatic")->isChecked());
    }
    // Once more changes nothing, and is no step.
    const int steps = window.document().undoStack().count();
    window.action("object.sidesBoth")->trigger();
    EXPECT_EQ(window.document().undoStack().count(), steps);
    EXPECT_TRUE(window.action("object.sidesBoth")->isChecked());
    for (int k = 0; k < steps; ++k)
        window.document().undo();
    EXPECT_TRUE(window.document().scene() == before);
}

TEST(ObjectActions, HideIsolateAndDeleteMeshesToo)
{
    Answers answers;
    MainWindow window(answering(answers));
    Scene scene = findSample("nine-16")->make();
    const ObjectId mesh = scene.addMesh(meshObject("scan", {{{0, 0, 0}, {4, 0, 0}, {0, 0, 2}}, {{0, 1, 2}}}));
    window.document().reset(scene, "nine");
    const auto shows = [&] { return window.document().scene().meshes().at(mesh)->visible; };
    const auto shownObjects = [&] {
        const auto& objects = window.document().scene().objects();
        return std::count_if(objects.begin(), objects.end(),
                             [](const auto& entry) { return entry.second->visible; });
    };
    EXPECT_FALSE(window.action("edit.delete")->isEnabled());
    window.selection().setObjects({}, {mesh});
    EXPECT_TRUE(window.action("edit.delete")->isEnabled());
    EXPECT_FALSE(window.action("object.duplicate")->isEnabled()) << "no tool takes a mesh";
    window.action("object.isolate")->trigger();
    EXPECT_TRUE(shows());
    EXPECT_EQ(shownObjects(), 0);
    window.action("object.showAll")->trigger();
    EXPECT_EQ(shownObjects(), 9);
    window.action("object.hide")->trigger();
    EXPECT_FALSE(shows());
    EXPECT_TRUE(window.action("object.showAll")->isEnabled());
    window.document().undo();
    window.selection().setObjects({}, {mesh});
    window.action("edit.delete")->trigger();
    EXPECT_TRUE(window.document().scene().meshes().empty());
    EXPECT_TRUE(window.selection().meshes().empty());
    EXPECT_EQ(window.document().scene().objects().size(), 9U);
    window.document().undo();
    EXPECT_TRUE(window.document().scene().meshes().count(mesh) == 1);
}

}  // namespace
}  // namespace knotspan
