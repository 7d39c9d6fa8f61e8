// What the user guide shows, in its order.
#include <QApplication>
#include <QLineEdit>
#include <QScrollArea>

#include "tests/tour/tour.h"
#include "ui/speed_dialog.h"

namespace knotspan::testing {

namespace {

void selectFirst(Tour& tour)
{
    tour.window().selection().setObjects({tour.window().document().scene().objects().begin()->first});
    settle(tour.window());
}

// The page is what a new window shows.
void start(Tour& tour)
{
    tour.act("help.start");
    settle(tour.window());
}

void overview(Tour& tour)
{
    tour.show("hull");
    tour.showPanel("objects-dock");
}

void pull(Tour& tour)
{
    tour.show("single-100");
    tour.showPanel("tool-dock");
    selectFirst(tour);
    const ObjectId object = *tour.window().selection().objects().begin();
    const auto& surface = tour.window().document().scene().find(object)->surface;
    const PictureSize size = tour.viewport().pictureSize();
    const auto pixel =
        tour.viewport().frame().camera.toPixel(surface.controlPoint(4, 5).position, size.width, size.height);
    ASSERT_TRUE(pixel.has_value());
    tour.hand().drag(*pixel, *pixel - Vec2(0, 90));
    tour.hand().click(*pixel - Vec2(0, 90));
}

void brush(Tour& tour)
{
    tour.show("single-100");
    tour.viewport().setTool("grab");
    const Vec2 middle = tour.at(0.45, 0.5);
    tour.hand().drag(middle, middle - Vec2(0, 60));
    tour.hand().hover(middle - Vec2(10, 40));
}

void views(Tour& tour)
{
    tour.show("hull");
    tour.act("view.fourPanes");
}

void zebra(Tour& tour)
{
    tour.show("hull");
    tour.shade("zebra");
}

void curvature(Tour& tour)
{
    tour.show("torus");
    tour.showPanel("measures-dock");
    tour.shade("curvature");
    tour.viewport().setTool("probe");
    tour.hand().click(tour.at(0.2, 0.6));
    tour.hand().click(tour.at(0.7, 0.6));
    tour.hand().hover(tour.at(0.45, 0.64));
}

void combs(Tour& tour)
{
    tour.show("hull");
    tour.showPanel("measures-dock");
    selectFirst(tour);
    tour.act("view.combs");
    tour.act("view.section");
}

// A sheet that was pulled, beside the one that it was.
void deviation(Tour& tour)
{
    tour.show("single-100");
    tour.showPanel("measures-dock");
    SceneObject sheet = *tour.window().document().scene().objects().begin()->second;
    SceneObject pulled = sheet;
    std::vector<ControlPoint> points = sheet.surface.controlPoints();
    points[44].position.z += 0.8;
    points[45].position.z += 0.5;
    const auto made = NurbsSurface::create(sheet.surface.knotsU(), sheet.surface.knotsV(), points);
    ASSERT_TRUE(made.has_value());
    pulled.surface = *made;
    sheet.visible = false;
    Scene both;
    const ObjectId measured = both.add(pulled);
    const ObjectId reference = both.add(sheet);
    tour.window().document().reset(both, "Sheets");
    ShownDeviation& shown = tour.viewport().deviation();
    shown.setSettings({{measured}, {reference}});
    tour.act("view.deviation");
    tour.wait([&shown] { return shown.map() != nullptr && !shown.isMeasuring(); });
    auto* legend = tour.find<QWidget>("deviation-legend");
    for (QWidget* above = legend; above != nullptr; above = above->parentWidget())
        if (auto* scrolling = qobject_cast<QScrollArea*>(above))
            scrolling->ensureWidgetVisible(legend);
}

void friends(Tour& tour)
{
    tour.show("hull");
    tour.showPanel("friends-dock");
    tour.act("view.friends");
}

void refine(Tour& tour)
{
    tour.show("single-100");
    selectFirst(tour);
    tour.act("edit.refine");
}

// A rounded hole, drawn and cut, and a second curve that is being drawn.
void trim(Tour& tour)
{
    tour.show("single-100");
    tour.act("view.top");
    settle(tour.window());
    tour.act("tools.trim");
    for (const Vec2& place :
         {Vec2(0.3, 0.4), Vec2(0.42, 0.3), Vec2(0.5, 0.45), Vec2(0.4, 0.6), Vec2(0.3, 0.55)})
        tour.hand().click(tour.at(place.x, place.y));
    tour.hand().key(Qt::Key_Return);
    tour.hand().key(Qt::Key_Return);
    settle(tour.window());
    for (const Vec2& place : {Vec2(0.45, 0.5), Vec2(0.6, 0.45), Vec2(0.68, 0.6)})
        tour.hand().click(tour.at(place.x, place.y));
    tour.hand().hover(tour.at(0.55, 0.7));
}

void frozen(Tour& tour)
{
    tour.show("knot");
    tour.act("view.freezeCulling");
    Camera camera = tour.viewport().frame().camera;
    camera.orbit(1.9, 0.2);
    tour.viewport().setCamera(camera);
}

void speed(Tour& tour)
{
    tour.show("nine-16");
    tour.act("view.speed");
    auto* dialog = tour.find<SpeedDialog>("speed-dialog");
    tour.wait([dialog] { return dialog->hasFindings() && !dialog->isMeasuring(); });
}

void exporting(Tour& tour)
{
    tour.show("hull");
    tour.act("file.export");
}

void palette(Tour& tour)
{
    tour.show("hull");
    tour.act("help.palette");
    auto* line = tour.find<QWidget>("command-palette")->findChild<QLineEdit*>();
    line->setText("view");
}

void keys(Tour& tour)
{
    tour.act("help.keys");
}

}  // namespace

const std::vector<TourStation>& tourStations()
{
    static const std::vector<TourStation> kStations = {
        {"start", start},         {"overview", overview}, {"pull", pull},           {"brush", brush},
        {"refine", refine},       {"trim", trim},         {"views", views},         {"zebra", zebra},
        {"curvature", curvature}, {"combs", combs},       {"deviation", deviation}, {"friends", friends},
        {"frozen", frozen},       {"speed", speed},       {"export", exporting},    {"palette", palette},
        {"keys", keys},
    };
    return kStations;
}

}  // namespace knotspan::testing
