#include "ui/tools/object_dragging.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace knotspan {

namespace {

// The hand neither flattens nor mirrors; numbers may mirror.
constexpr double kLeastFactor = 0.01;
constexpr double kEvenPx = 120;  // to the right or up: e times as large

}  // namespace

ObjectDragging::ObjectDragging(std::map<ObjectId, SharedObject> objects, const GizmoHandle& handle,
                               const Vec3& centre, const Vec2& grip)
    : objects_(std::move(objects)),
      kind_(handle.kind),
      axis_(handle.axis),
      centre_(centre),
      grip_(grip)
{
}

Result<void> ObjectDragging::begin(const ToolContext& context)
{
    const SnapSettings& snap = context.settings.snap;
    const bool snaps = snap.grid || snap.points || snap.knotLines || snap.surfaces;
    if (kind_ != HandleKind::move || !snaps)
        return {};
    DragSnapping::Moving moving;
    for (const auto& [id, object] : objects_)
        moving.objects.insert(id);
    snapping_.emplace(context.document.scene(), snap, std::move(moving));
    return {};
}

Result<void> ObjectDragging::choose(DragAxis axis)
{
    if (axis != DragAxis::free && !coordinateOf(axis))
        return failure("Objects have no U, V and N of their own", "Choose X, Y or Z");
    if (axis == DragAxis::free && kind_ == HandleKind::turn)
        return failure("A turn needs an axis", "Choose X, Y or Z");
    axis_ = axis;
    degrees_ = 0;
    if (kind_ == HandleKind::scale || kind_ == HandleKind::scaleEvenly)
        kind_ = axis == DragAxis::free ? HandleKind::scaleEvenly : HandleKind::scale;
    return {};
}

Vec3 ObjectDragging::direction() const
{
    Vec3 along(0);
    if (const auto coordinate = coordinateOf(axis_))
        along[*coordinate] = 1;
    return along;
}

Result<Vec3> ObjectDragging::movementOf(const ToolContext& context, const Vec2& way)
{
    const PictureView view = viewOf(context);
    const Vec3 hand = centre_ + movedInViewPlane(view, centre_, way);
    const Vec3 axis = direction();
    Vec3 place = hand;
    if (axis_ != DragAxis::free) {
        const auto distance = movedAlong(view, centre_, axis, way);
        if (!distance)
            return tl::unexpected(distance.error());
        place = centre_ + *distance * axis;
    }
    if (snapping_)
        target_ = snapping_->target(view, hand, place);
    const Vec3 by = target_.value_or(place) - centre_;
    return axis_ == DragAxis::free ? by : glm::dot(by, axis) * axis;
}

Result<double> ObjectDragging::factorOf(const ToolContext& context, const Vec2& way) const
{
    const PictureView view = viewOf(context);
    if (axis_ == DragAxis::free)
        return std::exp((way.x - way.y) / (kEvenPx * view.pixelRatio));
    const auto distance = movedAlong(view, centre_, direction(), way);
    if (!distance)
        return tl::unexpected(distance.error());
    const double whole = kScaleBarPx * view.pixelRatio * view.camera.unitsPerPixel(centre_, view.height);
    return std::max(1 + *distance / whole, kLeastFactor);
}

Result<Edit> ObjectDragging::byHand(const ToolContext& context, const Vec2& way)
{
    target_.reset();
    switch (kind_) {
    case HandleKind::move: {
        const auto by = movementOf(context, way);
        return by ? movedBy(*by) : tl::unexpected(by.error());
    }
    case HandleKind::turn:
        degrees_ = turnedBy(viewOf(context), direction(), grip_, way, kRingPx * context.pixelRatio, degrees_);
        return turnedByDegrees(degrees_);
    case HandleKind::scale:
    case HandleKind::scaleEvenly:
        break;
    }
    const auto factor = factorOf(context, way);
    return factor ? scaledBy(*factor) : tl::unexpected(factor.error());
}

Result<Edit> ObjectDragging::byNumbers(const ToolContext&, const DragNumbers& numbers)
{
    target_.reset();
    if (kind_ == HandleKind::move && axis_ == DragAxis::free) {
        const auto by = movementBy(numbers, centre_);
        return by ? movedBy(*by) : tl::unexpected(by.error());
    }
    const auto number = kind_ == HandleKind::move ? distanceBy(numbers, axis_, centre_) : singleOf(numbers);
    if (!number)
        return tl::unexpected(number.error());
    return kind_ == HandleKind::move   ? movedBy(*number * direction())
           : kind_ == HandleKind::turn ? turnedByDegrees(*number)
                                       : scaledBy(*number);
}

Result<Edit> ObjectDragging::movedBy(const Vec3& by)
{
    moved_ = by;
    TransformNumbers numbers;
    numbers.translation = by;
    return transformed(numbers);
}

Result<Edit> ObjectDragging::turnedByDegrees(double degrees)
{
    TransformNumbers numbers;
    numbers.degrees = degrees * direction();
    return transformed(numbers);
}

Result<Edit> ObjectDragging::scaledBy(double factor)
{
    TransformNumbers numbers;
    numbers.scale = axis_ == DragAxis::free ? Vec3(factor) : Vec3(1);
    if (const auto coordinate = coordinateOf(axis_))
        numbers.scale[*coordinate] = factor;
    return transformed(numbers);
}

Result<Edit> ObjectDragging::transformed(TransformNumbers numbers) const
{
    numbers.pivot = centre_;
    const auto matrix = transformMatrix(numbers);
    if (!matrix)
        return tl::unexpected(matrix.error());
    Edit edit;
    for (const auto& [id, object] : objects_) {
        if (*matrix == Mat4(1.0)) {
            edit.set(id, object);
            continue;
        }
        auto changed = knotspan::moved(*object, *matrix);
        if (!changed)
            return tl::unexpected(changed.error());
        edit.set(id, std::make_shared<const SceneObject>(*std::move(changed)));
    }
    return edit;
}

QString ObjectDragging::step() const
{
    const size_t count = objects_.size();
    const auto number = static_cast<qulonglong>(count);
    switch (kind_) {
    case HandleKind::move:
        return count == 1 ? QObject::tr("Move object") : QObject::tr("Move %1 objects").arg(number);
    case HandleKind::turn:
        return count == 1 ? QObject::tr("Turn object") : QObject::tr("Turn %1 objects").arg(number);
    case HandleKind::scale:
    case HandleKind::scaleEvenly:
        break;
    }
    return count == 1 ? QObject::tr("Scale object") : QObject::tr("Scale %1 objects").arg(number);
}

QString ObjectDragging::manner() const
{
    const QString letter = letterOf(axis_);
    switch (kind_) {
    case HandleKind::move:
        return axis_ == DragAxis::free ? QObject::tr("Move") : QObject::tr("Along %1").arg(letter);
    case HandleKind::turn:
        return QObject::tr("About %1").arg(letter);
    case HandleKind::scale:
    case HandleKind::scaleEvenly:
        break;
    }
    return axis_ == DragAxis::free ? QObject::tr("Scale") : QObject::tr("Scale along %1").arg(letter);
}

QString ObjectDragging::unit(const Scene& scene) const
{
    return kind_ == HandleKind::move   ? " " + QString::fromStdString(scene.units())
           : kind_ == HandleKind::turn ? QStringLiteral("\u00b0")
                                       : QString();
}

void ObjectDragging::show(const ToolContext& context, Overlays& overlays) const
{
    if (target_)
        showTarget(viewOf(context), *target_, overlays);
}

}  // namespace knotspan
