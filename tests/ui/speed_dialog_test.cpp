#include "ui/speed_dialog.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTest>

#include "tests/ui/window_harness.h"
#include "ui/plots/plot_view.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

constexpr int kLongest = 240'000;  // milliseconds: a driver may compile shaders first

template <class Condition>
bool waitFor(const Condition& condition)
{
    return QTest::qWaitFor(condition, kLongest);
}

// One path in a small picture.
PathMeasurementRequest smallRequest(MainWindow& window)
{
    PathMeasurementRequest request;
    request.frame = window.viewport().frame();
    request.frame.width = 64;
    request.frame.height = 64;
    request.paths = {PathId::tessellation};
    request.tolerances = {4, 0.5};
    request.motions = {Deformation::none, Deformation::all};
    request.frames = 1;
    return request;
}

struct Measured {
    Answers answers;
    std::unique_ptr<MainWindow> window = shownWindow(answers, "torus");
    SpeedDialog dialog{window->document(), window->viewport()};
    PlotView& plot = *dialog.findChild<PlotView*>("plot");

    Measured()
    {
        dialog.show();
        dialog.measure(smallRequest(*window));
        EXPECT_TRUE(waitFor([this] { return !dialog.isMeasuring(); }));
        settle(*window);
    }
};

#define KNOTSPAN_NEED_TESSELLATION(window)                                             \
    KNOTSPAN_NEED_RENDERER(window);                                                    \
    if (!(window).viewport().renderer()->whyUnavailable(PathId::tessellation).empty()) \
    GTEST_SKIP() << (window).viewport().renderer()->whyUnavailable(PathId::tessellation)

TEST(SpeedDialog, TheActionOpensItMeasuresAndCancelStopsItBeforeTheEnd)
{
    Answers answers;
    const auto window = shownWindow(answers, "torus");
    KNOTSPAN_NEED_RENDERER(*window);
    const QImage before = picture(*window);
    window->action("view.speed")->trigger();
    auto* dialog = window->findChild<SpeedDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_TRUE(dialog->isVisible());
    EXPECT_TRUE(dialog->isMeasuring());
    auto* cancel = dialog->findChild<QPushButton*>("cancel");
    auto* again = dialog->findChild<QPushButton*>("measure");
    EXPECT_TRUE(cancel->isEnabled());
    EXPECT_FALSE(again->isEnabled());
    const auto isFirstRowMeasured = [&] { return dialog->hasFindings() && dialog->rows().front().measured; };
    ASSERT_TRUE(waitFor([&] { return isFirstRowMeasured() || !dialog->isMeasuring(); }));
    cancel->click();
    ASSERT_TRUE(waitFor([&] { return again->isEnabled(); }));
    EXPECT_FALSE(dialog->isMeasuring());
    EXPECT_FALSE(cancel->isEnabled());
    ASSERT_TRUE(dialog->hasFindings());
    EXPECT_FALSE(dialog->rows().back().measured);
    const auto* details = dialog->findChild<QLabel*>("details");
    EXPECT_TRUE(details->text().contains("Stopped after")) << details->text().toStdString();
    settle(*window);
    EXPECT_EQ(differingPixels(picture(*window), before), 0);  // the viewport's renderer had no part in it
}

TEST(SpeedDialog, AClickOnAPointSetsItsPathAndTolerance)
{
    Measured measured;
    KNOTSPAN_NEED_TESSELLATION(*measured.window);
    const Viewport& viewport = measured.window->viewport();
    ASSERT_EQ(measured.plot.plot().markers.size(), 2U);
    ASSERT_EQ(measured.plot.plot().curves.size(), 1U);
    for (const size_t marker : {0U, 1U}) {
        QTest::mouseClick(&measured.plot, Qt::LeftButton, {}, measured.plot.markerPosition(marker).toPoint());
        EXPECT_EQ(viewport.frame().path, PathId::tessellation);
        EXPECT_EQ(viewport.frame().tolerancePx, marker == 0 ? 4 : 0.5);
        EXPECT_TRUE(measured.plot.plot().markers[marker].look.ringed);
        EXPECT_FALSE(measured.plot.plot().markers[1 - marker].look.ringed);
        EXPECT_TRUE(measured.plot.plot().curves[0].strong);
    }
}

TEST(SpeedDialog, TheKeyboardDoesWhatTheMouseDoes)
{
    Measured measured;
    KNOTSPAN_NEED_TESSELLATION(*measured.window);
    const auto* details = measured.dialog.findChild<QLabel*>("details");
    QTest::keyClick(&measured.plot, Qt::Key_Home);
    EXPECT_TRUE(details->text().startsWith("tessellation at 4 px: ")) << details->text().toStdString();
    EXPECT_EQ(measured.plot.accessibleDescription(), details->text());
    QTest::keyClick(&measured.plot, Qt::Key_Right);
    QTest::keyClick(&measured.plot, Qt::Key_Return);
    EXPECT_EQ(measured.window->viewport().frame().tolerancePx, 0.5);
    EXPECT_TRUE(measured.dialog.isVisible());
}

TEST(SpeedDialog, ShowsTheDeformingModelToo)
{
    Measured measured;
    KNOTSPAN_NEED_TESSELLATION(*measured.window);
    const std::string still = measured.plot.plot().xLabel;
    measured.dialog.findChild<QComboBox*>("motion")->setCurrentIndex(1);
    EXPECT_NE(measured.plot.plot().xLabel, still);
    EXPECT_EQ(measured.plot.plot().markers.size(), 2U);
}

TEST(SpeedDialog, AnotherModelTakesTheFindingsAway)
{
    Measured measured;
    KNOTSPAN_NEED_RENDERER(*measured.window);
    EXPECT_TRUE(measured.dialog.hasFindings());
    measured.window->document().reset(Scene(), "empty");
    EXPECT_FALSE(measured.dialog.hasFindings());
    EXPECT_TRUE(measured.plot.plot().markers.empty());
    measured.dialog.measure();
    EXPECT_FALSE(measured.dialog.isMeasuring());
    const auto* details = measured.dialog.findChild<QLabel*>("details");
    EXPECT_TRUE(details->text().contains("Open a model first")) << details->text().toStdString();
}

TEST(SpeedDialog, ClosingItStopsTheMeasurement)
{
    Answers answers;
    const auto window = shownWindow(answers, "torus");
    KNOTSPAN_NEED_RENDERER(*window);
    SpeedDialog dialog(window->document(), window->viewport());
    dialog.show();
    dialog.measure();
    dialog.close();
    EXPECT_TRUE(waitFor([&] { return !dialog.isMeasuring(); }));
    EXPECT_TRUE(!dialog.hasFindings() || !dialog.rows().back().measured);
}

TEST(SpeedDialog, EveryControlSaysWhatItIs)
{
    Document document;
    Selection selection;
    Viewport viewport(document, selection);
    const SpeedDialog dialog(document, viewport);
    for (const char* name : {"motion", "measure", "cancel"}) {
        const auto* widget = dialog.findChild<QWidget*>(name);
        ASSERT_NE(widget, nullptr) << name;
        EXPECT_FALSE(widget->accessibleName().isEmpty()) << name;
        EXPECT_FALSE(widget->toolTip().isEmpty()) << name;
    }
    for (const char* name : {"plot", "progress", "details"})
        EXPECT_FALSE(dialog.findChild<QWidget*>(name)->accessibleName().isEmpty()) << name;
}

}  // namespace
}  // namespace knotspan
