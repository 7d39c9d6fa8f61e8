// The window on a display, walked through station by station; each station is one picture of the user guide.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "tests/ui/window_harness.h"

namespace knotspan::testing {

class Tour {
public:
    Tour();
    ~Tour();

    [[nodiscard]] MainWindow& window() { return *window_; }
    [[nodiscard]] Viewport& viewport() { return window_->viewport(); }
    [[nodiscard]] Hand& hand() { return hand_; }

    // A sample, as if opened; nothing is selected and nothing but the picture itself is shown of it.
    void show(const std::string& sample);
    void act(const char* action) { window_->action(action)->trigger(); }
    void showPanel(const char* dock);
    void shade(const char* shading);
    // A part of the picture, from 0 to 1 across and down.
    [[nodiscard]] Vec2 at(double across, double down);
    // The widget of that name in any of the program's windows; a failed test where there is none.
    template <class Widget>
    [[nodiscard]] Widget* find(const char* name)
    {
        for (QWidget* top : QApplication::topLevelWidgets())
            if (auto* found =
                    top->objectName() == name ? qobject_cast<Widget*>(top) : top->findChild<Widget*>(name))
                return found;
        ADD_FAILURE() << "there is no " << name;
        return nullptr;
    }
    // Handles events until `done`; a failed test after two minutes.
    void wait(const std::function<bool()>& done);

    // What the screen shows of the window and what stands in front of it.
    [[nodiscard]] QImage screenshot();

private:
    Answers answers_;
    std::unique_ptr<MainWindow> window_;
    Hand hand_;
};

struct TourStation {
    const char* name;  // of the picture's file
    void (*go)(Tour& tour);
};
[[nodiscard]] const std::vector<TourStation>& tourStations();

}  // namespace knotspan::testing
