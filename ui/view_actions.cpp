// The menu View: what the viewport draws, and from where.
#include <algorithm>

#include <QSettings>

#include "ui/action_rows.h"
#include "ui/appearance.h"
#include "ui/speed_dialog.h"
#include "ui/tool_settings_store.h"
#include "ui/viewport/navigation_presets.h"

namespace knotspan {

namespace {

template <class Change>
void change(Window& window, const Change& set)
{
    Frame frame = window.viewport().frame();
    set(frame);
    window.viewport().setFrame(frame);
}

bool drawsOnCpu(Window& window)
{
    return window.viewport().frame().path == PathId::cpu;
}

void changeUniformCells(Window& window, int by)
{
    constexpr int kFirst = 8;  // where the rule was another
    constexpr int kMost = 64;
    change(window, [&](Frame& frame) {
        SamplingRule& rule = frame.sampling;
        const bool fixed = rule.kind == SamplingRule::Kind::fixed;
        rule = {SamplingRule::Kind::fixed, std::clamp(fixed ? rule.count + by : kFirst, 1, kMost)};
    });
}

void freezeCulling(Window& window, bool on)
{
    change(window, [on](Frame& frame) {
        frame.cullingCamera.reset();
        if (on)
            frame.cullingCamera = frame.camera;
    });
}

void showCombs(Window& window, bool on)
{
    CombSettings settings = window.viewport().combs().settings();
    settings.shown = on;
    window.viewport().combs().setSettings(settings);
}

void showSection(Window& window, bool on)
{
    SectionSettings settings = window.viewport().section().settings();
    settings.shown = on;
    window.viewport().section().setSettings(settings);
}

void showFriends(Window& window, bool on)
{
    window.shownFriends().showLines(on);
    QSettings().setValue("friendEdges", on);
}

void setLoosening(Window& window, bool on)
{
    ToolSettings settings = window.viewport().toolSettings();
    settings.loosen = on;
    window.viewport().setToolSettings(settings);
    storeToolSettings(settings);
}

void showSpeed(Window& window)
{
    SpeedDialog& dialog = speedDialog(window);
    if (!dialog.hasFindings() && !dialog.isMeasuring())
        dialog.measure();
}

template <size_t k>
ActionInfo navigationRow(const char* id)
{
    const NavigationPreset& preset = navigationPresets()[k];
    return {.id = id,
            .text = preset.title,
            .shortcuts = {},
            .tip = preset.tip,
            .run = [](Window& w, bool) { w.viewport().setNavigation(navigationPresets()[k]); },
            .isChecked = [](Window& w) { return &w.viewport().navigation() == &navigationPresets()[k]; },
            .separated = k == 0,
            .submenu = TEXT("Turn the &view")};
}

void showCube(Window& window, bool on)
{
    window.viewport().showCube(on);
    QSettings().setValue("viewCube", on);
}

template <PaneLayout layout>
ActionInfo paneRow(const char* id, const char* text, const char* keys, const char* tip)
{
    return {.id = id,
            .text = text,
            .shortcuts = {QKeySequence(keys)},
            .tip = tip,
            .run = [](Window& w, bool) { w.viewport().setPaneLayout(layout); },
            .isChecked = [](Window& w) { return w.viewport().paneLayout() == layout; },
            .separated = layout == PaneLayout::one};
}

template <Appearance which>
ActionInfo appearanceRow(const char* id, const char* text, const char* tip)
{
    return {.id = id,
            .text = text,
            .shortcuts = {},
            .tip = tip,
            .run = [](Window&, bool) { setAppearance(which); },
            .isChecked = [](Window&) { return appearance() == which; },
            .separated = which == Appearance::system,
            .submenu = TEXT("Appea&rance")};
}

}  // namespace

const std::vector<ActionInfo>& viewActions()
{
    static const std::vector<ActionInfo> kList = {
        {.id = "view.fit",
         .text = TEXT("&Fit all"),
         .shortcuts = {QKeySequence("F")},
         .tip = TEXT("Bring the whole model into view"),
         .run = [](Window& w, bool) { w.viewport().fit(); }},
        {.id = "view.fitSelection",
         .text = TEXT("Fit &selection"),
         .shortcuts = {QKeySequence("Shift+F")},
         .tip = TEXT("Bring the selected objects into view"),
         .run = [](Window& w, bool) { w.viewport().fitSelection(); },
         .isEnabled = hasAnySelection},
        {.id = "view.iso",
         .text = TEXT("&Isometric"),
         .shortcuts = {QKeySequence("0")},
         .tip = TEXT("Look from a corner, everything in view"),
         .run = [](Window& w, bool) { w.viewport().look("iso"); },
         .separated = true},
        {.id = "view.front",
         .text = TEXT("F&ront"),
         .shortcuts = {QKeySequence("1")},
         .tip = TEXT("Look from the front"),
         .run = [](Window& w, bool) { w.viewport().look("front"); }},
        {.id = "view.back",
         .text = TEXT("&Back"),
         .shortcuts = {QKeySequence("Ctrl+1")},
         .tip = TEXT("Look from behind"),
         .run = [](Window& w, bool) { w.viewport().look("back"); }},
        {.id = "view.right",
         .text = TEXT("Ri&ght"),
         .shortcuts = {QKeySequence("3")},
         .tip = TEXT("Look from the right"),
         .run = [](Window& w, bool) { w.viewport().look("right"); }},
        {.id = "view.left",
         .text = TEXT("&Left"),
         .shortcuts = {QKeySequence("Ctrl+3")},
         .tip = TEXT("Look from the left"),
         .run = [](Window& w, bool) { w.viewport().look("left"); }},
        {.id = "view.top",
         .text = TEXT("&Top"),
         .shortcuts = {QKeySequence("7")},
         .tip = TEXT("Look from above"),
         .run = [](Window& w, bool) { w.viewport().look("top"); }},
        {.id = "view.bottom",
         .text = TEXT("Botto&m"),
         .shortcuts = {QKeySequence("Ctrl+7")},
         .tip = TEXT("Look from below"),
         .run = [](Window& w, bool) { w.viewport().look("bottom"); }},
        {.id = "view.orthographic",
         .text = TEXT("&Orthographic"),
         .shortcuts = {QKeySequence("5")},
         .tip = TEXT("Without perspective: parallel lines stay parallel"),
         .run = [](Window& w, bool on) { change(w, [on](Frame& frame) { frame.camera.orthographic = on; }); },
         .isChecked = [](Window& w) { return w.viewport().frame().camera.orthographic; },
         .separated = true},
        paneRow<PaneLayout::one>("view.onePane", TEXT("One &view"), "Ctrl+Alt+1",
                                 TEXT("Show the view that was clicked last alone")),
        paneRow<PaneLayout::two>("view.twoPanes", TEXT("T&wo views"), "Ctrl+Alt+2",
                                 TEXT("Show two views side by side: this one, and from above")),
        paneRow<PaneLayout::four>(
            "view.fourPanes", TEXT("Fo&ur views"), "Ctrl+Alt+4",
            TEXT("Show four views: from above, this one, from the front, from the right")),
        {.id = "view.cube",
         .text = TEXT("Vie&w cube"),
         .shortcuts = {QKeySequence("Ctrl+Alt+C")},
         .tip = TEXT(
             "Show a cube that turns with the view: click a side, an edge or a corner to look from there"),
         .run = [](Window& w, bool on) { showCube(w, on); },
         .isChecked = [](Window& w) { return w.viewport().showsCube(); }},
        {.id = "view.nets",
         .text = TEXT("All control &nets"),
         .shortcuts = {QKeySequence("N")},
         .tip = TEXT("Show the control points of every object, not only of the selected ones"),
         .run = [](Window& w,
                   bool on) { change(w, [on](Frame& frame) { frame.overlays.controlNets = on; }); },
         .isChecked = [](Window& w) { return w.viewport().frame().overlays.controlNets; },
         .separated = true},
        {.id = "view.knots",
         .text = TEXT("&Knot lines"),
         .shortcuts = {QKeySequence("K")},
         .tip = TEXT("Show where the surfaces' spans meet"),
         .run = [](Window& w, bool on) { change(w, [on](Frame& frame) { frame.overlays.knotLines = on; }); },
         .isChecked = [](Window& w) { return w.viewport().frame().overlays.knotLines; }},
        {.id = "view.points",
         .text = TEXT("Control &points"),
         .shortcuts = {QKeySequence("P")},
         .tip = TEXT("Show the points of control nets; without, none can be taken"),
         .run = [](Window& w, bool on) { change(w, [on](Frame& frame) { frame.overlays.points = on; }); },
         .isChecked = [](Window& w) { return w.viewport().frame().overlays.points; }},
        {.id = "view.hulls",
         .text = TEXT("&Hulls"),
         .shortcuts = {QKeySequence("Shift+N")},
         .tip = TEXT("Show the lines of control nets"),
         .run = [](Window& w, bool on) { change(w, [on](Frame& frame) { frame.overlays.hulls = on; }); },
         .isChecked = [](Window& w) { return w.viewport().frame().overlays.hulls; }},
        {.id = "view.isoCurves",
         .text = TEXT("Iso-&curves"),
         .shortcuts = {QKeySequence("C")},
         .tip = TEXT("Show lines of equal parameters, four to a span"),
         .run = [](Window& w,
                   bool on) { change(w, [on](Frame& frame) { frame.overlays.isoCurves = on ? 4 : 0; }); },
         .isChecked = [](Window& w) { return w.viewport().frame().overlays.isoCurves > 0; }},
        {.id = "view.outlines",
         .text = TEXT("Outl&ines"),
         .shortcuts = {QKeySequence("Shift+E")},
         .tip = TEXT("Show the borders of every surface, of trimmed ones of what is left"),
         .run = [](Window& w, bool on) { change(w, [on](Frame& frame) { frame.overlays.outlines = on; }); },
         .isChecked = [](Window& w) { return w.viewport().frame().overlays.outlines; }},
        {.id = "view.normals",
         .text = TEXT("Nor&mals"),
         .shortcuts = {QKeySequence("Shift+V")},
         .tip = TEXT("Show which way the front of every span points"),
         .run = [](Window& w, bool on) { change(w, [on](Frame& frame) { frame.overlays.normals = on; }); },
         .isChecked = [](Window& w) { return w.viewport().frame().overlays.normals; }},
        {.id = "view.friends",
         .text = TEXT("Friend &edges"),
         .shortcuts = {QKeySequence("E")},
         .tip = TEXT("Show how smoothly surfaces meet, edge by edge, in the colours of the panel Friends"),
         .run = [](Window& w, bool on) { showFriends(w, on); },
         .isChecked = [](Window& w) { return w.shownFriends().linesAreShown(); }},
        {.id = "view.combs",
         .text = TEXT("C&urvature combs"),
         .shortcuts = {QKeySequence("Shift+B")},
         .tip = TEXT("Show how iso-curves of the selected objects bend; the panel Measures has more"),
         .run = [](Window& w, bool on) { showCombs(w, on); },
         .isChecked = [](Window& w) { return w.viewport().combs().settings().shown; }},
        {.id = "view.section",
         .text = TEXT("Section cur&ves"),
         .shortcuts = {QKeySequence("Shift+P")},
         .tip = TEXT("Show where a plane cuts the visible surfaces; the panel Measures moves it"),
         .run = [](Window& w, bool on) { showSection(w, on); },
         .isChecked = [](Window& w) { return w.viewport().section().settings().shown; }},
        {.id = "view.deviation",
         .text = TEXT("&Deviation"),
         .shortcuts = {QKeySequence("Shift+D")},
         .tip = TEXT(
             "Colour the selected surfaces by their distance from the others; the panel Measures has more"),
         .run = [](Window& w, bool on) { w.viewport().showDeviation(on); },
         .isChecked = [](Window& w) { return w.viewport().frame().shading == Shading::deviation; }},
        {.id = "view.freezeCulling",
         .text = TEXT("Free&ze culling"),
         .shortcuts = {QKeySequence("Shift+C")},
         .tip = TEXT("Draw what was seen from here while the view moves on, and outline what was culled"),
         .run = [](Window& w, bool on) { freezeCulling(w, on); },
         .isChecked = [](Window& w) { return w.viewport().frame().cullingCamera.has_value(); }},
        {.id = "view.smoothEdges",
         .text = TEXT("Smooth &edges"),
         .tip = TEXT("Draw the borders of trimmed surfaces by how much of each pixel they cover; without it "
                     "is faster"),
         .run = [](Window& w, bool on) { change(w, [on](Frame& frame) { frame.smoothEdges = on; }); },
         .isChecked = [](Window& w) { return w.viewport().frame().smoothEdges; }},
        {.id = "view.loosen",
         .text = TEXT("&Loosen while moving"),
         .shortcuts = {QKeySequence("Shift+L")},
         .tip = TEXT("While the hand moves, let the tolerance loosen and edges be sharp so far that 60 "
                     "pictures a second come"),
         .run = [](Window& w, bool on) { setLoosening(w, on); },
         .isChecked = [](Window& w) { return w.viewport().toolSettings().loosen; }},
        navigationRow<0>("view.navigatePlain"),
        navigationRow<1>("view.navigateRhino"),
        navigationRow<2>("view.navigateBlender"),
        navigationRow<3>("view.navigateMaya"),
        {.id = "view.moreCells",
         .text = TEXT("&More cells"),
         .shortcuts = {QKeySequence("+")},
         .tip = TEXT("With the path cpu: draw every surface as one cell more each way (sampling fixed:N)"),
         .run = [](Window& w, bool) { changeUniformCells(w, 1); },
         .isEnabled = drawsOnCpu,
         .separated = true},
        {.id = "view.fewerCells",
         .text = TEXT("&Fewer cells"),
         .shortcuts = {QKeySequence("-")},
         .tip = TEXT("With the path cpu: draw every surface as one cell less each way (sampling fixed:N)"),
         .run = [](Window& w, bool) { changeUniformCells(w, -1); },
         .isEnabled = drawsOnCpu},
        appearanceRow<Appearance::system>("view.appearanceSystem", TEXT("As the &system"),
                                          TEXT("Windows light or dark as the system has them")),
        appearanceRow<Appearance::light>("view.appearanceLight", TEXT("&Light"),
                                         TEXT("Light windows, whatever the system has")),
        appearanceRow<Appearance::dark>("view.appearanceDark", TEXT("&Dark"),
                                        TEXT("Dark windows, whatever the system has")),
        {.id = "view.speed",
         .text = TEXT("Speed and &accuracy…"),
         .shortcuts = {QKeySequence("Ctrl+M")},
         .tip = TEXT("Measure what each path costs on this machine, and how far its picture is off"),
         .run = [](Window& w, bool) { showSpeed(w); },
         .separated = true},
    };
    return kList;
}

}  // namespace knotspan
