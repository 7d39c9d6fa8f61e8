// What a tool is: it hears of the pointer and the keys, answers what the viewport is to do next, and says
// what the picture shows of it. The viewport owns the history, so a tool can neither forget to finish a step
// nor leave half of one.
#pragma once

#include <functional>

#include <QKeyEvent>

#include "model/document/document.h"
#include "model/friends/friends.h"
#include "model/sculpting/point_drag.h"
#include "ui/tools/probes.h"
#include "ui/tools/selection.h"

namespace knotspan {

enum class ToolAnswer {
    pass,    // not mine: the viewport may turn the view with it
    keep,    // mine, go on telling me
    stay,    // the same, and the button may go up: moves, presses and keys are mine until I say otherwise
    commit,  // the gesture is done: what was applied becomes one step
    revert,  // the gesture is off: what was applied is taken back
};

struct ToolPointer {
    Vec2 position;  // pixels of the picture, from its upper left corner
    Qt::KeyboardModifiers modifiers;
};

// What clicks, boxes and lassos take.
struct SelectionFilter {
    bool points = true;
    bool objects = true;

    [[nodiscard]] bool operator==(const SelectionFilter&) const = default;
};

// What a dragged control point may jump to, where it comes near.
struct SnapSettings {
    bool grid = false;
    bool points = false;     // other control points, of visible objects
    bool knotLines = false;  // of visible objects that do not move
    bool surfaces = false;   // likewise
    double gridStep = 1;     // model units, above 0
    double reachPx = 12;     // of the hand's; the grid takes from everywhere

    [[nodiscard]] bool operator==(const SnapSettings&) const = default;
};

constexpr double kLeastBrushPx = 4;
constexpr double kMostBrushPx = 400;
struct BrushSettings {
    double radiusPx = 60;   // of the hand's, at the depth of the place that it touches
    double strength = 0.5;  // 0 to 1
    FalloffShape shape = FalloffShape::smooth;

    [[nodiscard]] bool operator==(const BrushSettings&) const = default;
};

// Which handles the gizmo has.
enum class GizmoFrame {
    none,
    model,    // X, Y and Z of the model
    surface,  // U, V and the normal at the selected control points; of objects as `model`
};

// What the user has told the tools; kept beyond the session by the window.
struct ToolSettings {
    bool keepFriends = false;  // drags take the control points of friends along, so that edges stay smooth
    FriendTolerances friends;  // who is a friend; the window's Friends, where it has them, know better
    DragSettings drag;         // which way control points go, and who follows; `others` is the tool's to tell
    SnapSettings snap;
    BrushSettings brush;
    SelectionFilter filter;
    GizmoFrame gizmo = GizmoFrame::model;
    bool loosen = true;  // the picture's tolerance, while the hand moves something and frames are slow

    [[nodiscard]] bool operator==(const ToolSettings&) const = default;
};

struct ToolContext {
    Document& document;
    Selection& selection;
    Probes& probes;
    const Camera& camera;
    int width = 0;  // of the picture, in pixels
    int height = 0;
    double pixelRatio = 1;  // pixels of the picture in one of the hand's
    int gesture = 0;        // for Document::apply()
    // What lies under a pixel. Locked objects are not there.
    std::function<Pick(const Vec2&)> pick;
    ToolSettings settings = {};
    // Says something beside the picture while the hand is busy; empty: nothing more.
    std::function<void(const QString&)> hint = [](const QString&) {};
    // Says why nothing came of a gesture. Only as it ends: the picture may give way to the sentence.
    std::function<void(const QString&)> trouble = [](const QString&) {};
    // The picture shows something else of the tool than before: draw it again.
    std::function<void()> redraw = [] {};
    bool allNetsShow = false;  // the control points of every object, not only of the selected ones
};

class Tool {
public:
    Tool() = default;
    virtual ~Tool() = default;
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;

    // The pointer moves with no button down.
    virtual void hover(const ToolContext& context, const ToolPointer& pointer) = 0;
    // The left button goes down. Only after `keep` do the moves and the release come here. A release that
    // answers `stay` lets the gesture go on over more presses, and the view stands still meanwhile.
    virtual ToolAnswer press(const ToolContext& context, const ToolPointer& pointer) = 0;
    virtual ToolAnswer move(const ToolContext& context, const ToolPointer& pointer) = 0;
    virtual ToolAnswer release(const ToolContext& context, const ToolPointer& pointer) = 0;
    // Press and release at one place, after press() answered `pass`.
    virtual void click(const ToolContext& context, const ToolPointer& pointer) = 0;
    // The gesture is off; the viewport takes back what was applied.
    virtual void cancel() = 0;
    // A key while a gesture runs: `keep` where it was used and the gesture goes on, `pass` where it means
    // nothing here.
    virtual ToolAnswer key(const ToolContext&, const QKeyEvent&) { return ToolAnswer::pass; }
    // The pointer is no longer over the picture, or another tool takes over.
    virtual void leave(const ToolContext&) {}
    // Adds what the picture is to show of it. Asked for each picture: what it needs is found before.
    virtual void show(const ToolContext&, Overlays&) const {}
    [[nodiscard]] virtual Qt::CursorShape cursor() const { return Qt::ArrowCursor; }
};

}  // namespace knotspan
