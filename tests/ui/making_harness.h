// What the tests of the dialogs that make or move objects share.
#pragma once

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "tests/ui/window_harness.h"
#include "ui/document_files.h"
#include "ui/making_dialog.h"

namespace knotspan::testing {

// A window with a sample (its name empty: an empty document) and the dialog that was brought up.
struct MakingWindow {
    Answers answers;
    MainWindow window{answering(answers)};
    Scene start;
    MakingDialog* dialog = nullptr;

    explicit MakingWindow(const char* sample)
    {
        if (*sample != 0)
            window.files().openSample(sample);
        start = scene();
        window.show();
    }

    template <class Dialog>
    void bringUp(const char* action)
    {
        window.action(action)->trigger();
        dialog = window.findChild<Dialog*>();
        wait();
    }
    void wait() const
    {
        EXPECT_TRUE(QTest::qWaitFor([this] { return !dialog->isLooking(); }, 10'000));
    }
    [[nodiscard]] const Scene& scene() { return window.document().scene(); }
    // Asked only where nothing is shown: who looks at the stack takes a preview back.
    [[nodiscard]] int steps() { return window.document().undoStack().count(); }
    void undo() { window.action("edit.undo")->trigger(); }
    // The first `count` objects.
    void select(int count)
    {
        std::set<ObjectId> ids;
        for (const auto& [id, object] : start.objects())
            if (count-- > 0)
                ids.insert(id);
        window.selection().setObjects(ids);
    }
    template <class Widget>
    [[nodiscard]] Widget& the(const char* name) const
    {
        return *dialog->findChild<Widget*>(name);
    }
    void choose(const char* name, int index) const
    {
        the<QComboBox>(name).setCurrentIndex(index);
        wait();
    }
    // As a hand types it.
    void type(const char* name, double value) const
    {
        auto& box = the<QDoubleSpinBox>(name);
        box.setFocus();
        box.selectAll();
        QTest::keyClicks(&box, box.locale().toString(value, 'f', box.decimals()));
        QTest::keyClick(&box, Qt::Key_Tab);
        wait();
    }
    void click(const char* name) const { QTest::mouseClick(&the<QPushButton>(name), Qt::LeftButton); }
    [[nodiscard]] std::string details() const { return the<QLabel>("details").text().toStdString(); }
    [[nodiscard]] bool canApply() const { return the<QPushButton>("apply").isEnabled(); }

    // Shown, not yet done; then one step of that name; then taken back to the bit.
    void expectOneStep(const char* text)
    {
        EXPECT_TRUE(dialog->isPreviewing()) << details();
        EXPECT_FALSE(window.document().canUndo());
        EXPECT_FALSE(scene() == start);
        const Scene shown = scene();
        click("apply");
        EXPECT_TRUE(scene() == shown);
        EXPECT_EQ(steps(), 1);
        EXPECT_EQ(window.document().undoText(), QString(text));
    }
    void expectUndone()
    {
        undo();
        EXPECT_TRUE(scene() == start);
        EXPECT_FALSE(window.document().canUndo());
    }
    void expectNothing(const char* sentence)
    {
        EXPECT_NE(details().find(sentence), std::string::npos) << details();
        EXPECT_FALSE(canApply());
        EXPECT_FALSE(dialog->isPreviewing());
        EXPECT_TRUE(scene() == start);
    }
};

}  // namespace knotspan::testing
