#include "ui/tools/tool_list.h"

#include "ui/tools/brush.h"
#include "ui/tools/knot_insertion.h"
#include "ui/tools/move_control_point.h"
#include "ui/tools/probe_tool.h"
#include "ui/tools/region_select.h"
#include "ui/tools/trim_tool.h"
#include "ui/tools/weight_drag.h"

namespace knotspan {

// Marks a text for translation, as the actions' texts.
#define TEXT(text) QT_TRANSLATE_NOOP("knotspan::Actions", text)

const std::vector<ToolInfo>& tools()
{
    static const std::vector<ToolInfo> kTools = {
        {"select", TEXT("&Select and move"), "V",
         TEXT("Click to select, drag a control point or a handle to move it"),
         TEXT("Click a surface to see its control points ({view.nets}: of all), drag one to pull the "
              "surface."),
         []() -> std::unique_ptr<Tool> { return std::make_unique<MoveControlPoint>(); }},
        {"box", TEXT("&Box select"), "B", TEXT("Select what lies in a box drawn around it"),
         TEXT("Drag a box around control points, or around objects where no control points show. Shift adds, "
              "Ctrl takes in or out."),
         []() -> std::unique_ptr<Tool> { return std::make_unique<RegionSelect>(RegionShape::box); }, true},
        {"lasso", TEXT("&Lasso select"), "L", TEXT("Select what lies in a line drawn around it"),
         TEXT("Draw around control points, or around objects where no control points show. Shift adds, Ctrl "
              "takes in or out."),
         []() -> std::unique_ptr<Tool> { return std::make_unique<RegionSelect>(RegionShape::lasso); }, true},
        {"weight", TEXT("&Weight"), "W", TEXT("Drag control points up or down to change their weights"),
         TEXT("Drag a control point up to draw the surface to it, down to let it go; Shift makes it fine."),
         []() -> std::unique_ptr<Tool> { return std::make_unique<WeightDrag>(); }},
        {"knot", TEXT("&Insert knot"), "I",
         TEXT("Click a surface to insert a knot there, its shape unchanged"),
         TEXT("Click where a knot is to go: of U, with Shift of V, with Ctrl of both. The shape stays."),
         []() -> std::unique_ptr<Tool> { return std::make_unique<KnotInsertion>(); }},
        {"grab", TEXT("&Grab brush"), "G", TEXT("Pull the surface under a round brush"),
         TEXT("Drag the surface: control points under the circle follow. {tools.smallerBrush} and "
              "{tools.largerBrush} change its size."),
         []() -> std::unique_ptr<Tool> { return std::make_unique<Brush>(BrushKind::grab); }},
        {"smooth", TEXT("S&mooth brush"), "S", TEXT("Smooth the surface under a round brush"),
         TEXT("Stroke the surface to even its control points out. {tools.smallerBrush} and "
              "{tools.largerBrush} change the circle's size."),
         []() -> std::unique_ptr<Tool> { return std::make_unique<Brush>(BrushKind::smooth); }},
        {"inflate", TEXT("I&nflate brush"), "J", TEXT("Blow the surface up under a round brush"),
         TEXT("Stroke the surface to raise it along its normal, with Ctrl to lower it, with Shift to smooth "
              "it. {tools.smallerBrush} and {tools.largerBrush} change the circle's size."),
         []() -> std::unique_ptr<Tool> { return std::make_unique<Brush>(BrushKind::inflate); }},
        {"flatten", TEXT("&Flatten brush"), "T", TEXT("Flatten the surface under a round brush"),
         TEXT("Stroke the surface to bring it to a plane, with Shift to smooth it. {tools.smallerBrush} and "
              "{tools.largerBrush} change the "
              "circle's size."),
         []() -> std::unique_ptr<Tool> { return std::make_unique<Brush>(BrushKind::flatten); }},
        {"probe", TEXT("Prob&e"), "O",
         TEXT("Measure the surface under the cursor: place, normal, curvatures"),
         TEXT("Point at a surface to see place, normal and curvatures; click to pin a probe that follows it. "
              "The panel Measures lists them."),
         []() -> std::unique_ptr<Tool> { return std::make_unique<ProbeTool>(); }},
        {"trim", TEXT("&Trim"), "Shift+T",
         TEXT("Draw a closed curve over a surface and keep what lies inside or outside"),
         TEXT("Click points around what is to be cut; Enter closes the curve. S: straight or smooth."),
         []() -> std::unique_ptr<Tool> { return std::make_unique<TrimTool>(); }, true},
    };
    return kTools;
}

#undef TEXT

}  // namespace knotspan
