#include "ui/tools/tool_list.h"

#include "ui/tools/move_control_point.h"

namespace knotspan {

const std::vector<ToolInfo>& tools()
{
    static const std::vector<ToolInfo> kTools = {
        {"move-control-point",
         "Click a surface to see its control points, drag a control point to move it in the view plane.",
         []() -> std::unique_ptr<Tool> { return std::make_unique<MoveControlPoint>(); }},
    };
    return kTools;
}

}  // namespace knotspan
