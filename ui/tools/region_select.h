// Selects by a box or a lasso drawn around: control points where some show, otherwise objects that lie inside
// as a whole. A press that goes nowhere is a click.
#pragma once

#include "model/sculpting/screen_selection.h"
#include "ui/tools/tool.h"

namespace knotspan {

enum class RegionShape { box, lasso };

class RegionSelect : public Tool {
public:
    explicit RegionSelect(RegionShape shape) : shape_(shape) {}

    void hover(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer press(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer move(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer release(const ToolContext& context, const ToolPointer& pointer) override;
    void click(const ToolContext&, const ToolPointer&) override {}
    void cancel() override { corners_.clear(); }
    void show(const ToolContext& context, Overlays& overlays) const override;
    [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

private:
    [[nodiscard]] PointSelection inside(const std::vector<ProjectedNet>& nets) const;

    RegionShape shape_;
    // Of the lasso in order; of the box the first and where the hand is. Empty: none is drawn.
    std::vector<Vec2> corners_;
};

}  // namespace knotspan
