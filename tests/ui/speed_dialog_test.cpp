#include "ui/speed_dialog.h"

#include <algorithm>
#include <fstream>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTest>

#include "model/samples/sample_list.h"
#include "renderer/measurement/flight.h"
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
    SpeedDialog dialog{window->document(), window->viewport(), answering(answers)};
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
    SpeedDialog dialog(window->document(), window->viewport(), answering(answers));
    dialog.show();
    dialog.measure();
    dialog.close();
    EXPECT_TRUE(waitFor([&] { return !dialog.isMeasuring(); }));
    EXPECT_TRUE(!dialog.hasFindings() || !dialog.rows().back().measured);
}

// The report of what was measured, as another program would read it.
nlohmann::json clipboard()
{
    return nlohmann::json::parse(QGuiApplication::clipboard()->text().toStdString());
}

TEST(Benchmark, TheReportHasEveryPathWithFiguresOrTheReasonWhyNot)
{
    Measured measured;
    KNOTSPAN_NEED_RENDERER(*measured.window);
    PathMeasurementRequest request = smallRequest(*measured.window);
    request.paths.clear();
    for (const PathInfo& path : paths())
        request.paths.push_back(path.id);
    request.tolerances = {4};
    request.motions = {Deformation::none};
    request.flight = flightAround(measured.window->document().scene(), 3, 1);
    measured.dialog.measure(request);
    ASSERT_TRUE(waitFor([&] { return !measured.dialog.isMeasuring(); }));
    settle(*measured.window);
    measured.dialog.findChild<QPushButton*>("copy")->click();
    const nlohmann::json report = clipboard();
    const Renderer& renderer = *measured.window->viewport().renderer();
    EXPECT_EQ(report.at("device"), renderer.deviceInfo().name);
    EXPECT_EQ(report.at("driver"), renderer.deviceInfo().driver);
    EXPECT_EQ(report.at("vulkan"), renderer.deviceInfo().vulkan);
    EXPECT_FALSE(renderer.deviceInfo().driver.empty());
    EXPECT_EQ(report.at("program").get<std::string>().find("knotspan "), 0U);
    EXPECT_EQ(report.at("ksquads"), measured.window->document().scene().ksQuadCount());
    EXPECT_EQ(report.at("model"), "Sample: torus");
    EXPECT_EQ(report.at("views"), 3);
    EXPECT_EQ(report.at("width"), 64);
    ASSERT_EQ(report.at("paths").size(), paths().size());
    for (const auto& row : report.at("paths")) {
        const std::string why = renderer.whyUnavailable(*findPath(row.at("path").get<std::string>()));
        if (!why.empty()) {
            EXPECT_EQ(row.at("unavailable"), why);
            const QString told = measured.dialog.findChild<QLabel*>("details")->text();
            EXPECT_TRUE(told.contains(QString::fromStdString(row.at("path")))) << told.toStdString();
            continue;
        }
        EXPECT_EQ(row.at("frames"), 3) << row;  // one a view
        EXPECT_GT(row.at("frame_ms").at("median"), 0) << row;
        EXPECT_GT(row.at("triangles"), 0) << row;
        EXPECT_GT(row.at("error_px_max"), 0) << row;
        EXPECT_GE(row.at("error_px_max"), row.at("error_px_mean")) << row;
    }
}

// No device draws such a picture.
TEST(Benchmark, APathThatFailsHasARowWithTheReasonAndTheOthersAreTriedToo)
{
    Measured measured;
    KNOTSPAN_NEED_TESSELLATION(*measured.window);
    PathMeasurementRequest request = smallRequest(*measured.window);
    request.paths = {PathId::tessellation, PathId::cpu};
    request.frame.width = 1'000'000;
    measured.dialog.measure(request);
    ASSERT_TRUE(waitFor([&] { return !measured.dialog.isMeasuring(); }));
    settle(*measured.window);
    ASSERT_EQ(measured.dialog.rows().size(), 8U);
    for (const PathRow& row : measured.dialog.rows()) {
        EXPECT_FALSE(row.measured);
        EXPECT_FALSE(row.unavailable.empty());
    }
    const nlohmann::json report = nlohmann::json::parse(measured.dialog.reportText());
    EXPECT_EQ(report.at("paths").back().at("unavailable"), measured.dialog.rows().back().unavailable);
}

TEST(Benchmark, WhatIsSavedIsWhatIsCopied)
{
    const TemporaryFolder folder;
    Measured measured;
    KNOTSPAN_NEED_RENDERER(*measured.window);
    const std::filesystem::path file = folder / "report.json";
    measured.answers.fileToSave = QString::fromStdString(file.string());
    measured.dialog.findChild<QPushButton*>("save")->click();
    std::ifstream saved(file);
    const nlohmann::json report = nlohmann::json::parse(saved);
    measured.dialog.findChild<QPushButton*>("copy")->click();
    EXPECT_EQ(report, clipboard());
    EXPECT_EQ(report.at("views"), 1);
    measured.answers.fileToSave = QString::fromStdString((folder / "none" / "report.json").string());
    measured.dialog.findChild<QPushButton*>("save")->click();
    const QString told = measured.dialog.findChild<QLabel*>("details")->text();
    EXPECT_TRUE(told.contains("none")) << told.toStdString();
}

TEST(Benchmark, TheActionFliesAndWhatWasNotReachedSaysSo)
{
    Answers answers;
    const auto window = shownWindow(answers, "torus");
    KNOTSPAN_NEED_RENDERER(*window);
    window->action("help.benchmark")->trigger();
    auto* dialog = window->findChild<SpeedDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(dialog->views(), SpeedDialog::Views::flight);
    EXPECT_TRUE(dialog->isMeasuring());
    auto* progress = dialog->findChild<QProgressBar*>("progress");
    ASSERT_TRUE(waitFor([&] { return progress->format().contains("view 1 of 8"); }));
    dialog->findChild<QPushButton*>("cancel")->click();
    ASSERT_TRUE(waitFor([&] { return !dialog->isMeasuring(); }));
    settle(*window);
    const nlohmann::json report = nlohmann::json::parse(dialog->reportText());
    EXPECT_EQ(report.at("views"), 8);
    EXPECT_EQ(report.at("paths").back().at("unavailable"), "The measurement was stopped before");
}

TEST(Benchmark, TheFlightSeesAllOfTheModelAndComesBackToWhereItBegan)
{
    const Scene scene = findSample("torus")->make();
    const std::vector<Camera> flight = flightAround(scene, 8, 1.5);
    ASSERT_EQ(flight.size(), 8U);
    const Camera first = *namedView("iso", scene.hullPoints(), 1.5, false);
    EXPECT_LT(glm::length(flight[0].eye - first.eye), 1e-9 * first.distance());
    std::vector<double> distances;
    for (const Camera& camera : flight) {
        EXPECT_LT(glm::length(camera.target - first.target), 1e-9 * first.distance());
        distances.push_back(camera.distance() / first.distance());
    }
    EXPECT_NEAR(*std::max_element(distances.begin(), distances.end()), 1, 1e-9);
    EXPECT_NEAR(*std::min_element(distances.begin(), distances.end()), 0.25, 1e-9);
    EXPECT_TRUE(flightAround(Scene(), 8, 1).empty());
}

TEST(SpeedDialog, EveryControlSaysWhatItIs)
{
    Document document;
    Selection selection;
    Viewport viewport(document, selection);
    Answers answers;
    const SpeedDialog dialog(document, viewport, answering(answers));
    for (const char* name : {"views", "motion", "measure", "cancel", "copy", "save"}) {
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
