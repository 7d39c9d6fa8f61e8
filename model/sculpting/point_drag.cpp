#include "model/sculpting/point_drag.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <glm/geometric.hpp>

#include "model/core/check.h"
#include "model/sculpting/net_directions.h"

namespace knotspan {

namespace {

bool isOfTheNet(DragAxis axis)
{
    return axis == DragAxis::u || axis == DragAxis::v || axis == DragAxis::normal;
}

Vec3 axisOfModel(DragAxis axis)
{
    return {axis == DragAxis::x ? 1 : 0, axis == DragAxis::y ? 1 : 0, axis == DragAxis::z ? 1 : 0};
}

// Unit or zero, one for each point.
std::vector<Vec3> directionsAt(const SceneObject& object, const std::vector<ControlPointIndex>& points,
                               DragAxis axis)
{
    const NetNeighbours neighbours(object.surface);
    if (axis == DragAxis::normal)
        return normalsAt(object, neighbours, points);
    std::vector<Vec3> directions;
    for (const ControlPointIndex index : points)
        directions.push_back(
            directionAlongNet(object, neighbours, index, axis == DragAxis::u ? Direction::U : Direction::V));
    return directions;
}

// What a movement along `direction` is multiplied by.
Mat3 along(const Vec3& direction)
{
    return {direction, Vec3(0), Vec3(0)};
}

std::vector<ControlPointIndex> indicesOf(const std::vector<Follower>& followers)
{
    std::vector<ControlPointIndex> indices;
    for (const Follower& follower : followers)
        indices.push_back(follower.index);
    return indices;
}

size_t placeOf(const std::vector<Follower>& followers, ControlPointIndex index)
{
    const auto found =
        std::lower_bound(followers.begin(), followers.end(), index,
                         [](const Follower& a, ControlPointIndex b) { return comesBefore(a.index, b); });
    return static_cast<size_t>(found - followers.begin());
}

// The larger share leads; between equal ones, up to rounding, both do.
Mat3 merged(const Mat3& own, double ownShare, const Mat3& image, double imageShare)
{
    if (std::abs(ownShare - imageShare) <= 1e-9)
        return 0.5 * (own + image);
    return ownShare > imageShare ? own : image;
}

}  // namespace

Result<PointDrag> PointDrag::begin(const Scene& scene, const PointSelection& selection,
                                   const DragSettings& settings)
{
    PointSelection kept = selection;
    kept.keepOnly(scene);
    check(kept == selection, "selected control points are the scene's");
    PointDrag drag;
    drag.settings_ = settings;
    if (auto found = drag.findDirection(scene, selection); !found)
        return tl::unexpected(found.error());
    drag.followers_ = followersOf(scene, selection, settings.falloff, settings.others);
    const MirrorFollowers images =
        mirrorFollowersOf(scene, drag.followers_, settings.symmetry, settings.others);
    drag.withoutPartner_ = images.withoutPartner;
    drag.addParts(scene, drag.responses(scene), images);
    return drag;
}

Result<void> PointDrag::findDirection(const Scene& scene, const PointSelection& selection)
{
    if (!isOfTheNet(settings_.axis)) {
        direction_ = axisOfModel(settings_.axis);
        return {};
    }
    Vec3 sum{0};
    Vec3 first{0};
    for (const auto& [id, selected] : selection.objects())
        for (const Vec3& direction : directionsAt(*scene.find(id), selected.points, settings_.axis)) {
            first = first == Vec3(0) ? direction : first;
            sum += direction;
        }
    if (first == Vec3(0))
        return failure("The net has no such direction at the selected control points",
                       "Drag along another one, or freely");
    // All round a closed surface they cancel each other.
    direction_ =
        glm::length(sum) > 1e-9 * static_cast<double>(selection.size()) ? glm::normalize(sum) : first;
    return {};
}

PointDrag::Responses PointDrag::responses(const Scene& scene) const
{
    const bool free = settings_.axis == DragAxis::free;
    const bool own = settings_.eachItsOwn && isOfTheNet(settings_.axis);
    Responses result;
    for (const auto& [id, followers] : followers_) {
        std::vector<Vec3> directions(followers.size(), direction_);
        if (own)
            directions = directionsAt(*scene.find(id), indicesOf(followers), settings_.axis);
        std::vector<Mat3>& responses = result[id];
        for (size_t k = 0; k < followers.size(); ++k)
            responses.push_back(followers[k].share * (free ? Mat3(1.0) : along(directions[k])));
    }
    return result;
}

void PointDrag::addParts(const Scene& scene, const Responses& responses, const MirrorFollowers& images)
{
    for (const auto& [id, followers] : followers_)
        for (size_t k = 0; k < followers.size(); ++k)
            parts_[id].points.push_back({followers[k].index, followers[k].share, responses.at(id)[k]});
    std::map<ObjectId, std::vector<Moving>> mirrored;
    for (const auto& [id, list] : images.objects)
        for (const MirrorFollower& one : list) {
            const std::vector<Mat3>& of = responses.at(one.ofObject);
            const size_t k = placeOf(followers_.at(one.ofObject), one.of.index);
            mirrored[id].push_back({one.index, one.of.share, one.image * of[k]});
        }
    for (const auto& [id, list] : mirrored)
        parts_[id].points = joined(parts_[id].points, list);
    for (auto& [id, part] : parts_)
        part.start = scene.find(id);
}

// Both in the order of comesBefore(), and so is the result.
std::vector<PointDrag::Moving> PointDrag::joined(const std::vector<Moving>& own,
                                                 const std::vector<Moving>& images)
{
    std::vector<Moving> all;
    std::merge(own.begin(), own.end(), images.begin(), images.end(), std::back_inserter(all),
               [](const Moving& a, const Moving& b) { return comesBefore(a.index, b.index); });
    std::vector<Moving> result;
    for (const Moving& one : all) {
        // Of equal ones the merge puts what is own first.
        if (!result.empty() && result.back().index == one.index)
            result.back().response =
                merged(result.back().response, result.back().share, one.response, one.share);
        else
            result.push_back(one);
    }
    return result;
}

std::map<ObjectId, std::vector<PointShift>> PointDrag::shiftsBy(const Vec3& input) const
{
    std::map<ObjectId, std::vector<PointShift>> result;
    for (const auto& [id, part] : parts_) {
        std::vector<PointShift>& shifts = result[id];
        for (const Moving& moving : part.points)
            shifts.push_back({moving.index, moving.response * input});
    }
    return result;
}

std::map<ObjectId, std::vector<PointShift>> PointDrag::shifts(const Vec3& by) const
{
    return shiftsBy(settings_.axis == DragAxis::free ? by : Vec3(glm::dot(by, direction_), 0, 0));
}

PointSelection PointDrag::moving() const
{
    PointSelection all;
    for (const auto& [id, part] : parts_) {
        std::vector<ControlPointIndex> points;
        for (const Moving& one : part.points)
            points.push_back(one.index);
        all.add(PointSelection(id, netSizeOf(part.start->surface), std::move(points)));
    }
    return all;
}

Result<Edit> PointDrag::movedBy(const Vec3& input) const
{
    Edit edit;
    for (const auto& [id, shifts] : shiftsBy(input)) {
        auto changed = withPointsMoved(parts_.at(id).start, shifts);
        if (!changed)
            return tl::unexpected(changed.error());
        edit.set(id, *std::move(changed));
    }
    return edit;
}

Result<Edit> PointDrag::moved(const Vec3& by) const
{
    return movedBy(settings_.axis == DragAxis::free ? by : Vec3(glm::dot(by, direction_), 0, 0));
}

Result<Edit> PointDrag::movedAlong(double distance) const
{
    check(settings_.axis != DragAxis::free, "a drag along an axis has one");
    return movedBy({distance, 0, 0});
}

}  // namespace knotspan
