// What the tests of Match edge share: a window with the dialog up.
#pragma once

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "tests/ui/window_harness.h"
#include "ui/document_files.h"
#include "ui/match_dialog.h"

namespace knotspan::testing {

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

inline bool says(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

}  // namespace knotspan::testing
