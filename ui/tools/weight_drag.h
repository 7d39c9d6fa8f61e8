// Changes the weights of the selected control points: up draws the surface to them, down lets it go. A
// hundred pixels are a factor of e; with Shift held the hand counts a tenth. It stops where a weight would
// leave what weights.h allows.
#pragma once

#include "model/sculpting/weights.h"
#include "ui/tools/tool.h"

namespace knotspan {

class WeightDrag : public Tool {
public:
    void hover(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer press(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer move(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer release(const ToolContext& context, const ToolPointer& pointer) override;
    void click(const ToolContext& context, const ToolPointer& pointer) override;
    void cancel() override { drag_.reset(); }
    [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::SizeVerCursor; }

private:
    struct Drag {
        Scene start;
        ScenePoint point;  // under the hand: its weight is told
        PointSelection chosen;
        FactorRange range;
        double way = 0;  // upwards, in the hand's pixels that count
        double last = 0;
        bool hasMoved = false;
    };
    std::optional<Drag> drag_;
};

}  // namespace knotspan
