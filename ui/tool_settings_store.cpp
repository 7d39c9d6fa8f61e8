#include "ui/tool_settings_store.h"

#include "ui/stored_values.h"

namespace knotspan {

ToolSettings storedToolSettings()
{
    const QSettings stored;
    ToolSettings tools;
    const auto flag = [&](const char* key, bool& value) { value = stored.value(key, value).toBool(); };
    flag("keepFriends", tools.keepFriends);
    flag("loosen", tools.loosen);
    flag("snap/points", tools.snap.points);
    flag("snap/knotLines", tools.snap.knotLines);
    flag("snap/surfaces", tools.snap.surfaces);
    flag("snap/grid", tools.snap.grid);
    tools.snap.gridStep = numberIn(stored, "snap/gridStep", tools.snap.gridStep, 1e-4, 1e9);
    BrushSettings& brush = tools.brush;
    brush.radiusPx = numberIn(stored, "brush/radius", brush.radiusPx, kLeastBrushPx, kMostBrushPx);
    brush.strength = numberIn(stored, "brush/strength", brush.strength, 0, 1);
    brush.shape = choiceIn(stored, "brush/shape", brush.shape, FalloffShape::constant);
    tools.gizmo = choiceIn(stored, "gizmo", tools.gizmo, GizmoFrame::surface);
    return tools;
}

void storeToolSettings(const ToolSettings& tools)
{
    QSettings stored;
    stored.setValue("keepFriends", tools.keepFriends);
    stored.setValue("loosen", tools.loosen);
    stored.setValue("snap/points", tools.snap.points);
    stored.setValue("snap/knotLines", tools.snap.knotLines);
    stored.setValue("snap/surfaces", tools.snap.surfaces);
    stored.setValue("snap/grid", tools.snap.grid);
    stored.setValue("snap/gridStep", tools.snap.gridStep);
    stored.setValue("brush/radius", tools.brush.radiusPx);
    stored.setValue("brush/strength", tools.brush.strength);
    stored.setValue("brush/shape", static_cast<int>(tools.brush.shape));
    stored.setValue("gizmo", static_cast<int>(tools.gizmo));
}

}  // namespace knotspan
