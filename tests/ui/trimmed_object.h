// An object with trim loops, for actions that ask for some.
#pragma once

#include <memory>

#include "model/scene/scene_object.h"

namespace knotspan::testing {

// The half of it below the diagonal of its domain.
inline SharedObject trimmedToATriangle(const SceneObject& whole)
{
    SceneObject object = whole;
    const KnotVector& u = object.surface.knotsU();
    const KnotVector& v = object.surface.knotsV();
    const Vec2 low(u.domainStart(), v.domainStart());
    const Vec2 high(u.domainEnd(), v.domainEnd());
    const std::vector<TrimPoint> points{{low}, {{high.x, low.y}}, {high}, {low}};
    object.trimLoops = {{true, {TrimCurve::create(KnotVector::clampedUniform(1, 3), points).value()}}};
    return std::make_shared<SceneObject>(std::move(object));
}

}  // namespace knotspan::testing
