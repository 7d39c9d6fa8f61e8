#include "ui/tools/point_dragging.h"

#include <utility>

#include <glm/geometric.hpp>

#include "model/sculpting/twins.h"
#include "ui/tools/edit_checks.h"
#include "ui/tools/reach.h"

namespace knotspan {

namespace {

Result<Edit> pulled(DragWithFriends& friends, const PointDrag& points, const Vec3& by)
{
    std::vector<ObjectPull> pulls;
    for (const auto& [id, shifts] : points.shifts(by))
        for (const PointShift& shift : shifts)
            pulls.push_back({id, shift.index, friends.startOf(id, shift.index) + shift.by});
    return friends.pull(pulls);
}

}  // namespace

Result<MovedPoints> movedPoints(const Scene& scene, const PointSelection& chosen,
                                const ToolSettings& settings, const Vec3& by)
{
    DragSettings drag = settings.drag;
    drag.axis = DragAxis::free;
    drag.others = mayFollow(scene, drag);
    const PointSelection leaders = withTwins(scene, chosen);
    const auto points = PointDrag::begin(scene, leaders, drag);
    if (!points)
        return tl::unexpected(points.error());
    Result<Edit> edit = points->moved(by);
    if (settings.keepFriends) {
        DragWithFriends friends(scene, settings.friends);
        edit = pulled(friends, *points, by);
    }
    if (!edit)
        return tl::unexpected(edit.error());
    if (const auto allowed = leavesLockedAlone(scene, *edit); !allowed)
        return tl::unexpected(allowed.error());
    return MovedPoints{*std::move(edit), points->moving().size() - leaders.size()};
}

Result<void> PointDragging::begin(const ToolContext& context)
{
    const Scene& scene = context.document.scene();
    if (!begun_) {
        begun_ = Begun{scene, context.selection.points(), withTwins(scene, context.selection.points()),
                       context.settings.drag};
        begun_->settings.others = mayFollow(scene, begun_->settings);
    }
    if (auto held = takeHold(); !held)
        return held;
    if (context.settings.keepFriends)
        friends_.emplace(begun_->scene, context.settings.friends);
    const SnapSettings& snap = context.settings.snap;
    if (snap.grid || snap.points || snap.knotLines || snap.surfaces)
        snapping_.emplace(begun_->scene, snap,
                          DragSnapping::Moving{points_->moving(), {}, context.settings.keepFriends});
    marks_.clear();
    if (begun_->settings.falloff.radius > 0)
        marks_ = marksOf(points_->followers(), begun_->chosen);
    return {};
}

Result<void> PointDragging::takeHold()
{
    begun_->settings.axis = axis_;
    auto points = PointDrag::begin(begun_->scene, begun_->leaders, begun_->settings);
    if (!points)
        return tl::unexpected(points.error());
    points_ = *std::move(points);
    return {};
}

Result<void> PointDragging::choose(DragAxis axis)
{
    const DragAxis before = std::exchange(axis_, axis);
    if (!begun_)
        return {};
    auto held = takeHold();
    if (!held)
        axis_ = before;
    return held;
}

Result<Edit> PointDragging::byHand(const ToolContext& context, const Vec2& way)
{
    const PictureView view = viewOf(context);
    const Vec3 hand = start_ + movedInViewPlane(view, start_, way);
    target_.reset();
    if (axis_ == DragAxis::free) {
        if (snapping_)
            target_ = snapping_->target(view, hand, hand);
        return moved(target_.value_or(hand) - start_);
    }
    const Vec3 axis = points_->direction();
    auto distance = movedAlong(view, start_, axis, way);
    if (!distance)
        return tl::unexpected(distance.error());
    if (snapping_)
        target_ = snapping_->target(view, hand, start_ + *distance * axis);
    return movedAlongAxis(target_ ? glm::dot(*target_ - start_, axis) : *distance);
}

Result<Edit> PointDragging::byNumbers(const ToolContext&, const DragNumbers& numbers)
{
    target_.reset();
    if (axis_ == DragAxis::free) {
        const auto by = movementBy(numbers, start_);
        return by ? moved(*by) : tl::unexpected(by.error());
    }
    const auto distance = distanceBy(numbers, axis_, start_);
    return distance ? movedAlongAxis(*distance) : tl::unexpected(distance.error());
}

Result<Edit> PointDragging::moved(const Vec3& by)
{
    moved_ = by;
    return friends_ ? movedWithFriends(by) : points_->moved(by);
}

Result<Edit> PointDragging::movedAlongAxis(double distance)
{
    moved_ = distance * points_->direction();
    return friends_ ? movedWithFriends(moved_) : points_->movedAlong(distance);
}

Result<Edit> PointDragging::movedWithFriends(const Vec3& by)
{
    return pulled(*friends_, *points_, by);
}

QString PointDragging::step() const
{
    const size_t count = begun_->chosen.size();
    return count == 1 ? QObject::tr("Move control point")
                      : QObject::tr("Move %1 control points").arg(static_cast<qulonglong>(count));
}

QString PointDragging::manner() const
{
    return axis_ == DragAxis::free ? QObject::tr("Move") : QObject::tr("Along %1").arg(letterOf(axis_));
}

QString PointDragging::unit(const Scene& scene) const
{
    return " " + QString::fromStdString(scene.units());
}

void PointDragging::show(const ToolContext& context, Overlays& overlays) const
{
    overlays.marks.insert(overlays.marks.end(), marks_.begin(), marks_.end());
    if (target_)
        showTarget(viewOf(context), *target_, overlays);
}

}  // namespace knotspan
