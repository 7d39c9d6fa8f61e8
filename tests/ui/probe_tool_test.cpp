// Probes: the surface's own place under the cursor, pinned with a click, following the model.
#include <glm/geometric.hpp>

#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTableView>

#include "model/geometry/evaluation.h"
#include "tests/ui/one_surface_test.h"
#include "ui/document_files.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class ProbeToolTest : public OneSurfaceTest {
protected:
    void SetUp() override
    {
        OneSurfaceTest::SetUp();
        if (IsSkipped())
            return;
        window->findChild<QDockWidget*>("measures-dock")->show();
        window->findChild<QDockWidget*>("measures-dock")->raise();
        act("tools.probe");
        rest();
    }
    // The panel looks a turn of the event loop after what it shows has changed.
    void rest()
    {
        settle(*window);
        QApplication::processEvents();
    }
    [[nodiscard]] Probes& probes() { return window->viewport().probes(); }
    [[nodiscard]] Vec2 place(double dx = 13, double dy = 7)
    {
        const PictureSize size = window->viewport().pictureSize();
        return {size.width * 0.5 + dx, size.height * 0.5 + dy};
    }
    [[nodiscard]] Vec2 pixelOf(const Probe& probe)
    {
        const PictureSize size = window->viewport().pictureSize();
        const auto at = window->viewport().frame().camera.toPixel(probed(scene(), probe)->measures.position,
                                                                  size.width, size.height);
        return at.value_or(Vec2(-1e9));
    }
    template <class Widget>
    [[nodiscard]] Widget& named(const char* name)
    {
        return *window->findChild<Widget*>(name);
    }
    [[nodiscard]] QAbstractItemModel& table() { return *named<QTableView>("probes").model(); }
    [[nodiscard]] QString cell(int row, const QString& title)
    {
        for (int column = 0; column < table().columnCount(); ++column)
            if (table().headerData(column, Qt::Horizontal).toString() == title)
                return table().index(row, column).data().toString();
        ADD_FAILURE() << "no column " << title.toStdString();
        return {};
    }
    // Moves all control points along z, as a drag does.
    void lift(double by, int gesture)
    {
        SceneObject moved = *scene().find(id);
        std::vector<ControlPoint> points = moved.surface.controlPoints();
        for (ControlPoint& point : points)
            point.position.z += by;
        moved.surface = *NurbsSurface::create(moved.surface.knotsU(), moved.surface.knotsV(), points);
        Edit edit;
        edit.set(id, std::make_shared<const SceneObject>(moved));
        window->document().apply(edit, "Lift", gesture);
    }
};

TEST_F(ProbeToolTest, TellsOfTheSurfacesOwnPlaceUnderTheCursor)
{
    Hand hand(*window);
    const QImage before = picture(*window);
    hand.hover(place());
    rest();
    ASSERT_TRUE(probes().live());
    EXPECT_LT(glm::distance(pixelOf(*probes().live()), place()), 1.0);
    EXPECT_GT(differingPixels(before, picture(*window)), 100) << "normal and principal directions show";
    const ProbedPlace there = *probed(scene(), *probes().live());
    const SurfacePoint exact = evaluate(start.find(id)->surface, there.u, there.v);
    EXPECT_LT(glm::distance(there.measures.position, exact.position), 1e-12);
    EXPECT_TRUE(named<QLabel>("probe-readout").text().contains(QString("u = %1").arg(there.u, 0, 'g', 7)));
    EXPECT_EQ(table().rowCount(), 0);
    hand.hover({2, 2});
    rest();
    EXPECT_FALSE(probes().live());
    EXPECT_EQ(differingPixels(before, picture(*window)), 0);
    EXPECT_EQ(steps(), 0) << "it changes nothing";
}

TEST_F(ProbeToolTest, AClickPinsAndADragTurnsTheView)
{
    Hand hand(*window);
    hand.click(place());
    hand.click(place(-40, 20));
    hand.click({2, 2});
    rest();
    ASSERT_EQ(probes().pins().size(), 2U);
    EXPECT_EQ(table().rowCount(), 2);
    EXPECT_EQ(cell(1, "Probe"), "2");
    const Camera camera = window->viewport().frame().camera;
    hand.drag(place(), place(60, 30));
    rest();
    EXPECT_FALSE(window->viewport().frame().camera == camera);
    EXPECT_EQ(probes().pins().size(), 2U);
    EXPECT_EQ(steps(), 0);
}

TEST_F(ProbeToolTest, PinsFollowTheSurfaceAlsoWhileItIsDragged)
{
    Hand hand(*window);
    hand.click(place());
    rest();
    const Vec3 before = probed(scene(), probes().pins()[0])->measures.position;
    const Vec2 pixel = pixelOf(probes().pins()[0]);
    const int gesture = window->document().newGesture();
    for (const double by : {0.01, 0.02, 0.03}) {
        lift(0.01, gesture);
        rest();
        EXPECT_NEAR(cell(0, "z (mm)").toDouble(), before.z + by, 1e-6) << "in the middle of the drag";
    }
    EXPECT_GT(glm::distance(pixelOf(probes().pins()[0]), pixel), 0.5);
    window->document().cancelGesture(gesture);
    rest();
    EXPECT_NEAR(cell(0, "z (mm)").toDouble(), before.z, 1e-6);
    act("edit.delete");
    rest();
    EXPECT_TRUE(probes().pins().empty()) << "it goes with its object";
    EXPECT_EQ(table().rowCount(), 0);
}

TEST_F(ProbeToolTest, TwoPinsHaveADistanceAndThreeAnAngle)
{
    Hand hand(*window);
    const auto text = [this] { return named<QLabel>("probe-distances").text(); };
    hand.click(place(-50, 10));
    rest();
    EXPECT_FALSE(text().contains("mm"));
    hand.click(place(0, 30));
    hand.click(place(40, -10));
    rest();
    const auto at = [this](size_t k) { return probed(scene(), probes().pins()[k])->measures; };
    const auto figure = [](double value) { return QString::number(value, 'g', 7); };
    const Separation last = separation(at(1), at(2));
    EXPECT_TRUE(text().startsWith("2 to 3: " + figure(last.distance) + " mm")) << text().toStdString();
    EXPECT_TRUE(text().contains("dx " + figure(last.difference.x))) << text().toStdString();
    EXPECT_TRUE(text().contains(figure(*last.normalsDeg))) << text().toStdString();
    auto& view = named<QTableView>("probes");
    view.selectAll();
    EXPECT_TRUE(
        text().contains("Angle at 2: " + figure(*angleAtDeg(at(1).position, at(0).position, at(2).position))))
        << text().toStdString();
    // The selection outlasts an edit, and what is said follows it.
    lift(0.5, 0);
    hand.click(place(10, 10));
    rest();
    EXPECT_EQ(view.selectionModel()->selectedRows().size(), 3);
    EXPECT_TRUE(text().contains("Angle at 2: "));
    view.selectAll();
    EXPECT_TRUE(text().startsWith("Through these 4 probes: ")) << text().toStdString();
}

TEST_F(ProbeToolTest, PinsAreCopiedRemovedAndCleared)
{
    Hand hand(*window);
    for (const double dx : {-50, 0, 40})
        hand.click(place(dx, 10));
    rest();
    ASSERT_EQ(table().rowCount(), 3);
    named<QPushButton>("copy-probes").click();
    const QStringList lines = QApplication::clipboard()->text().trimmed().split('\n');
    ASSERT_EQ(lines.size(), 4);
    const QStringList cells = lines[2].split('\t');
    EXPECT_EQ(cells.size(), table().columnCount());
    EXPECT_EQ(lines[0].split('\t')[4], "x (mm)");
    EXPECT_NEAR(cells[4].toDouble(), probed(scene(), probes().pins()[1])->measures.position.x, 1e-13);
    // Not by selectRow(), which heeds keys that a test before this one left down.
    named<QTableView>("probes").selectionModel()->select(
        table().index(1, 0), QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    named<QPushButton>("copy-probes").click();
    EXPECT_EQ(QApplication::clipboard()->text().trimmed().split('\n').size(), 2);
    named<QPushButton>("remove-probes").click();
    rest();
    ASSERT_EQ(table().rowCount(), 2);
    EXPECT_EQ(cell(1, "Probe"), "3") << "numbers stay";
    named<QPushButton>("clear-probes").click();
    rest();
    EXPECT_EQ(table().rowCount(), 0);
    EXPECT_FALSE(named<QPushButton>("copy-probes").isEnabled());
    hand.click(place());
    rest();
    EXPECT_EQ(cell(0, "Probe"), "1");
    window->files().openSample("nine-16");
    EXPECT_TRUE(probes().pins().empty()) << "another model";
}

}  // namespace
}  // namespace knotspan
