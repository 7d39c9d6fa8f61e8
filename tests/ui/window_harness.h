// What the window's tests share: a window whose questions are answered without a hand, a hand that sends
// pointer events to whichever surface the viewport has, and waiting for the picture.
#pragma once

#include <filesystem>
#include <memory>

#include <QApplication>
#include <QImage>

#include "tests/support.h"
#include "ui/main_window.h"
#include "ui/panels/stats_panel.h"

namespace knotspan::testing {

// Answers, and what was asked.
struct Answers {
    SaveAnswer saveChanges = SaveAnswer::discard;
    QStringList filesToOpen;
    QString fileToSave;
    int askedToSave = 0;
    bool overwrite = true;
    int askedToOverwrite = 0;
};

[[nodiscard]] Questions answering(Answers& answers);

// Handles events until the picture is drawn and nothing more is to be drawn; false after four minutes (the
// first frame of a path waits for the driver's compiler).
bool settle(MainWindow& window);

// A small window (software Vulkan is slow) with a sample, shown and drawn.
[[nodiscard]] std::unique_ptr<MainWindow> shownWindow(Answers& answers, const std::string& sample);

// The figures beside the picture.
[[nodiscard]] StatsPanel& statsOf(MainWindow& window);

// A file of a sample.
[[nodiscard]] std::filesystem::path sampleFile(const TemporaryFolder& folder, const std::string& name);

// The renderer's last picture.
[[nodiscard]] QImage picture(MainWindow& window);

// How many pixels differ by more than `tolerance` in some channel; all, where the sizes differ.
[[nodiscard]] int differingPixels(const QImage& a, const QImage& b, int tolerance = 2);

// Pointer events, in pixels of the picture.
class Hand {
public:
    explicit Hand(MainWindow& window) : window_(window) {}

    void press(Vec2 at, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {});
    void move(Vec2 to);
    void release();
    void click(Vec2 at, Qt::KeyboardModifiers keys = {});
    void drag(Vec2 from, Vec2 to, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {});
    void wheel(Vec2 at, int notches);
    // Presses and releases a key; true where the picture used it up.
    bool key(int key, const QString& text = {}, Qt::KeyboardModifiers keys = {});
    // No button down.
    void hover(Vec2 at, Qt::KeyboardModifiers keys = {});

private:
    void send(QEvent::Type type, Qt::MouseButton button);

    MainWindow& window_;
    Vec2 at_{};
    Qt::MouseButton down_ = Qt::NoButton;
    Qt::KeyboardModifiers keys_;
};

// A control point that the picture shows well inside its borders and away from the others of its object.
struct VisiblePoint {
    ObjectId object{};
    ControlPointIndex index;
    Vec2 pixel{};
};
[[nodiscard]] std::optional<VisiblePoint> visiblePoint(MainWindow& window, ObjectId object);
[[nodiscard]] Vec3 positionOf(MainWindow& window, const VisiblePoint& point);

}  // namespace knotspan::testing

// Where no Vulkan device is installed there is no picture to test.
#define KNOTSPAN_NEED_RENDERER(window)             \
    if ((window).viewport().renderer() == nullptr) \
    GTEST_SKIP() << "no Vulkan device here: install mesa-vulkan-drivers to run this test"
