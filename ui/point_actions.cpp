// The menu Points: which control points are selected, and moving them by keys.
#include "ui/action_rows.h"

#include <QStatusBar>

#include "ui/points_dialog.h"
#include "ui/tools/point_dragging.h"

namespace knotspan {

namespace {

constexpr double kNudgePx = 10;

bool hasPoints(Window& window)
{
    return !window.selection().points().isEmpty();
}

// Of each selected point, what `more` gives for it.
template <class More>
void widen(Window& window, const More& more)
{
    const PointSelection& chosen = window.selection().points();
    PointSelection wider = chosen;
    for (const auto& [id, points] : chosen.objects())
        for (const ControlPointIndex index : points.points)
            wider.add(more(window.document().scene(), id, index));
    window.selection().setPoints(std::move(wider));
}

void selectRows(Window& window)
{
    widen(window,
          [](const Scene& scene, ObjectId id, ControlPointIndex at) { return rowOf(scene, id, at.i); });
}

void selectColumns(Window& window)
{
    widen(window,
          [](const Scene& scene, ObjectId id, ControlPointIndex at) { return columnOf(scene, id, at.j); });
}

void selectNets(Window& window)
{
    PointSelection all;
    for (const ObjectId id : window.selection().objects())
        all.add(netOf(window.document().scene(), id));
    window.selection().setPoints(std::move(all));
}

void invert(Window& window)
{
    window.selection().setPoints(
        inverted(window.selection().points(), window.document().scene(), window.selection().objects()));
}

ToolSettings settingsOf(Window& window)
{
    ToolSettings settings = window.viewport().toolSettings();
    settings.friends = window.friends().friends().tolerances();
    return settings;
}

// By some of the hand's pixels at the depth of the selected points.
void nudge(Window& window, double right, double up)
{
    window.document().endPreview();
    const Scene& scene = window.document().scene();
    const PointSelection& chosen = window.selection().points();
    if (chosen.isEmpty())
        return;  // they were a preview's
    const auto& [id, points] = *chosen.objects().begin();
    const Camera& camera = window.viewport().frame().camera;
    const double step =
        kNudgePx * camera.unitsPerPixel(controlPointInModel(*scene.find(id), points.points.front()),
                                        window.viewport().pictureSize().height);
    const auto moved = movedPoints(scene, chosen, settingsOf(window),
                                   (camera.right() * right + camera.upward() * up) * step);
    if (moved)
        window.document().apply(moved->edit, MainWindow::tr("Nudge control points"));
    else
        window.statusBar()->showMessage(QString::fromStdString(moved.error().sentence()));
}

void byNumbers(Window& window)
{
    broughtUp<PointsDialog>(window, [&] {
        return new PointsDialog(
            window.document(), window.selection(), [&window] { return settingsOf(window); }, &window);
    });
}

// In tenths of a nudge.
template <int right, int up>
ActionInfo nudgeRow(const char* id, const char* text, const char* keys)
{
    return {.id = id,
            .text = text,
            .shortcuts = {QKeySequence(keys)},
            .tip = TEXT("Move the selected control points by ten pixels, or with Shift by one"),
            .run = [](Window& w, bool) { nudge(w, right / 10.0, up / 10.0); },
            .isEnabled = hasPoints};
}

}  // namespace

const std::vector<ActionInfo>& pointActions()
{
    static const std::vector<ActionInfo> kList = {
        {.id = "points.row",
         .text = TEXT("Whole &rows"),
         .shortcuts = {QKeySequence("Ctrl+U")},
         .tip = TEXT("Select all control points that share their place along U with a selected one"),
         .run = [](Window& w, bool) { selectRows(w); },
         .isEnabled = hasPoints},
        {.id = "points.column",
         .text = TEXT("Whole &columns"),
         .shortcuts = {QKeySequence("Ctrl+Shift+U")},
         .tip = TEXT("Select all control points that share their place along V with a selected one"),
         .run = [](Window& w, bool) { selectColumns(w); },
         .isEnabled = hasPoints},
        {.id = "points.net",
         .text = TEXT("Whole &net"),
         .shortcuts = {QKeySequence("Ctrl+Shift+A")},
         .tip = TEXT("Select all control points of the selected objects"),
         .run = [](Window& w, bool) { selectNets(w); },
         .isEnabled = hasSelection},
        {.id = "points.grow",
         .text = TEXT("&Grow"),
         .shortcuts = {QKeySequence("Ctrl+.")},
         .tip = TEXT("Select the neighbours of the selected control points, too"),
         .run = [](Window& w, bool) { w.selection().setPoints(grown(w.selection().points())); },
         .isEnabled = hasPoints,
         .separated = true},
        {.id = "points.shrink",
         .text = TEXT("&Shrink"),
         .shortcuts = {QKeySequence("Ctrl+,")},
         .tip = TEXT("Let go of selected control points that have a neighbour which is not selected"),
         .run = [](Window& w, bool) { w.selection().setPoints(shrunk(w.selection().points())); },
         .isEnabled = hasPoints},
        {.id = "points.invert",
         .text = TEXT("&Invert"),
         .shortcuts = {QKeySequence("Ctrl+I")},
         .tip = TEXT("Select the other control points of the selected objects"),
         .run = [](Window& w, bool) { invert(w); },
         .isEnabled = hasSelection},
        {.id = "points.numbers",
         .text = TEXT("By n&umbers…"),
         .shortcuts = {QKeySequence("Ctrl+Shift+P")},
         .tip = TEXT("Move the selected control points by or to coordinates, or set their weight"),
         .run = [](Window& w, bool) { byNumbers(w); },
         .separated = true},
        nudgeRow<-10, 0>("points.left", TEXT("Nudge left"), "Alt+Left"),
        nudgeRow<10, 0>("points.right", TEXT("Nudge right"), "Alt+Right"),
        nudgeRow<0, 10>("points.up", TEXT("Nudge up"), "Alt+Up"),
        nudgeRow<0, -10>("points.down", TEXT("Nudge down"), "Alt+Down"),
        nudgeRow<-1, 0>("points.leftFine", TEXT("Nudge left a little"), "Alt+Shift+Left"),
        nudgeRow<1, 0>("points.rightFine", TEXT("Nudge right a little"), "Alt+Shift+Right"),
        nudgeRow<0, 1>("points.upFine", TEXT("Nudge up a little"), "Alt+Shift+Up"),
        nudgeRow<0, -1>("points.downFine", TEXT("Nudge down a little"), "Alt+Shift+Down"),
    };
    return kList;
}

}  // namespace knotspan
