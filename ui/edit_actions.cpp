// The menu Edit.
#include <algorithm>

#include <QStatusBar>

#include "model/trimming/loop_combining.h"
#include "ui/action_rows.h"
#include "ui/border_trim.h"
#include "ui/match_dialog.h"
#include "ui/panels/friends_panel.h"
#include "ui/refine_dialog.h"
#include "ui/tool_settings_store.h"

namespace knotspan {

namespace {

void takeBack(Window& window)
{
    if (!window.viewport().cancelDrag())
        window.document().undo();
    window.statusBar()->clearMessage();  // it may have told of that step
}

void doAgain(Window& window)
{
    window.document().redo();
    window.statusBar()->clearMessage();
}

void escape(Window& window)
{
    if (window.viewport().cancelDrag())
        return;
    window.selection().clear();
    window.shownFriends().choose({});
}

void selectAll(Window& window)
{
    std::set<ObjectId> shown;
    for (const auto& [id, object] : window.document().scene().objects())
        if (object->visible && !object->locked)
            shown.insert(id);
    window.selection().setObjects(std::move(shown));
}

void deleteSelected(Window& window)
{
    window.document().endPreview();
    const std::set<ObjectId>& objects = window.selection().objects();
    const std::set<ObjectId>& meshes = window.selection().meshes();
    Edit edit;
    for (const ObjectId id : objects)
        edit.set(id, nullptr);
    for (const ObjectId id : meshes)
        edit.setMesh(id, nullptr);
    if (edit.isEmpty())
        return;  // it was a preview's
    const int count = static_cast<int>(objects.size() + meshes.size());
    window.document().apply(edit, count == 1 ? MainWindow::tr("Delete an object")
                                             : MainWindow::tr("Delete %1 objects").arg(count));
}

void keepFriends(Window& window, bool keep)
{
    ToolSettings settings = window.viewport().toolSettings();
    settings.keepFriends = keep;
    window.viewport().setToolSettings(settings);
    storeToolSettings(settings);
    window.statusBar()->showMessage(
        keep ? MainWindow::tr(
                   "Keep friends is on: where surfaces meet smoothly, both sides of the edge follow "
                   "a dragged control point")
             : MainWindow::tr("Keep friends is off: a dragged control point moves alone"));
}

// Of the friends; nothing where none or a naked edge is chosen.
std::optional<ObjectEdge> chosenEdge(Window& window)
{
    const std::optional<size_t> number = window.shownFriends().chosen();
    if (!number)
        return std::nullopt;
    const SceneFriends& friends = window.friends().friends();
    if (*number >= friends.edges().size())
        return std::nullopt;
    const FriendEdge& edge = friends.edges()[*number];
    return ObjectEdge{edge, friends.objects()[edge.a.surface], friends.objects()[edge.b.surface]};
}

// The other way round: the dialog's edge is the chosen one, so that the viewport marks it.
void chooseEdgeOf(Window& window, const MatchDialog& dialog)
{
    const auto* panel = window.findChild<FriendsPanel*>();
    if (!dialog.edge()) {
        if (!panel->isVisible())  // else it stays chosen there
            window.shownFriends().choose({});
        return;
    }
    window.shownFriends().choose(numberAmong(window.friends().friends(), *dialog.edge()));
}

MatchDialog* makeMatchDialog(Window& window)
{
    auto* dialog = new MatchDialog(window.document(), window.selection(), &window);
    QObject::connect(&window.shownFriends(), &ShownFriends::changed, dialog, [&window, dialog] {
        if (dialog->isVisible())
            dialog->setEdge(chosenEdge(window));
    });
    QObject::connect(dialog, &MatchDialog::edgeChanged, dialog,
                     [&window, dialog] { chooseEdgeOf(window, *dialog); });
    return dialog;
}

void matchEdge(Window& window)
{
    auto& dialog = broughtUp<MatchDialog>(window, [&] { return makeMatchDialog(window); });
    dialog.setEdge(chosenEdge(window));
    if (!dialog.edge())
        dialog.offerEdges();
}

void refineSurface(Window& window)
{
    broughtUp<RefineDialog>(window,
                            [&] { return new RefineDialog(window.document(), window.selection(), &window); });
}

// Other loops for the selected surfaces, as one step.
template <class Loops>
void changeLoops(Window& window, const QString& step, const QString& whyNot, const Loops& loopsOf)
{
    window.document().endPreview();
    Edit edit;
    for (const ObjectId id : window.selection().objects()) {
        const SharedObject object = window.document().scene().find(id);
        if (!object || object->locked || object->trimLoops.empty())
            continue;
        SceneObject changed = *object;
        changed.trimLoops = loopsOf(*object);
        if (changed.trimLoops != object->trimLoops)
            edit.set(id, std::make_shared<SceneObject>(std::move(changed)));
    }
    if (edit.isEmpty())
        window.statusBar()->showMessage(whyNot);
    else
        window.document().apply(edit, step);
}

void untrim(Window& window)
{
    changeLoops(window, MainWindow::tr("Untrim"),
                MainWindow::tr("Nothing that is selected is trimmed: select surfaces that are"),
                [](const SceneObject&) { return std::vector<TrimLoop>(); });
}

void fillHoles(Window& window)
{
    changeLoops(window, MainWindow::tr("Fill holes"),
                MainWindow::tr("Nothing that is selected has holes: select trimmed surfaces"),
                [](const SceneObject& object) { return withoutHoles(object.trimLoops, object.surface); });
}

}  // namespace

const std::vector<ActionInfo>& editActions()
{
    static const std::vector<ActionInfo> kList = {
        {.id = "edit.undo",
         .text = TEXT("&Undo"),
         .shortcuts = {QKeySequence::Undo},
         .tip = TEXT("Take the last step back"),
         .run = [](Window& w, bool) { takeBack(w); },
         .isEnabled = [](Window& w) { return w.document().canUndo(); },
         .step = [](Window& w) { return w.document().undoText(); },
         .whileDragging = true},
        {.id = "edit.redo",
         .text = TEXT("&Redo"),
         .shortcuts = {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")},
         .tip = TEXT("Do the step again that was taken back"),
         .run = [](Window& w, bool) { doAgain(w); },
         .isEnabled = [](Window& w) { return w.document().canRedo(); },
         .step = [](Window& w) { return w.document().redoText(); }},
        {.id = "edit.selectAll",
         .text = TEXT("Select a&ll"),
         .shortcuts = {QKeySequence::SelectAll},
         .tip = TEXT("Select every object that is visible and not locked"),
         .run = [](Window& w, bool) { selectAll(w); },
         .separated = true},
        {.id = "edit.deselect",
         .text = TEXT("&Deselect"),
         .shortcuts = {QKeySequence(Qt::Key_Escape)},
         .tip = TEXT("Take a running drag back; without one, select nothing and let go of the chosen edge"),
         .run = [](Window& w, bool) { escape(w); },
         .whileDragging = true},
        {.id = "edit.delete",
         .text = TEXT("D&elete"),
         .shortcuts = {QKeySequence(Qt::Key_Delete)},
         .tip = TEXT("Remove the selected objects and meshes"),
         .run = [](Window& w, bool) { deleteSelected(w); },
         .isEnabled = hasAnySelection},
        {.id = "edit.keepFriends",
         .text = TEXT("&Keep friends"),
         .shortcuts = {QKeySequence("Shift+K")},
         .tip = TEXT(
             "Where surfaces meet smoothly, let both sides of the edge follow a dragged control point, so "
             "that it stays smooth"),
         .run = [](Window& w, bool checked) { keepFriends(w, checked); },
         .isChecked = [](Window& w) { return w.viewport().toolSettings().keepFriends; },
         .separated = true},
        {.id = "edit.matchEdge",
         .text = TEXT("&Match edge…"),
         .shortcuts = {QKeySequence("M")},
         .tip = TEXT("Make surfaces meet smoothly along an edge, and see first how far they move for it"),
         .run = [](Window& w, bool) { matchEdge(w); }},
        {.id = "edit.refine",
         .text = TEXT("&Refine surface…"),
         .shortcuts = {QKeySequence("R")},
         .tip =
             TEXT("Knots, degrees, a rebuilt net or a cut for the selected surface, and see first how far it "
                  "moves for it"),
         .run = [](Window& w, bool) { refineSurface(w); }},
        {.id = "edit.untrim",
         .text = TEXT("U&ntrim"),
         .shortcuts = {QKeySequence("Shift+U")},
         .tip = TEXT("Show the selected surfaces whole: all of their trim loops go"),
         .run = [](Window& w, bool) { untrim(w); },
         .separated = true},
        {.id = "edit.fillHoles",
         .text = TEXT("F&ill holes"),
         .shortcuts = {},
         .tip = TEXT("Take the holes out of the selected trimmed surfaces; their outlines stay"),
         .run = [](Window& w, bool) { fillHoles(w); }},
        {.id = "edit.trimBySelected",
         .text = TEXT("&Trim by selected"),
         .shortcuts = {QKeySequence("Ctrl+Shift+T")},
         .tip = TEXT(
             "Cut holes into the surface selected last, where the borders of the other selected ones lie "
             "over it in the view"),
         .run = [](Window& w, bool) { trimBySelected(w, KeptSide::outside); }},
        {.id = "edit.keepInsideSelected",
         .text = TEXT("Keep in&side selected"),
         .shortcuts = {},
         .tip = TEXT(
             "Trim the surface selected last to what lies inside the border of any of the other selected "
             "ones, as seen in the view"),
         .run = [](Window& w, bool) { trimBySelected(w, KeptSide::inside); }},
    };
    return kList;
}

}  // namespace knotspan
