// What a tool is: it hears of the pointer and answers what the viewport is to do next. The viewport owns the
// history, so a tool can neither forget to finish a step nor leave half of one.
#pragma once

#include <functional>

#include <Qt>

#include "model/document/document.h"
#include "model/friends/friends.h"
#include "model/sculpting/point_drag.h"
#include "ui/tools/selection.h"

namespace knotspan {

enum class ToolAnswer {
    pass,    // not mine: the viewport may turn the view with it
    keep,    // mine, go on telling me
    commit,  // the gesture is done: what was applied becomes one step
    revert,  // the gesture is off: what was applied is taken back
};

struct ToolPointer {
    Vec2 position;  // pixels of the picture, from its upper left corner
    Qt::KeyboardModifiers modifiers;
};

// What the user has told the tools; kept beyond the session by the window.
struct ToolSettings {
    bool keepFriends = false;  // drags take the control points of friends along, so that edges stay smooth
    FriendTolerances friends;  // who is a friend; the window's Friends, where it has them, know better
    DragSettings drag;         // which way control points go, and who follows; `others` is the tool's to tell

    [[nodiscard]] bool operator==(const ToolSettings&) const = default;
};

struct ToolContext {
    Document& document;
    Selection& selection;
    const Camera& camera;
    int width = 0;  // of the picture, in pixels
    int height = 0;
    double pixelRatio = 1;  // pixels of the picture in one of the hand's
    int gesture = 0;        // for Document::apply()
    std::function<Pick(const Vec2&)> pick;
    ToolSettings settings = {};
    // Says something beside the picture while the hand is busy; empty: nothing more.
    std::function<void(const QString&)> hint = [](const QString&) {};
    // Says why nothing came of a gesture. Only as it ends: the picture may give way to the sentence.
    std::function<void(const QString&)> trouble = [](const QString&) {};
};

class Tool {
public:
    Tool() = default;
    virtual ~Tool() = default;
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;

    // The pointer moves with no button down.
    virtual void hover(const ToolContext& context, const ToolPointer& pointer) = 0;
    // The left button goes down. Only after `keep` do the moves and the release come here.
    virtual ToolAnswer press(const ToolContext& context, const ToolPointer& pointer) = 0;
    virtual ToolAnswer move(const ToolContext& context, const ToolPointer& pointer) = 0;
    virtual ToolAnswer release(const ToolContext& context, const ToolPointer& pointer) = 0;
    // Press and release at one place, after press() answered `pass`.
    virtual void click(const ToolContext& context, const ToolPointer& pointer) = 0;
    // The gesture is off; the viewport takes back what was applied.
    virtual void cancel() = 0;
};

}  // namespace knotspan
