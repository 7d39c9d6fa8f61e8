// The panel Measures says how large the selected objects are, of what, and of which area.
#include <cmath>
#include <numbers>

#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>

#include "model/geometry/primitives.h"
#include "tests/ui/one_surface_test.h"
#include "ui/panels/properties_view.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class PropertiesViewTest : public OneSurfaceTest {
protected:
    void SetUp() override
    {
        OneSurfaceTest::SetUp();
        if (IsSkipped())
            return;
        window->findChild<QDockWidget*>("measures-dock")->show();
        window->findChild<QDockWidget*>("measures-dock")->raise();
    }
    // Shows a model of these surfaces with all selected, and waits for its figures.
    void show(const std::vector<NurbsSurface>& surfaces, const Mat4& transform = Mat4(1))
    {
        Scene model;
        std::set<ObjectId> ids;
        for (const NurbsSurface& surface : surfaces)
            ids.insert(model.add({.name = "Shape", .transform = transform, .surface = surface}));
        window->document().reset(model, "Shapes");
        window->selection().setObjects(ids);
        waitForFigures();
    }
    void waitForFigures()
    {
        const auto* view = window->findChild<PropertiesView*>();
        QElapsedTimer clock;
        clock.start();
        settle(*window);
        QApplication::processEvents();  // the panel looks a turn of the event loop later
        while (view->isMeasuring() && clock.elapsed() < 60'000)
            QApplication::processEvents(QEventLoop::AllEvents, 20);
        ASSERT_FALSE(view->isMeasuring());
    }
    [[nodiscard]] QString text(const char* line)
    {
        return window->findChild<QLabel*>(QString("properties-") + line)->text();
    }
    [[nodiscard]] double area() { return text("area").section(' ', 0, 0).toDouble(); }
};

TEST_F(PropertiesViewTest, OfASphereAreThoseOfASphere)
{
    Mat4 transform(2);
    transform[3] = Vec4(10, 0, 0, 1);
    show({sphere(Vec3(0), 3)}, transform);
    EXPECT_EQ(text("objects"), "Shape");
    EXPECT_EQ(text("degrees"), "2 x 2");
    EXPECT_EQ(text("points"), "17 x 9 = 153");
    EXPECT_EQ(text("ksquads"), "32");
    EXPECT_EQ(text("low"), "4, -6, -6 mm");
    EXPECT_EQ(text("high"), "16, 6, 6 mm");
    EXPECT_EQ(text("size"), "12, 12, 12 mm");
    EXPECT_NEAR(area(), 4 * std::numbers::pi * 36, 1e-6);
}

TEST_F(PropertiesViewTest, OfSeveralObjectsAreTheirSumAndFollowEdits)
{
    show({plane(Vec3(0), {2, 0, 0}, {0, 3, 0}), cylinder({0, 0, 5}, 1, 4)});
    EXPECT_EQ(text("objects"), "2");
    EXPECT_EQ(text("degrees"), "several");
    EXPECT_NEAR(area(), 6 + 8 * std::numbers::pi, 1e-7);
    EXPECT_EQ(text("high"), "2, 3, 9 mm");
    act("edit.delete");
    waitForFigures();
    EXPECT_EQ(text("objects"), "none");
    EXPECT_EQ(text("area"), "-");
    EXPECT_FALSE(window->findChild<QPushButton*>("copy-properties")->isEnabled());
    window->document().undo();
    window->selection().setObjects({scene().objects().begin()->first});
    waitForFigures();
    EXPECT_NEAR(area(), 6, 1e-12);
    SceneObject wider = *scene().objects().begin()->second;
    wider.surface = plane(Vec3(0), {4, 0, 0}, {0, 3, 0});
    Edit edit;
    edit.set(scene().objects().begin()->first, std::make_shared<const SceneObject>(wider));
    window->document().apply(edit, "Widen");
    waitForFigures();
    EXPECT_NEAR(area(), 12, 1e-12);
    EXPECT_EQ(text("size"), "4, 3, 0 mm");
}

TEST_F(PropertiesViewTest, OfMeshesAreThoseOfTheirTriangles)
{
    Scene model;
    const ObjectId mesh = model.addMesh(meshObject("Scan", {{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}}));
    window->document().reset(model, "Scan");
    window->selection().setObjects({}, {mesh});
    waitForFigures();
    EXPECT_EQ(text("ksquads"), "none; 1 triangles");
    EXPECT_EQ(area(), 6);
    EXPECT_EQ(text("size"), "3, 4, 0 mm");
}

TEST_F(PropertiesViewTest, AreCopiedObjectByObject)
{
    show({plane(Vec3(0), {2, 0, 0}, {0, 3, 0}), plane({0, 0, 1}, {1, 0, 0}, {0, 1, 0})});
    window->findChild<QPushButton*>("copy-properties")->click();
    const QStringList lines = QApplication::clipboard()->text().trimmed().split('\n');
    ASSERT_EQ(lines.size(), 3);
    const QStringList cells = lines[1].split('\t');
    ASSERT_EQ(cells.size(), lines[0].split('\t').size());
    EXPECT_EQ(cells[0], "Shape");
    EXPECT_NEAR(cells[12].toDouble(), 6, 1e-12);
}

}  // namespace
}  // namespace knotspan
