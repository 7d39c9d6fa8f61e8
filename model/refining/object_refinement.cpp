#include "model/refining/object_refinement.h"

#include "model/geometry/orientation.h"
#include "model/refining/directions.h"
#include "model/trimming/loop_clipping.h"

namespace knotspan {

namespace {

// Of a surface whose normal was turned over.
Sides turnedOver(Sides sides)
{
    switch (sides) {
    case Sides::front:
        return Sides::back;
    case Sides::back:
        return Sides::front;
    case Sides::automatic:
    case Sides::both:
        break;
    }
    return sides;
}

RefinedObject withSurface(const SceneObject& object, NurbsSurface surface)
{
    RefinedObject result{object, {}, {}};
    result.object.surface = std::move(surface);
    return result;
}

template <class Turn>
RefinedObject turned(const SceneObject& object, NurbsSurface surface, const Turn& turn)
{
    RefinedObject result = withSurface(object, std::move(surface));
    for (TrimLoop& loop : result.object.trimLoops)
        loop = turn(loop);
    result.object.sides = turnedOver(object.sides);
    return result;
}

// Of a part of the object's surface, which has the same parameters.
Result<SceneObject> partOf(const SceneObject& object, NurbsSurface part, Direction direction)
{
    const KnotVector& knots = knotsOf(part, direction);
    auto loops = loopsBetween(object.trimLoops, object.surface, direction == Direction::U ? 0 : 1,
                              knots.domainStart(), knots.domainEnd());
    if (!loops)
        return tl::unexpected(loops.error());
    if (!*loops)
        return failure("Nothing is left of the trimmed surface on one side of that cut",
                       "Choose a parameter that goes through what shows of it");
    SceneObject result = object;
    result.surface = std::move(part);
    result.trimLoops = std::move(**loops);
    return result;
}

Result<RefinedObject> split(const SceneObject& object, const RefinementRequest& request)
{
    auto parts = splitAt(object.surface, request.direction, request.parameter);
    if (!parts)
        return tl::unexpected(parts.error());
    auto first = partOf(object, std::move(parts->first), request.direction);
    auto second = partOf(object, std::move(parts->second), request.direction);
    if (!first || !second)
        return tl::unexpected((first ? second : first).error());
    return RefinedObject{*std::move(first), *std::move(second), {}};
}

Result<Refinement> refinedSurface(const NurbsSurface& surface, const RefinementRequest& request)
{
    switch (request.kind) {
    case RefinementKind::insertKnot:
        return insertKnot(surface, request.direction, request.parameter);
    case RefinementKind::removeKnot:
        return removeKnot(surface, request.direction, request.parameter, request.tolerance);
    case RefinementKind::raiseDegree:
        return raiseDegree(surface, request.direction);
    case RefinementKind::lowerDegree:
        return lowerDegree(surface, request.direction, request.tolerance);
    default:
        return rebuild(surface, request.shape);
    }
}

}  // namespace

Result<RefinedObject> refined(const SceneObject& object, const RefinementRequest& request)
{
    const Direction direction = request.direction;
    switch (request.kind) {
    case RefinementKind::split:
        return split(object, request);
    case RefinementKind::reverse:
        return turned(object, reversed(object.surface, direction),
                      [direction](const TrimLoop& loop) { return reversed(loop, direction); });
    case RefinementKind::swap:
        return turned(object, swapped(object.surface), [](const TrimLoop& loop) { return swapped(loop); });
    default:
        break;
    }
    auto refinement = refinedSurface(object.surface, request);
    if (!refinement)
        return tl::unexpected(refinement.error());
    RefinedObject result = withSurface(object, std::move(refinement->surface));
    result.deviation = refinement->deviation;
    return result;
}

}  // namespace knotspan
