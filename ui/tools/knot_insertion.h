// Puts a knot where the surface is clicked: the iso-curve there lights up first. Of U; with Shift of V, with
// Ctrl of both. The shape stays what it is.
#pragma once

#include "model/geometry/knot_insertion.h"
#include "model/sculpting/surface_snapping.h"
#include "ui/tools/tool.h"

namespace knotspan {

class KnotInsertion : public Tool {
public:
    void hover(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer press(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer move(const ToolContext& context, const ToolPointer& pointer) override;
    ToolAnswer release(const ToolContext& context, const ToolPointer& pointer) override;
    void click(const ToolContext&, const ToolPointer&) override {}
    void cancel() override { place_.reset(); }
    void leave(const ToolContext& context) override;
    void show(const ToolContext& context, Overlays& overlays) const override;
    [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

private:
    // True where the surface is under the pointer.
    bool look(const ToolContext& context, const ToolPointer& pointer);
    [[nodiscard]] Result<SharedObject> withKnots(const SceneObject& object) const;

    std::optional<SurfacePlace> place_;  // that a click would take
    std::vector<Direction> directions_;
};

}  // namespace knotspan
