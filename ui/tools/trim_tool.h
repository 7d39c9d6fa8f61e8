// Trims a surface by a closed curve drawn over it: points are clicked, the curve closed, then the side that
// is to stay is clicked. Until then the picture shows what would be left on the side under the pointer.
#pragma once

#include <array>

#include "model/trimming/curve_projection.h"
#include "model/trimming/loop_combining.h"
#include "ui/tools/tool.h"

namespace knotspan {

class TrimTool : public Tool {
public:
    void hover(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer press(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer move(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer release(const ToolContext&, const ToolPointer&) override { return ToolAnswer::stay; }
    void click(const ToolContext&, const ToolPointer&) override {}
    void cancel() override;
    ToolAnswer key(const ToolContext& context, const QKeyEvent& event) override;
    void leave(const ToolContext& context) override;
    void show(const ToolContext& context, Overlays& overlays) const override;
    [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

private:
    // A clicked point, and the place of a surface that was under it.
    struct Corner {
        Vec2 pixel;
        ObjectId object{};
        std::optional<Vec2> place;  // u, v
    };
    // What a closed curve leaves of a surface, by KeptSide.
    struct Choice {
        ObjectId object{};
        SharedObject before;
        std::array<Result<std::vector<TrimLoop>>, 2> loops;
        std::optional<KeptSide> shown;
        double error = 0;  // of the curve in space
    };

    void add(const ToolContext& context, const Vec2& pixel);
    void close(const ToolContext& context);
    [[nodiscard]] Result<Choice> choiceOf(const ToolContext& context) const;
    void showSide(const ToolContext& context, KeptSide side);
    // Whether there is something to take.
    [[nodiscard]] bool canTake() const
    {
        return choice_->loops[static_cast<size_t>(*choice_->shown)].has_value();
    }
    [[nodiscard]] PlaneCurve curveThrough(const std::vector<Vec2>& pixels) const;
    [[nodiscard]] std::vector<Vec2> outline(std::vector<Vec2> pixels) const;
    [[nodiscard]] std::vector<Vec2> pixels() const;
    void hint(const ToolContext& context) const;

    std::vector<Corner> corners_;
    Vec2 pointer_{};
    bool isSmooth_ = true;
    std::optional<Choice> choice_;  // once the curve is closed
};

}  // namespace knotspan
