#include <set>

#include <gtest/gtest.h>

#include <QBuffer>
#include <QSignalSpy>
#include <QTest>

#include "ui/plots/path_plot.h"
#include "ui/plots/plot_axis.h"
#include "ui/plots/plot_svg.h"
#include "ui/plots/plot_view.h"

namespace knotspan {
namespace {

PathRow row(PathId path, std::optional<double> tolerance, double ms, double error)
{
    PathRow made{.path = path, .tolerancePx = tolerance, .evaluator = Evaluator::automatic};
    made.measured = true;
    made.frameMs = {ms, ms, ms};
    made.stats.errorPxMax = error;
    return made;
}

std::vector<PathRow> rows()
{
    return {row(PathId::tessellation, 4, 1, 3), row(PathId::tessellation, 0.5, 5, 0.4),
            row(PathId::mesh9x9, {}, 2, 0.9)};
}

TEST(PathPlot, HasACurveForAPathAndAMarkerForOneWithoutTolerance)
{
    const PathPlot made = pathPlot(rows(), {});
    ASSERT_EQ(made.plot.markers.size(), 3U);
    ASSERT_EQ(made.plot.curves.size(), 1U);
    EXPECT_EQ(made.plot.curves[0].markers, (std::vector<size_t>{0, 1}));
    EXPECT_EQ(made.rows, (std::vector<size_t>{0, 1, 2}));
    EXPECT_EQ(made.plot.markers[1].x, 5);
    EXPECT_EQ(made.plot.markers[1].y, 0.4);
    EXPECT_NE(made.plot.markers[0].look.colour, made.plot.markers[2].look.colour);
    ASSERT_EQ(made.plot.legend.size(), 2U);
    EXPECT_EQ(made.plot.legend[1].text, "mesh-9x9");
}

TEST(PathPlot, LeavesOutWhatIsNotMeasuredAndKeepsTheColours)
{
    std::vector<PathRow> some = rows();
    const std::string colour = pathPlot(some, {}).plot.markers[2].look.colour;
    some[0].measured = false;
    some[1].motion = Deformation::all;
    const PathPlot made = pathPlot(some, {});
    ASSERT_EQ(made.plot.markers.size(), 1U);
    EXPECT_EQ(made.rows, (std::vector<size_t>{2}));
    EXPECT_EQ(made.plot.markers[0].look.colour, colour);
}

TEST(PathPlot, RingsThePointsNextToTheTolerance)
{
    const PathPlot made = pathPlot(rows(), {Deformation::none, PathId::tessellation, 0.6});
    EXPECT_FALSE(made.plot.markers[0].look.ringed);
    EXPECT_TRUE(made.plot.markers[1].look.ringed);
    EXPECT_TRUE(made.plot.markers[2].look.ringed);
    EXPECT_TRUE(made.plot.curves[0].strong);
}

TEST(PathPlot, MarksLeaks)
{
    std::vector<PathRow> some = rows();
    some[1].stats.leakPixels = 3;
    some[2].stats.leakPixels = 0;
    const Plot plot = pathPlot(some, {}).plot;
    EXPECT_EQ(plot.markers[1].look.shape, MarkerShape::square);
    EXPECT_EQ(plot.markers[2].look.shape, MarkerShape::circle);
    EXPECT_NE(plot.markers[1].text.find("3 leaking"), std::string::npos) << plot.markers[1].text;
}

TEST(PathPlot, NoTwoPathsLookAlike)
{
    std::vector<PathRow> all;
    for (const PathInfo& path : paths())
        all.push_back(row(path.id, 1, 1, 1));
    std::set<std::pair<std::string, bool>> looks;
    for (const Marker& marker : pathPlot(all, {}).plot.markers)
        EXPECT_TRUE(looks.insert({marker.look.colour, marker.look.filled}).second);
}

TEST(PlotAxis, HoldsAllValuesInOrder)
{
    const PlotAxis axis({0.02, 3, 700}, 100, 500);
    EXPECT_EQ(axis.pixel(0), 100);
    EXPECT_GT(axis.pixel(0.02), 100);
    EXPECT_LT(axis.pixel(0.02), axis.pixel(3));
    EXPECT_LT(axis.pixel(700), 500);
    EXPECT_GE(axis.ticks().size(), 5U);
    EXPECT_EQ(tickText(0.01), "0.01");
    EXPECT_EQ(tickText(20), "20");
    EXPECT_EQ(tickText(1e-7), "1e-7");
    EXPECT_EQ(tickText(1e6), "1e6");
}

TEST(PlotAxis, GoesNoFurtherThanItsValuesNeed)
{
    const auto ends = [](const std::vector<double>& values) {
        const auto ticks = PlotAxis(values, 0, 1).ticks();
        return std::pair(tickText(ticks.front().value), tickText(ticks.back().value));
    };
    using Ends = std::pair<std::string, std::string>;
    EXPECT_EQ(ends({12, 75}), Ends("10", "100"));
    EXPECT_EQ(ends({24, 130}), Ends("20", "200"));
    EXPECT_EQ(ends({0.17, 7.7}), Ends("0.1", "10"));
    EXPECT_EQ(ends({3}), Ends("2", "5"));
    EXPECT_EQ(ends({10}), Ends("5", "20"));
    EXPECT_EQ(ends({4e-16, 3e-7}), Ends("1e-16", "1e-6"));
    EXPECT_EQ(ends({}), Ends("0.5", "2"));
}

TEST(PlotAxis, LabelsAtMostADozenDecades)
{
    for (const double high : {1e3, 1e7, 1e12, 1e13, 1e24, 1e60}) {
        const PlotAxis axis({2, high}, 0, 1);
        int labels = 0;
        for (const PlotAxis::Tick& tick : axis.ticks())
            labels += tick.labelled ? 1 : 0;
        EXPECT_GE(labels, 4) << high;
        EXPECT_LE(labels, 14) << high;
        EXPECT_DOUBLE_EQ(axis.pixel(axis.ticks().back().value), 1) << high;
    }
}

TEST(PlotSvg, HasEveryPlotOneBelowTheOther)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    const Plot plot = pathPlot(rows(), {}).plot;
    ASSERT_TRUE(writeSvg({plot, plot}, buffer));
    EXPECT_EQ(buffer.data().count("class=\"marker\""), 6);
    EXPECT_EQ(buffer.data().count("class=\"curve\""), 2);
    EXPECT_TRUE(buffer.data().contains("height=\"1200\""));
}

TEST(PlotView, ArrowsGoFromMarkerToMarkerAndEnterChooses)
{
    PlotView view;
    QSignalSpy chosen(&view, &PlotView::chosen);
    QTest::keyClick(&view, Qt::Key_Right);  // nothing to go to
    view.setPlot(pathPlot(rows(), {}).plot);
    QTest::keyClick(&view, Qt::Key_Return);  // on nothing yet
    EXPECT_EQ(chosen.count(), 0);
    QTest::keyClick(&view, Qt::Key_Left);
    EXPECT_EQ(view.currentMarker(), 2U);
    QTest::keyClick(&view, Qt::Key_Right);
    EXPECT_EQ(view.currentMarker(), 0U);
    QTest::keyClick(&view, Qt::Key_Space);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen[0][0].toInt(), 0);
    view.setPlot({});
    EXPECT_EQ(view.currentMarker(), std::nullopt);
}

TEST(PlotView, PaintsItsMarkersWhereItSaysTheyAre)
{
    PlotView view;
    view.resize(900, 500);
    view.setPlot(pathPlot(rows(), {}).plot);
    const QImage image = view.grab().toImage();
    const QPointF place = view.markerPosition(0) * image.devicePixelRatio();
    const QColor wanted(QString::fromStdString(view.plot().markers[0].look.colour));
    const QColor found = image.pixelColor(place.toPoint());
    EXPECT_LT(std::abs(found.red() - wanted.red()) + std::abs(found.blue() - wanted.blue()), 100);
}

}  // namespace
}  // namespace knotspan
