// What a click, a box or a lasso makes of the selection: alone, with Shift added, with Ctrl taken in or out.
#pragma once

#include "ui/tools/tool.h"

namespace knotspan {

enum class Choosing { alone, adding, toggling };
[[nodiscard]] Choosing choosingBy(Qt::KeyboardModifiers keys);

// The objects of points that are chosen alone are chosen alone, too.
void choosePoints(Selection& selection, const PointSelection& points, Choosing how);
// Alone lets go of all control points, the others only of those whose objects go.
void chooseObjects(Selection& selection, const std::set<ObjectId>& objects, Choosing how);

// What is under a pixel, where the filter lets it: a control point before a surface, otherwise nothing, which
// alone lets go of everything.
void chooseAt(const ToolContext& context, const ToolPointer& pointer);
// Lights up what that would take.
void hoverAt(const ToolContext& context, const ToolPointer& pointer);

// A control point of the pick, where the filter lets it be taken.
[[nodiscard]] std::optional<ScenePoint> takenPoint(const ToolContext& context, const Pick& pick);

}  // namespace knotspan
