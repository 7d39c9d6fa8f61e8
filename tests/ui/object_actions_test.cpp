// The menu Object.
#include <gtest/gtest.h>

#include <QAction>

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

}  // namespace
}  // namespace knotspan
