// The swapchain shows on the screen what the renderer drew in its own image.
#include <gtest/gtest.h>

#include <QAction>
#include <QElapsedTimer>
#include <QPixmap>
#include <QScreen>
#include <QWindow>

#include "tests/ui/window_harness.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

QImage screenshot(const QWindow& surface)
{
    const QPoint corner = surface.mapToGlobal(QPoint(0, 0));
    return surface.screen()
        ->grabWindow(0, corner.x(), corner.y(), surface.width(), surface.height())
        .toImage()
        .convertToFormat(QImage::Format_RGB32);
}

// The server shows a frame a moment after it was presented.
int differenceOnScreen(MainWindow& window, const QWindow& surface)
{
    QElapsedTimer clock;
    clock.start();
    int difference = 0;
    do {
        settle(window);
        difference = differingPixels(screenshot(surface), picture(window));
    } while (difference > 0 && clock.elapsed() < 5000);
    return difference;
}

TEST(SwapchainPresenter, TheScreenShowsTheRenderersPicture)
{
    Answers answers;
    const auto window = shownWindow(answers, "nine-16");
    KNOTSPAN_NEED_RENDERER(*window);
    const auto* surface = qobject_cast<QWindow*>(window->viewport().surface());
    ASSERT_NE(surface, nullptr) << "the viewport fell back to the read-back picture";
    EXPECT_EQ(differenceOnScreen(*window, *surface), 0);
    const QImage model = screenshot(*surface);

    window->document().reset(Scene(), "empty");
    EXPECT_EQ(differenceOnScreen(*window, *surface), 0);
    EXPECT_GT(differingPixels(screenshot(*surface), model), model.width() * model.height() / 30);
    EXPECT_EQ(window->message(), QString());
}

TEST(SwapchainPresenter, FollowsResizingAndPanels)
{
    Answers answers;
    const auto window = shownWindow(answers, "single-100");
    KNOTSPAN_NEED_RENDERER(*window);
    const auto* surface = qobject_cast<QWindow*>(window->viewport().surface());
    ASSERT_NE(surface, nullptr);
    for (const QSize size : {QSize(700, 420), QSize(900, 500), QSize(760, 380)}) {
        window->resize(size);
        settle(*window);
        EXPECT_EQ(differenceOnScreen(*window, *surface), 0) << size.width();
    }
    window->hide();
    settle(*window);
    window->show();
    EXPECT_EQ(differenceOnScreen(*window, *surface), 0);
    EXPECT_EQ(window->message(), QString());
}

TEST(SwapchainPresenter, ADragOnTheNativeWindowMovesAControlPoint)
{
    Answers answers;
    const auto window = shownWindow(answers, "single-100");
    KNOTSPAN_NEED_RENDERER(*window);
    const auto* surface = qobject_cast<QWindow*>(window->viewport().surface());
    ASSERT_NE(surface, nullptr);
    const ObjectId object = window->document().scene().objects().begin()->first;
    window->selection().setObjects({object});
    settle(*window);
    const auto point = visiblePoint(*window, object);
    ASSERT_TRUE(point.has_value());
    const Vec3 before = positionOf(*window, *point);
    Hand(*window).drag(point->pixel, point->pixel + Vec2(25, 15));
    EXPECT_NE(positionOf(*window, *point), before);
    EXPECT_EQ(differenceOnScreen(*window, *surface), 0);
    EXPECT_EQ(window->document().undoStack().count(), 1);
}

}  // namespace
}  // namespace knotspan
