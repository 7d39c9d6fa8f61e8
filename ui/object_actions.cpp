// The menu Object: what the selected objects are told.
#include <algorithm>

#include "ui/action_rows.h"

namespace knotspan {

namespace {

bool allHave(Window& window, Sides sides)
{
    const std::set<ObjectId>& chosen = window.selection().objects();
    const Scene& scene = window.document().scene();
    return !chosen.empty() && std::all_of(chosen.begin(), chosen.end(), [&](ObjectId id) {
        const SharedObject object = scene.find(id);
        return object && object->sides == sides;
    });
}

void tell(Window& window, Sides sides, const QString& step)
{
    window.document().endPreview();
    Edit edit;
    for (const ObjectId id : window.selection().objects()) {
        const SharedObject object = window.document().scene().find(id);
        if (!object || object->sides == sides)
            continue;
        auto changed = std::make_shared<SceneObject>(*object);
        changed->sides = sides;
        edit.set(id, std::move(changed));
    }
    if (!edit.isEmpty())
        window.document().apply(edit, step);
}

}  // namespace

const std::vector<ActionInfo>& objectActions()
{
    static const std::vector<ActionInfo> kList = {
        {.id = "object.sidesAutomatic",
         .text = TEXT("&Automatic sides"),
         .shortcuts = {},
         .tip = TEXT("Draw only the outside of closed bodies, which is faster, and both sides of all else"),
         .run = [](Window& w, bool) { tell(w, Sides::automatic, MainWindow::tr("Automatic sides")); },
         .isEnabled = hasSelection,
         .isChecked = [](Window& w) { return allHave(w, Sides::automatic); }},
        {.id = "object.sidesBoth",
         .text = TEXT("&Both sides"),
         .shortcuts = {},
         .tip = TEXT("Draw both sides of the selected objects, even where they are closed"),
         .run = [](Window& w, bool) { tell(w, Sides::both, MainWindow::tr("Both sides")); },
         .isEnabled = hasSelection,
         .isChecked = [](Window& w) { return allHave(w, Sides::both); }},
        {.id = "object.sidesFront",
         .text = TEXT("&Front side only"),
         .shortcuts = {},
         .tip = TEXT("Draw the selected objects only where their normal points towards the eye"),
         .run = [](Window& w, bool) { tell(w, Sides::front, MainWindow::tr("Front side only")); },
         .isEnabled = hasSelection,
         .isChecked = [](Window& w) { return allHave(w, Sides::front); }},
        {.id = "object.sidesBack",
         .text = TEXT("Bac&k side only"),
         .shortcuts = {},
         .tip = TEXT("Draw the selected objects only where their normal points away from the eye"),
         .run = [](Window& w, bool) { tell(w, Sides::back, MainWindow::tr("Back side only")); },
         .isEnabled = hasSelection,
         .isChecked = [](Window& w) { return allHave(w, Sides::back); }},
    };
    return kList;
}

}  // namespace knotspan
