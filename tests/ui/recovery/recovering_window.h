// A window that looks for what others left behind, with a hand for its buttons.
#pragma once

#include <QPushButton>

#include "tests/ui/window_harness.h"
#include "ui/document_files.h"
#include "ui/recovery_bar.h"

namespace knotspan::testing {

class RecoveringWindow {
public:
    explicit RecoveringWindow(const std::filesystem::path& place,
                              std::chrono::milliseconds interval = std::chrono::milliseconds(10))
        : window_(answering(answers))
    {
        window_.keepForRecovery(place, interval);
        window_.files().openSample("single-100");
        window_.show();
    }

    [[nodiscard]] MainWindow& window() { return window_; }
    [[nodiscard]] Document& document() { return window_.document(); }
    // What the bar says; empty where it is not there.
    [[nodiscard]] QString offer() const
    {
        const auto* bar = window_.findChild<RecoveryBar*>();
        return bar->isVisible() ? bar->sentence() : QString();
    }
    [[nodiscard]] bool has(const char* button) const
    {
        return window_.findChild<QPushButton*>(button)->isVisible();
    }
    void click(const char* button) { window_.findChild<QPushButton*>(button)->click(); }

    Answers answers;

private:
    MainWindow window_;
};

}  // namespace knotspan::testing
