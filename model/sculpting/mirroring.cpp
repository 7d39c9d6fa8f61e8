#include "model/sculpting/mirroring.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "model/core/check.h"
#include "model/sculpting/nearest_points.h"
#include "model/sculpting/net_directions.h"
#include "model/sculpting/points_in_box.h"

namespace knotspan {

namespace {

// Columns: the net's u made perpendicular to the normal, what is perpendicular to both, the normal.
Mat3 frameFrom(const Vec3& u, const Vec3& v, const Vec3& normal)
{
    const Vec3 acrossV = glm::cross(v, normal);  // along u as far as it can be told from v
    const Vec3 flat = u - normal * glm::dot(normal, u);
    const bool byU = glm::length(flat) > 1e-9;
    const Vec3 any = std::abs(normal.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 along = byU                           ? flat
                       : glm::length(acrossV) > 1e-9 ? acrossV
                                                     : any - normal * glm::dot(normal, any);
    const Vec3 first = glm::normalize(along);
    return {first, glm::cross(normal, first), normal};
}

std::vector<Mat3> framesAt(const SceneObject& object, const std::vector<ControlPointIndex>& points)
{
    const NetNeighbours neighbours(object.surface);
    const std::vector<Vec3> normals = normalsAt(object, neighbours, points);
    std::vector<Mat3> frames;
    for (size_t k = 0; k < points.size(); ++k)
        frames.push_back(frameFrom(directionAlongNet(object, neighbours, points[k], Direction::U),
                                   directionAlongNet(object, neighbours, points[k], Direction::V),
                                   normals[k]));
    return frames;
}

std::vector<MirrorFollower> imagesByIndex(const SceneObject& object, ObjectId id,
                                          const std::vector<Follower>& followers, SymmetryKind kind)
{
    const NetSize size = netSizeOf(object.surface);
    const bool byU = kind == SymmetryKind::u;
    std::vector<ControlPointIndex> from;
    std::vector<ControlPointIndex> to;
    for (const Follower& follower : followers) {
        const ControlPointIndex index = follower.index;
        from.push_back(index);
        to.push_back(byU ? ControlPointIndex{size.countU - 1 - index.i, index.j}
                         : ControlPointIndex{index.i, size.countV - 1 - index.j});
    }
    const std::vector<Mat3> framesFrom = framesAt(object, from);
    const std::vector<Mat3> framesTo = framesAt(object, to);
    Mat3 turn(1.0);
    turn[byU ? 0 : 1] *= -1.0;
    std::vector<MirrorFollower> images;
    for (size_t k = 0; k < followers.size(); ++k)
        images.push_back({to[k], followers[k], id, framesTo[k] * turn * glm::transpose(framesFrom[k])});
    std::sort(images.begin(), images.end(),
              [](const auto& a, const auto& b) { return comesBefore(a.index, b.index); });
    return images;
}

// All followers of all objects in one list, and where their images are.
class PlaneImages {
public:
    PlaneImages(const Scene& scene, const Followers& followers, const Symmetry& symmetry, double tolerance)
        : plane_(symmetry.plane),
          image_(reflectionIn(symmetry.plane)),
          tolerance_(tolerance),
          found_(flatten(followers)),
          images_(placesOf(scene))
    {
    }

    [[nodiscard]] std::vector<MirrorFollower> amongPointsOf(const SceneObject& object)
    {
        const Box near{images_.bounds().low - Vec3(tolerance_), images_.bounds().high + Vec3(tolerance_)};
        std::vector<MirrorFollower> result;
        forPointsInBox(object, near, [&](ControlPointIndex index, const Vec3& at) {
            if (const Found* const best = partnerAt(at))
                result.push_back({index, best->follower, best->object, image_});
        });
        return result;
    }

    [[nodiscard]] size_t withoutPartner() const
    {
        return static_cast<size_t>(
            std::count_if(found_.begin(), found_.end(), [](const Found& one) { return !one.hasPartner; }));
    }

private:
    struct Found {
        ObjectId object{};
        Follower follower;
        bool hasPartner = false;
    };

    static std::vector<Found> flatten(const Followers& followers)
    {
        std::vector<Found> all;
        for (const auto& [id, list] : followers)
            for (const Follower& follower : list)
                all.push_back({id, follower});
        return all;
    }

    [[nodiscard]] NearestPoints placesOf(const Scene& scene) const
    {
        std::vector<Vec3> places;
        SharedObject object;
        for (size_t k = 0; k < found_.size(); ++k) {
            if (k == 0 || found_[k].object != found_[k - 1].object)
                object = scene.find(found_[k].object);
            places.push_back(mirrored(controlPointInModel(*object, found_[k].follower.index), plane_));
        }
        return NearestPoints(places);
    }

    const Found* partnerAt(const Vec3& place)
    {
        const Found* best = nullptr;
        for (const size_t k : images_.within(place, tolerance_)) {
            found_[k].hasPartner = true;
            if (!best || found_[k].follower.share > best->follower.share)
                best = &found_[k];
        }
        return best;
    }

    SymmetryPlane plane_;
    Mat3 image_;
    double tolerance_;
    std::vector<Found> found_;
    NearestPoints images_;
};

MirrorFollowers imagesByPlane(const Scene& scene, const Followers& followers, const Symmetry& symmetry,
                              std::set<ObjectId> objects)
{
    for (const auto& [id, list] : followers)
        objects.insert(id);
    Box all;
    for (const ObjectId id : objects)
        if (const SharedObject object = scene.find(id))
            all.add(object->bounds());
    PlaneImages images(scene, followers, symmetry,
                       symmetry.tolerance > 0 ? symmetry.tolerance : 1e-6 * all.diagonal());
    MirrorFollowers result;
    for (const ObjectId id : objects)
        if (const SharedObject object = scene.find(id))
            if (auto found = images.amongPointsOf(*object); !found.empty())
                result.objects.emplace(id, std::move(found));
    result.withoutPartner = images.withoutPartner();
    return result;
}

}  // namespace

Vec3 mirrored(const Vec3& place, const SymmetryPlane& plane)
{
    const Vec3 normal = glm::normalize(plane.normal);
    return place - normal * (2 * glm::dot(normal, place - plane.point));
}

Mat3 reflectionIn(const SymmetryPlane& plane)
{
    check(glm::length(plane.normal) > 0, "a mirror plane has a normal");
    const Vec3 normal = glm::normalize(plane.normal);
    return Mat3(1.0) - 2.0 * glm::outerProduct(normal, normal);
}

MirrorFollowers mirrorFollowersOf(const Scene& scene, const Followers& followers, const Symmetry& symmetry,
                                  const std::set<ObjectId>& others)
{
    MirrorFollowers result;
    switch (symmetry.kind) {
    case SymmetryKind::none:
        break;
    case SymmetryKind::plane:
        return imagesByPlane(scene, followers, symmetry, others);
    case SymmetryKind::u:
    case SymmetryKind::v:
        for (const auto& [id, list] : followers)
            result.objects.emplace(id, imagesByIndex(*scene.find(id), id, list, symmetry.kind));
        break;
    }
    return result;
}

}  // namespace knotspan
