// The history: named steps, a click that goes there, and what it does to a running preview.
#include <gtest/gtest.h>

#include <QAction>

#include "tests/ui/window_harness.h"
#include "ui/document_files.h"
#include "ui/panels/history_panel.h"

namespace knotspan::testing {
namespace {

struct Shown {
    Answers answers;
    MainWindow window{answering(answers)};
    HistoryPanel* panel = nullptr;
    std::vector<Scene> scenes;

    Shown()
    {
        window.files().openSample("nine-16");
        panel = window.findChild<HistoryPanel*>();
        scenes.push_back(scene());
    }
    [[nodiscard]] const Scene& scene() { return window.document().scene(); }
    void deleteOne()
    {
        const ObjectId first = scene().objects().begin()->first;
        window.selection().setObjects({first});
        window.action("edit.delete")->trigger();
        scenes.push_back(scene());
    }
    [[nodiscard]] std::string text(int row) const { return panel->item(row)->text().toStdString(); }
};

TEST(HistoryPanel, NamesTheStepsAndGoesToTheOneThatIsClicked)
{
    Shown shown;
    ASSERT_EQ(shown.panel->count(), 1);
    for (int k = 0; k < 5; ++k)
        shown.deleteOne();
    ASSERT_EQ(shown.panel->count(), 6);
    EXPECT_NE(shown.text(0).find("as it was opened"), std::string::npos) << shown.text(0);
    EXPECT_EQ(shown.text(3), "Delete an object");
    EXPECT_EQ(shown.panel->currentRow(), 5);
    for (const int row : {2, 4, 0, 5, 1}) {
        shown.panel->setCurrentRow(row);
        EXPECT_TRUE(shown.scene() == shown.scenes[static_cast<size_t>(row)]) << row;
        EXPECT_EQ(shown.panel->count(), 6);
    }
    shown.window.action("edit.redo")->trigger();
    EXPECT_EQ(shown.panel->currentRow(), 2);
    shown.deleteOne();  // what was taken back is gone
    EXPECT_EQ(shown.panel->count(), 4);
    shown.window.files().openSample("sphere");
    EXPECT_EQ(shown.panel->count(), 1);
}

TEST(HistoryPanel, AClickTakesAPreviewBackFirst)
{
    Shown shown;
    shown.deleteOne();
    Edit edit;
    edit.set(shown.scene().objects().begin()->first, nullptr);
    EXPECT_NE(shown.window.document().preview(edit, "Preview"), 0);
    EXPECT_EQ(shown.panel->count(), 2);
    shown.panel->setCurrentRow(0);
    EXPECT_TRUE(shown.scene() == shown.scenes[0]);
    shown.panel->setCurrentRow(1);
    EXPECT_TRUE(shown.scene() == shown.scenes[1]);
}

}  // namespace
}  // namespace knotspan::testing
