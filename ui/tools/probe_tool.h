// Says what the surface is like under the cursor, and pins a probe there with a click. Changes nothing.
#pragma once

#include "ui/tools/tool.h"

namespace knotspan {

class ProbeTool : public Tool {
public:
    void hover(const ToolContext& context, const ToolPointer& pointer) override;
    // A drag turns the view.
    ToolAnswer press(const ToolContext&, const ToolPointer&) override { return ToolAnswer::pass; }
    ToolAnswer move(const ToolContext&, const ToolPointer&) override { return ToolAnswer::keep; }
    ToolAnswer release(const ToolContext&, const ToolPointer&) override { return ToolAnswer::revert; }
    void click(const ToolContext& context, const ToolPointer& pointer) override;
    void cancel() override {}
    void leave(const ToolContext& context) override;
    [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
};

}  // namespace knotspan
