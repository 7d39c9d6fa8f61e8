// The menu Object: what the selected objects are told.
#include <algorithm>

#include <QStatusBar>

#include "ui/action_rows.h"
#include "ui/curves_dialog.h"
#include "ui/mirror_dialog.h"
#include "ui/scene_additions.h"
#include "ui/shape_dialog.h"
#include "ui/transform_dialog.h"

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

// Of the model itself: what is only previewed goes, and is let go of.
std::set<ObjectId> chosenObjects(Window& window)
{
    window.document().endPreview();
    return window.selection().objects();
}
std::set<ObjectId> chosenOfAll(Window& window)
{
    std::set<ObjectId> chosen = chosenObjects(window);
    chosen.insert(window.selection().meshes().begin(), window.selection().meshes().end());
    return chosen;
}

// Each for which `wanted` says something else than what it is.
template <class Objects, class Object, class Wanted, class Put>
void tellEachOf(const Objects& objects, bool Object::*what, const Wanted& wanted, const Put& put)
{
    for (const auto& [id, object] : objects) {
        const bool value = wanted(id, (*object).*what);
        if ((*object).*what == value)
            continue;
        auto changed = std::make_shared<Object>(*object);
        (*changed).*what = value;
        put(id, std::move(changed));
    }
}

// Objects and meshes alike.
template <class Wanted>
void showEach(Window& window, const Wanted& wanted, const QString& step)
{
    Edit edit;
    const Scene& scene = window.document().scene();
    tellEachOf(scene.objects(), &SceneObject::visible, wanted,
               [&](ObjectId id, SharedObject changed) { edit.set(id, std::move(changed)); });
    tellEachOf(scene.meshes(), &MeshObject::visible, wanted,
               [&](ObjectId id, SharedMesh changed) { edit.setMesh(id, std::move(changed)); });
    window.document().apply(edit, step);
}

template <class Wanted>
void lockEach(Window& window, const Wanted& wanted, const QString& step)
{
    Edit edit;
    tellEachOf(window.document().scene().objects(), &SceneObject::locked, wanted,
               [&](ObjectId id, SharedObject changed) { edit.set(id, std::move(changed)); });
    window.document().apply(edit, step);
}

void hideSelected(Window& window)
{
    const std::set<ObjectId> chosen = chosenOfAll(window);
    showEach(
        window, [&](ObjectId id, bool visible) { return visible && chosen.count(id) == 0; },
        MainWindow::tr("Hide"));
    window.selection().clear();
}

void isolateSelected(Window& window)
{
    const std::set<ObjectId> chosen = chosenOfAll(window);
    if (chosen.empty())
        return;  // all would go
    showEach(
        window, [&](ObjectId id, bool) { return chosen.count(id) != 0; }, MainWindow::tr("Isolate"));
}

void showAll(Window& window)
{
    window.document().endPreview();
    showEach(
        window, [](ObjectId, bool) { return true; }, MainWindow::tr("Show all"));
}

void lockSelected(Window& window)
{
    const std::set<ObjectId> chosen = chosenObjects(window);
    lockEach(
        window, [&](ObjectId id, bool locked) { return locked || chosen.count(id) != 0; },
        MainWindow::tr("Lock"));
}

void unlockAll(Window& window)
{
    window.document().endPreview();
    lockEach(
        window, [](ObjectId, bool) { return false; }, MainWindow::tr("Unlock all"));
}

bool anyHidden(Window& window)
{
    const Scene::Meshes& meshes = window.document().scene().meshes();
    return window.document().objectCounts().hidden() > 0 ||
           std::any_of(meshes.begin(), meshes.end(),
                       [](const auto& entry) { return !entry.second->visible; });
}

bool anyLocked(Window& window)
{
    return window.document().objectCounts().locked() > 0;
}

// In place, as in Rhino: the copies are selected, to be moved away.
void duplicateSelected(Window& window)
{
    window.document().endPreview();
    const Scene& scene = window.document().scene();
    SceneAdditions copies(scene);
    for (const ObjectId id : window.selection().objects())
        if (const SharedObject object = scene.find(id))
            copies.addCopy(*object);
    const int count = static_cast<int>(copies.ids().size());
    if (count == 0)
        return;
    window.document().apply(copies.edit(), count == 1 ? MainWindow::tr("Duplicate an object")
                                                      : MainWindow::tr("Duplicate %1 objects").arg(count));
    window.selection().setObjects(copies.ids());
    window.statusBar()->showMessage(
        count == 1 ? MainWindow::tr("The copy lies in the same place and is selected: move it away")
                   : MainWindow::tr("The %1 copies lie in the same place and are selected: move them away")
                         .arg(count));
}

template <class Dialog>
void bringUp(Window& window)
{
    broughtUp<Dialog>(window, [&] { return new Dialog(window.document(), window.selection(), &window); });
}

}  // namespace

const std::vector<ActionInfo>& objectActions()
{
    static const std::vector<ActionInfo> kList = {
        {.id = "object.add",
         .text = TEXT("A&dd…"),
         .shortcuts = {QKeySequence("Shift+A")},
         .tip = TEXT("Add a plane, cylinder, cone, sphere or torus from numbers, and see it first"),
         .run = [](Window& w, bool) { bringUp<ShapeDialog>(w); }},
        {.id = "object.curves",
         .text = TEXT("Surface from &curves…"),
         .shortcuts = {QKeySequence("Shift+S")},
         .tip = TEXT("Extrude, revolve or loft curves of the selected surfaces, and see it first"),
         .run = [](Window& w, bool) { bringUp<CurvesDialog>(w); }},
        {.id = "object.duplicate",
         .text = TEXT("D&uplicate"),
         .shortcuts = {QKeySequence("Ctrl+D")},
         .tip = TEXT("Copy the selected objects in place and select the copies"),
         .run = [](Window& w, bool) { duplicateSelected(w); },
         .isEnabled = hasSelection,
         .separated = true},
        {.id = "object.mirror",
         .text = TEXT("&Mirror…"),
         .shortcuts = {QKeySequence("Ctrl+Shift+M")},
         .tip = TEXT("Mirror the selected objects, or copies of them, in a plane, and see it first"),
         .run = [](Window& w, bool) { bringUp<MirrorDialog>(w); }},
        {.id = "object.transform",
         .text = TEXT("Mo&ve, turn, scale…"),
         .shortcuts = {QKeySequence("Ctrl+T")},
         .tip = TEXT("Move, turn and scale the selected objects by numbers, and see it first"),
         .run = [](Window& w, bool) { bringUp<TransformDialog>(w); }},
        {.id = "object.hide",
         .text = TEXT("&Hide"),
         .shortcuts = {QKeySequence("Shift+H")},
         .tip = TEXT("Hide the selected objects"),
         .run = [](Window& w, bool) { hideSelected(w); },
         .isEnabled = hasAnySelection,
         .separated = true},
        {.id = "object.isolate",
         .text = TEXT("&Isolate"),
         .shortcuts = {QKeySequence("Shift+I")},
         .tip = TEXT("Show the selected objects and hide all others"),
         .run = [](Window& w, bool) { isolateSelected(w); },
         .isEnabled = hasAnySelection},
        {.id = "object.showAll",
         .text = TEXT("Sho&w all"),
         .shortcuts = {QKeySequence("Ctrl+Shift+H")},
         .tip = TEXT("Show every object again"),
         .run = [](Window& w, bool) { showAll(w); },
         .isEnabled = anyHidden},
        {.id = "object.lock",
         .text = TEXT("&Lock"),
         .shortcuts = {QKeySequence("Ctrl+L")},
         .tip = TEXT("Keep the selected objects as they are: they show, but no tool takes them"),
         .run = [](Window& w, bool) { lockSelected(w); },
         .isEnabled = hasSelection},
        {.id = "object.unlockAll",
         .text = TEXT("U&nlock all"),
         .shortcuts = {QKeySequence("Ctrl+Shift+L")},
         .tip = TEXT("Let tools take every object again"),
         .run = [](Window& w, bool) { unlockAll(w); },
         .isEnabled = anyLocked},
        {.id = "object.sidesAutomatic",
         .text = TEXT("&Automatic sides"),
         .shortcuts = {},
         .tip = TEXT("Draw only the outside of closed bodies, which is faster, and both sides of all else"),
         .run = [](Window& w, bool) { tell(w, Sides::automatic, MainWindow::tr("Automatic sides")); },
         .isEnabled = hasSelection,
         .isChecked = [](Window& w) { return allHave(w, Sides::automatic); },
         .separated = true},
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
