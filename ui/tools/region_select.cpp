#include "ui/tools/region_select.h"

#include <glm/geometric.hpp>

#include "ui/tools/choosing.h"
#include "ui/tools/hand_strokes.h"
#include "ui/tools/steadiness.h"

namespace knotspan {

namespace {

constexpr double kLassoStepPx = 2;

// What has points to be taken: shown, and not locked.
std::set<ObjectId> netsShown(const ToolContext& context)
{
    std::set<ObjectId> shown;
    for (const auto& [id, object] : context.document.scene().objects())
        if (object->visible && !object->locked && (context.allNetsShow || context.selection.contains(id)))
            shown.insert(id);
    return shown;
}

std::set<ObjectId> objectsThatShow(const Scene& scene)
{
    std::set<ObjectId> shown;
    for (const auto& [id, object] : scene.objects())
        if (object->visible && !object->locked)
            shown.insert(id);
    return shown;
}

}  // namespace

void RegionSelect::hover(const ToolContext& context, const ToolPointer& pointer)
{
    hoverAt(context, pointer);
}

ToolAnswer RegionSelect::press(const ToolContext& context, const ToolPointer& pointer)
{
    context.document.endPreview();
    context.selection.setHovered({});
    corners_ = {pointer.position};
    return ToolAnswer::keep;
}

ToolAnswer RegionSelect::move(const ToolContext& context, const ToolPointer& pointer)
{
    const double step = (corners_.size() == 1 ? kStillPx : kLassoStepPx) * context.pixelRatio;
    const bool follows = shape_ == RegionShape::box && corners_.size() > 1;
    if (!follows && glm::distance(pointer.position, corners_.back()) < step)
        return ToolAnswer::keep;
    if (shape_ == RegionShape::box)
        corners_.resize(1);
    corners_.push_back(pointer.position);
    context.redraw();
    return ToolAnswer::keep;
}

PointSelection RegionSelect::inside(const std::vector<ProjectedNet>& nets) const
{
    return shape_ == RegionShape::box ? insideBox(nets, corners_.front(), corners_.back())
                                      : insideLasso(nets, Lasso(corners_));
}

ToolAnswer RegionSelect::release(const ToolContext& context, const ToolPointer& pointer)
{
    if (corners_.size() < 2) {
        corners_.clear();
        chooseAt(context, pointer);
        return ToolAnswer::commit;
    }
    const Scene& scene = context.document.scene();
    const Projection toPixel = [&](const Vec3& place) {
        return context.camera.toPixel(place, context.width, context.height);
    };
    const Choosing how = choosingBy(pointer.modifiers);
    const SelectionFilter& filter = context.settings.filter;
    if (const auto nets = netsShown(context); filter.points && !nets.empty()) {
        choosePoints(context.selection, inside(projected(scene, nets, toPixel)), how);
    } else if (filter.objects) {
        std::set<ObjectId> whole;
        const PointSelection points = inside(projected(scene, objectsThatShow(scene), toPixel));
        for (const auto& [id, chosen] : points.objects())
            if (chosen.points.size() == scene.find(id)->surface.controlPoints().size())
                whole.insert(id);
        chooseObjects(context.selection, whole, how);
    }
    corners_.clear();
    context.redraw();
    return ToolAnswer::commit;
}

void RegionSelect::show(const ToolContext& context, Overlays& overlays) const
{
    if (corners_.size() < 2)
        return;
    std::vector<Vec2> outline = corners_;
    if (shape_ == RegionShape::box) {
        const Vec2 a = corners_.front();
        const Vec2 b = corners_.back();
        outline = {a, {b.x, a.y}, b, {a.x, b.y}};
    }
    // What closes a lasso is not drawn by the hand.
    addClosed(outline, context.pixelRatio, shape_ == RegionShape::box ? 1 : 0.4F, overlays.strokes);
}

}  // namespace knotspan
