// The menu Tools: what the left mouse button does, what it takes, and how large its brushes are.
#include <algorithm>

#include "ui/action_rows.h"
#include "ui/tools/tool_list.h"

namespace knotspan {

namespace {

constexpr double kBrushStep = 1.2;

template <class Change>
void change(Window& window, const Change& set)
{
    ToolSettings settings = window.viewport().toolSettings();
    set(settings);
    window.viewport().setToolSettings(settings);
}

void resizeBrush(Window& window, double factor)
{
    change(window, [factor](ToolSettings& settings) {
        double& radius = settings.brush.radiusPx;
        radius = std::clamp(radius * factor, kLeastBrushPx, kMostBrushPx);
    });
}

// None, the model's axes, the surface's, none.
void nextGizmo(Window& window)
{
    change(window, [](ToolSettings& settings) {
        settings.gizmo = settings.gizmo == GizmoFrame::none    ? GizmoFrame::model
                         : settings.gizmo == GizmoFrame::model ? GizmoFrame::surface
                                                               : GizmoFrame::none;
    });
}

bool snaps(const SnapSettings& snap)
{
    return snap.grid || snap.points || snap.knotLines || snap.surfaces;
}

// Off all of it, or on again as it is wanted most often.
void toggleSnapping(Window& window)
{
    change(window, [](ToolSettings& settings) {
        SnapSettings& snap = settings.snap;
        const bool on = !snaps(snap);
        snap.points = on;
        snap.grid = snap.knotLines = snap.surfaces = false;
    });
}

template <size_t k>
ActionInfo toolRow(const char* id)
{
    const ToolInfo& tool = tools()[k];
    return {.id = id,
            .text = tool.text,
            .shortcuts = {QKeySequence(tool.key)},
            .tip = tool.tip,
            .run = [](Window& w, bool) { w.viewport().setTool(tools()[k].name); },
            .isChecked = [](Window& w) { return w.viewport().tool() == tools()[k].name; }};
}

}  // namespace

const std::vector<ActionInfo>& toolActions()
{
    static const std::vector<ActionInfo> kList = {
        toolRow<0>("tools.select"),
        toolRow<1>("tools.box"),
        toolRow<2>("tools.lasso"),
        toolRow<3>("tools.weight"),
        toolRow<4>("tools.knot"),
        toolRow<5>("tools.grab"),
        toolRow<6>("tools.smooth"),
        toolRow<7>("tools.inflate"),
        toolRow<8>("tools.flatten"),
        toolRow<9>("tools.probe"),
        toolRow<10>("tools.trim"),
        {.id = "tools.largerBrush",
         .text = TEXT("L&arger brush"),
         .shortcuts = {QKeySequence("]")},
         .tip = TEXT("Make the brushes' circle a fifth larger"),
         .run = [](Window& w, bool) { resizeBrush(w, kBrushStep); },
         .separated = true},
        {.id = "tools.smallerBrush",
         .text = TEXT("Smalle&r brush"),
         .shortcuts = {QKeySequence("[")},
         .tip = TEXT("Make the brushes' circle a fifth smaller"),
         .run = [](Window& w, bool) { resizeBrush(w, 1 / kBrushStep); }},
        {.id = "tools.gizmo",
         .text = TEXT("Ne&xt gizmo"),
         .shortcuts = {QKeySequence("Shift+G")},
         .tip = TEXT("Change the handles at what is selected: the model's axes, the surface's, none"),
         .run = [](Window& w, bool) { nextGizmo(w); },
         .separated = true},
        {.id = "tools.snap",
         .text = TEXT("Sna&p"),
         .shortcuts = {QKeySequence("Q")},
         .tip = TEXT("Let dragged control points jump to others nearby; the panel Tool settings has more"),
         .run = [](Window& w, bool) { toggleSnapping(w); },
         .isChecked = [](Window& w) { return snaps(w.viewport().toolSettings().snap); }},
        {.id = "tools.takePoints",
         .text = TEXT("Take &control points"),
         .shortcuts = {QKeySequence("8")},
         .tip = TEXT("Let clicks, boxes and lassos take control points"),
         .run = [](Window& w,
                   bool on) { change(w, [on](ToolSettings& settings) { settings.filter.points = on; }); },
         .isChecked = [](Window& w) { return w.viewport().toolSettings().filter.points; },
         .separated = true},
        {.id = "tools.takeObjects",
         .text = TEXT("Take &objects"),
         .shortcuts = {QKeySequence("9")},
         .tip = TEXT("Let clicks, boxes and lassos take objects"),
         .run = [](Window& w,
                   bool on) { change(w, [on](ToolSettings& settings) { settings.filter.objects = on; }); },
         .isChecked = [](Window& w) { return w.viewport().toolSettings().filter.objects; }},
    };
    return kList;
}

}  // namespace knotspan
