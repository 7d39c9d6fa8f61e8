#include "model/sculpting/falloff.h"

#include <algorithm>
#include <cmath>

#include <glm/vector_relational.hpp>

#include "model/core/check.h"
#include "model/sculpting/nearest_points.h"
#include "model/sculpting/net_distance.h"
#include "model/sculpting/points_in_box.h"

namespace knotspan {

namespace {

SharedObject objectOf(const Scene& scene, ObjectId id, const SelectedPoints& selected)
{
    SharedObject object = scene.find(id);
    check(object && netSizeOf(object->surface) == selected.net, "selected control points are the scene's");
    return object;
}

std::vector<Follower> alone(const SelectedPoints& selected)
{
    std::vector<Follower> followers;
    for (const ControlPointIndex index : selected.points)
        followers.push_back({index, 1});
    return followers;
}

std::vector<Follower> alongNet(const SceneObject& object, const SelectedPoints& selected,
                               const Falloff& falloff)
{
    const auto measure =
        falloff.distance == FalloffDistance::netSteps ? NetMeasure::steps : NetMeasure::lengths;
    const std::vector<double> distances = distancesAlongNet(object, selected.points, measure, falloff.radius);
    std::vector<Follower> followers;
    for (size_t place = 0; place < distances.size(); ++place) {
        const double share = falloffShare(falloff.shape, distances[place], falloff.radius);
        if (share > 0)
            followers.push_back({selected.net.indexAt(place), share});
    }
    return followers;
}

NearestPoints positionsOf(const Scene& scene, const PointSelection& selection)
{
    std::vector<Vec3> positions;
    positions.reserve(selection.size());
    for (const auto& [id, selected] : selection.objects()) {
        const SharedObject object = objectOf(scene, id, selected);
        for (const ControlPointIndex index : selected.points)
            positions.push_back(controlPointInModel(*object, index));
    }
    return NearestPoints(positions);
}

std::vector<Follower> inSpace(const SceneObject& object, const NearestPoints& selected,
                              const Falloff& falloff)
{
    Box reach = selected.bounds();
    reach.low -= Vec3(falloff.radius);
    reach.high += Vec3(falloff.radius);
    std::vector<Follower> followers;
    forPointsInBox(object, reach, [&](ControlPointIndex index, const Vec3& position) {
        const auto nearest = selected.nearest(position, falloff.radius);
        const double share = nearest ? falloffShare(falloff.shape, nearest->distance, falloff.radius) : 0;
        if (share > 0)
            followers.push_back({index, share});
    });
    return followers;
}

bool overlap(const Box& a, const Box& b, double gap)
{
    return glm::all(glm::lessThanEqual(a.low - Vec3(gap), b.high)) &&
           glm::all(glm::lessThanEqual(b.low - Vec3(gap), a.high));
}

Followers inSpace(const Scene& scene, const PointSelection& selection, const Falloff& falloff,
                  std::set<ObjectId> objects)
{
    for (const auto& [id, selected] : selection.objects())
        objects.insert(id);
    const NearestPoints positions = positionsOf(scene, selection);
    Followers followers;
    for (const ObjectId id : objects) {
        const SharedObject object = scene.find(id);
        const bool isNear = selection.objects().count(id) != 0 ||
                            (object && overlap(object->bounds(), positions.bounds(), falloff.radius));
        if (!isNear)
            continue;
        if (auto found = inSpace(*object, positions, falloff); !found.empty())
            followers.emplace(id, std::move(found));
    }
    return followers;
}

}  // namespace

double falloffShare(FalloffShape shape, double distance, double radius)
{
    const double t = distance == 0 ? 1 : 1 - distance / radius;
    if (!(t > 0) || !(distance >= 0) || !(distance < radius || distance == 0))
        return 0;
    switch (shape) {
    case FalloffShape::smooth:
        return t * t * (3 - 2 * t);
    case FalloffShape::sphere:
        return std::sqrt(t * (2 - t));
    case FalloffShape::linear:
        return t;
    case FalloffShape::sharp:
        return t * t;
    case FalloffShape::constant:
        break;
    }
    return 1;
}

Followers followersOf(const Scene& scene, const PointSelection& selection, const Falloff& falloff,
                      const std::set<ObjectId>& others)
{
    Followers followers;
    if (!(falloff.radius > 0)) {
        for (const auto& [id, selected] : selection.objects())
            followers.emplace(id, alone(selected));
        return followers;
    }
    if (falloff.distance == FalloffDistance::space)
        return inSpace(scene, selection, falloff, others);
    for (const auto& [id, selected] : selection.objects())
        followers.emplace(id, alongNet(*objectOf(scene, id, selected), selected, falloff));
    return followers;
}

}  // namespace knotspan
