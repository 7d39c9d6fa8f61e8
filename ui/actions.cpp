#include "ui/actions.h"

#include "ui/main_window.h"

namespace knotspan {

namespace {

// Marks the table's texts for translation.
#define TEXT(text) QT_TRANSLATE_NOOP("knotspan::Actions", text)

using Keys = std::vector<QKeySequence>;
using Window = MainWindow;
constexpr auto kCheckable = ActionInfo::Kind::checkable;
constexpr auto kPlain = ActionInfo::Kind::plain;

const std::vector<ActionInfo>& fileActions()
{
    static const std::vector<ActionInfo> kList = {
        {"file.open",
         TEXT("&Open…"),
         {QKeySequence::Open},
         TEXT("Open a model in place of this one"),
         [](Window& w, bool) { w.askAndOpen(); }},
        {"file.add",
         TEXT("&Add…"),
         {QKeySequence("Ctrl+Shift+O")},
         TEXT("Add the objects of another file to this model"),
         [](Window& w, bool) { w.askAndAdd(); }},
        {"file.save",
         TEXT("&Save"),
         {QKeySequence::Save},
         TEXT("Write the model to its file"),
         [](Window& w, bool) { w.save(); },
         kPlain,
         true},
        {"file.saveAs",
         TEXT("Save &as…"),
         {QKeySequence("Ctrl+Shift+S")},
         TEXT("Write the model to another file"),
         [](Window& w, bool) { w.saveAs(); }},
        {"file.quit",
         TEXT("&Quit"),
         {QKeySequence("Ctrl+Q")},
         TEXT("Close the window"),
         [](Window& w, bool) { w.close(); },
         kPlain,
         true},
    };
    return kList;
}

const std::vector<ActionInfo>& editActions()
{
    static const std::vector<ActionInfo> kList = {
        {"edit.undo",
         TEXT("&Undo"),
         {QKeySequence::Undo},
         TEXT("Take the last step back"),
         [](Window& w, bool) { w.undo(); }},
        {"edit.redo", TEXT("&Redo"), Keys{QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")},
         TEXT("Do the step again that was taken back"), [](Window& w, bool) { w.redo(); }},
        {"edit.selectAll",
         TEXT("Select a&ll"),
         {QKeySequence::SelectAll},
         TEXT("Select every visible object"),
         [](Window& w, bool) { w.selectAll(); },
         kPlain,
         true},
        {"edit.deselect",
         TEXT("&Deselect"),
         {QKeySequence(Qt::Key_Escape)},
         TEXT("Take a running drag back; without one, select nothing"),
         [](Window& w, bool) { w.escape(); }},
        {"edit.delete",
         TEXT("D&elete"),
         {QKeySequence(Qt::Key_Delete)},
         TEXT("Remove the selected objects"),
         [](Window& w, bool) { w.deleteSelected(); }},
    };
    return kList;
}

const std::vector<ActionInfo>& viewActions()
{
    static const std::vector<ActionInfo> kList = {
        {"view.fit",
         TEXT("&Fit all"),
         {QKeySequence("F")},
         TEXT("Bring the whole model into view"),
         [](Window& w, bool) { w.viewport().fit(); }},
        {"view.fitSelection",
         TEXT("Fit &selection"),
         {QKeySequence("Shift+F")},
         TEXT("Bring the selected objects into view"),
         [](Window& w, bool) { w.viewport().fitSelection(); }},
        {"view.iso",
         TEXT("&Isometric"),
         {QKeySequence("0")},
         TEXT("Look from a corner, everything in view"),
         [](Window& w, bool) { w.viewport().look("iso"); },
         kPlain,
         true},
        {"view.front",
         TEXT("F&ront"),
         {QKeySequence("1")},
         TEXT("Look from the front"),
         [](Window& w, bool) { w.viewport().look("front"); }},
        {"view.back",
         TEXT("&Back"),
         {QKeySequence("Ctrl+1")},
         TEXT("Look from behind"),
         [](Window& w, bool) { w.viewport().look("back"); }},
        {"view.right",
         TEXT("Ri&ght"),
         {QKeySequence("3")},
         TEXT("Look from the right"),
         [](Window& w, bool) { w.viewport().look("right"); }},
        {"view.left",
         TEXT("&Left"),
         {QKeySequence("Ctrl+3")},
         TEXT("Look from the left"),
         [](Window& w, bool) { w.viewport().look("left"); }},
        {"view.top",
         TEXT("&Top"),
         {QKeySequence("7")},
         TEXT("Look from above"),
         [](Window& w, bool) { w.viewport().look("top"); }},
        {"view.bottom",
         TEXT("Botto&m"),
         {QKeySequence("Ctrl+7")},
         TEXT("Look from below"),
         [](Window& w, bool) { w.viewport().look("bottom"); }},
        {"view.orthographic",
         TEXT("&Orthographic"),
         {QKeySequence("5")},
         TEXT("Without perspective: parallel lines stay parallel"),
         [](Window& w, bool on) { w.setOrthographic(on); },
         kCheckable,
         true},
        {"view.nets",
         TEXT("Control &nets"),
         {QKeySequence("N")},
         TEXT("Show the control points of every object, not only of the selected ones"),
         [](Window& w, bool on) { w.setControlNets(on); },
         kCheckable,
         true},
        {"view.knots",
         TEXT("&Knot lines"),
         {QKeySequence("K")},
         TEXT("Show where the surfaces' spans meet"),
         [](Window& w, bool on) { w.setKnotLines(on); },
         kCheckable},
        {"view.moreCells",
         TEXT("&More cells"),
         {QKeySequence("+")},
         TEXT("With the path cpu: draw every surface as one cell more each way (sampling fixed:N)"),
         [](Window& w, bool) { w.changeUniformCells(1); },
         kPlain,
         true},
        {"view.fewerCells",
         TEXT("&Fewer cells"),
         {QKeySequence("-")},
         TEXT("With the path cpu: draw every surface as one cell less each way (sampling fixed:N)"),
         [](Window& w, bool) { w.changeUniformCells(-1); }},
        {"view.speed",
         TEXT("Speed and &accuracy…"),
         {QKeySequence("Ctrl+M")},
         TEXT("Measure what each path costs on this machine, and how far its picture is off"),
         [](Window& w, bool) { w.showSpeed(); },
         kPlain,
         true},
    };
    return kList;
}

const std::vector<ActionInfo>& helpActions()
{
    static const std::vector<ActionInfo> kList = {
        {"help.keys", TEXT("&Keys and mouse"), Keys{QKeySequence("H"), QKeySequence("F1")},
         TEXT("List every key and what the mouse does"), [](Window& w, bool) { w.showKeys(); }},
        {"help.about",
         TEXT("&About Knotspan"),
         {},
         TEXT("What this program is, and on which device it draws"),
         [](Window& w, bool) { w.showAbout(); }},
    };
    return kList;
}

}  // namespace

const std::vector<ActionInfo>& actionList()
{
    static const std::vector<ActionInfo> kList = [] {
        std::vector<ActionInfo> list;
        for (const auto* part : {&fileActions(), &editActions(), &viewActions(), &helpActions()})
            list.insert(list.end(), part->begin(), part->end());
        return list;
    }();
    return kList;
}

const std::vector<MouseInfo>& mouseList()
{
    static const std::vector<MouseInfo> kList = {
        {TEXT("Left click"), TEXT("Select the object under the cursor; on nothing: deselect")},
        {TEXT("Shift + click, Ctrl + click"), TEXT("Add to the selection; take in or out of it")},
        {TEXT("Left drag on a control point"), TEXT("Move it in the view plane; Escape takes it back")},
        {TEXT("Left drag elsewhere, middle drag, Alt + left drag"), TEXT("Orbit")},
        {TEXT("Right drag, Shift + middle drag"), TEXT("Pan")},
        {TEXT("Wheel, Ctrl + middle drag"), TEXT("Zoom at the cursor")},
        {TEXT("Drop files"), TEXT("Open the first, add the others")},
    };
    return kList;
}

#undef TEXT

}  // namespace knotspan
