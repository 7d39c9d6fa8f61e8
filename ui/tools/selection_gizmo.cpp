#include "ui/tools/selection_gizmo.h"

#include "model/scene/control_point_editing.h"

namespace knotspan {

namespace {

constexpr DragAxis kModelAxes[] = {DragAxis::x, DragAxis::y, DragAxis::z};
constexpr DragAxis kSurfaceAxes[] = {DragAxis::u, DragAxis::v, DragAxis::normal};

Vec3 directionOf(DragAxis axis)
{
    return {axis == DragAxis::x ? 1 : 0, axis == DragAxis::y ? 1 : 0, axis == DragAxis::z ? 1 : 0};
}

PlacedHandles handlesOfPoints(const Scene& scene, const PointSelection& points, GizmoFrame frame)
{
    PlacedHandles placed;
    for (const auto& [id, chosen] : points.objects())
        for (const ControlPointIndex index : chosen.points)
            placed.centre += controlPointInModel(*scene.find(id), index);
    placed.centre /= static_cast<double>(points.size());
    if (frame == GizmoFrame::model)
        for (const DragAxis axis : kModelAxes)
            placed.handles.push_back({HandleKind::move, axis, directionOf(axis)});
    else
        for (const DragAxis axis : kSurfaceAxes) {
            DragSettings settings;
            settings.axis = axis;
            if (const auto drag = PointDrag::begin(scene, points, settings))
                placed.handles.push_back({HandleKind::move, axis, drag->direction()});
        }
    return placed;
}

PlacedHandles handlesOfObjects(const std::map<ObjectId, SharedObject>& objects)
{
    PlacedHandles placed;
    placed.ofObjects = true;
    Box bounds;
    for (const auto& [id, object] : objects)
        bounds.add(object->bounds());
    placed.centre = bounds.centre();
    for (const HandleKind kind : {HandleKind::move, HandleKind::turn, HandleKind::scale})
        for (const DragAxis axis : kModelAxes)
            placed.handles.push_back({kind, axis, directionOf(axis)});
    placed.handles.push_back({HandleKind::scaleEvenly, DragAxis::free, Vec3(0)});
    return placed;
}

}  // namespace

std::map<ObjectId, SharedObject> movableObjects(const Scene& scene, const std::set<ObjectId>& selected)
{
    std::map<ObjectId, SharedObject> objects;
    for (const ObjectId id : selected)
        if (SharedObject object = scene.find(id); object && object->visible && !object->locked)
            objects.emplace(id, std::move(object));
    return objects;
}

PlacedHandles handlesOf(const Scene& scene, const Selection& selection, GizmoFrame frame)
{
    if (frame == GizmoFrame::none)
        return {};
    PointSelection points = selection.points();
    points.keepOnly(scene);
    if (!points.isEmpty())
        return handlesOfPoints(scene, points, frame);
    const auto objects = movableObjects(scene, selection.objects());
    return objects.empty() ? PlacedHandles() : handlesOfObjects(objects);
}

const PlacedHandles& SelectionGizmo::at(const ToolContext& context)
{
    const std::uint64_t change = watch_.change(context);
    if (change_ != change || frame_ != context.settings.gizmo) {
        change_ = change;
        frame_ = context.settings.gizmo;
        found_ = handlesOf(context.document.scene(), context.selection, frame_);
    }
    return found_;
}

}  // namespace knotspan
