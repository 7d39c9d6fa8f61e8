#include "model/sculpting/brushes.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "model/geometry/grid_evaluation.h"
#include "model/scene/control_point_editing.h"
#include "model/sculpting/best_plane.h"
#include "model/sculpting/net_directions.h"
#include "model/sculpting/point_moving.h"

namespace knotspan {

namespace {

// A control point within reach of the dab, or of its mirror image.
struct Touched {
    ControlPointIndex index;
    Vec3 position;           // in model space
    double share = 0;        // of the dab at its place
    double mirrorShare = 0;  // of the dab's image
    [[nodiscard]] double larger() const { return std::max(share, mirrorShare); }
};

// Where on the surface each control point weighs most, in model space: there the hand means it, also where it
// stands far off.
class PlacesOnSurface {
public:
    explicit PlacesOnSurface(const SceneObject& object) : object_(object)
    {
        const NurbsSurface& surface = object.surface;
        std::vector<double> u;
        std::vector<double> v;
        for (int i = 0; i < surface.countU(); ++i)
            u.push_back(grevilleParameter(surface.knotsU(), i));
        for (int j = 0; j < surface.countV(); ++j)
            v.push_back(grevilleParameter(surface.knotsV(), j));
        GridEvaluator<double>(surface, {})
            .evaluate(spanParameters(surface.knotsU(), u), spanParameters(surface.knotsV(), v), samples_);
    }
    [[nodiscard]] Vec3 operator()(ControlPointIndex index) const
    {
        return transformed(samples_.position(index.i, index.j) + samples_.origin(), object_.transform);
    }

private:
    const SceneObject& object_;
    GridSamples<double> samples_;
};

bool touches(const Box& a, const Box& b)
{
    return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}

std::vector<Touched> touchedBy(const SceneObject& object, const Dab& dab)
{
    const Vec3 image = dab.mirror ? mirrored(dab.centre, *dab.mirror) : dab.centre;
    Box reach;
    for (const Vec3& centre : {dab.centre, image}) {
        reach.add(centre - Vec3(dab.radius));
        reach.add(centre + Vec3(dab.radius));
    }
    std::vector<Touched> result;
    if (!touches(reach, object.bounds()))
        return result;
    const NurbsSurface& surface = object.surface;
    const NetNeighbours neighbours(surface);
    const PlacesOnSurface onSurface(object);
    for (int i = 0; i < surface.countU(); ++i)
        for (int j = 0; j < surface.countV(); ++j) {
            // One answer for all that are one point.
            const Vec3 place = onSurface(neighbours.first({i, j}));
            Touched one{{i, j}, controlPointInModel(object, {i, j})};
            const auto shareOf = [&](const Vec3& centre) {
                const double away =
                    std::min(glm::distance(one.position, centre), glm::distance(place, centre));
                return falloffShare(dab.shape, away, dab.radius);
            };
            one.share = shareOf(dab.centre);
            if (dab.mirror)
                one.mirrorShare = shareOf(image);
            if (one.larger() > 0)
                result.push_back(one);
        }
    return result;
}

// What the dab at its place asks for, or its image; with equal shares, up to rounding, the mean of both.
Vec3 nearer(const Touched& one, const Vec3& own, const Vec3& image)
{
    if (one.share > 0 && one.mirrorShare > 0 && std::abs(one.share - one.mirrorShare) <= 1e-9)
        return 0.5 * (own + image);
    return one.share > one.mirrorShare ? own : image;
}

std::vector<PointShift> grabbed(const std::vector<Touched>& touched, const Dab& dab)
{
    const Vec3 image = dab.mirror ? reflectionIn(*dab.mirror) * dab.by : Vec3(0);
    std::vector<PointShift> shifts;
    for (const Touched& one : touched)
        shifts.push_back({one.index, nearer(one, dab.strength * one.share * dab.by,
                                            dab.strength * one.mirrorShare * image)});
    return shifts;
}

// Where the neighbours' mean is, from the point; a corner has none.
Vec3 wayToNeighbours(const NurbsSurface& surface, const NetNeighbours& neighbours, ControlPointIndex index)
{
    const ControlPointIndex at = neighbours.first(index);
    const Vec3 here = surface.controlPoint(at.i, at.j).position;
    Vec3 sum{0};
    int count = 0;
    for (const Direction direction : {Direction::U, Direction::V}) {
        const auto before = neighbours.previous(at, direction);
        const auto after = neighbours.next(at, direction);
        if (!before || !after)
            continue;  // at a border, which only what lies along it may move
        sum += (surface.controlPoint(before->i, before->j).position - here) +
               (surface.controlPoint(after->i, after->j).position - here);
        count += 2;
    }
    return count > 0 ? sum / static_cast<double>(count) : Vec3(0);
}

std::vector<PointShift> smoothed(const SceneObject& object, const std::vector<Touched>& touched,
                                 const Dab& dab)
{
    const NetNeighbours neighbours(object.surface);
    const glm::dmat3 toModel(object.transform);
    const bool stands = object.transform == Mat4(1.0);
    std::vector<PointShift> shifts;
    for (const Touched& one : touched) {
        const Vec3 way = wayToNeighbours(object.surface, neighbours, one.index);
        shifts.push_back({one.index, dab.strength * one.larger() * (stands ? way : toModel * way)});
    }
    return shifts;
}

std::vector<PointShift> inflated(const SceneObject& object, const std::vector<Touched>& touched,
                                 const Dab& dab)
{
    std::vector<ControlPointIndex> points;
    for (const Touched& one : touched)
        points.push_back(one.index);
    const std::vector<Vec3> normals = normalsAt(object, NetNeighbours(object.surface), points);
    std::vector<PointShift> shifts;
    for (size_t k = 0; k < touched.size(); ++k)
        shifts.push_back({points[k], dab.strength * dab.radius * touched[k].larger() * normals[k]});
    return shifts;
}

Vec3 wayTo(const BestPlane& plane, const Vec3& place)
{
    return plane.normal * glm::dot(plane.normal, plane.point - place);
}

std::vector<PointShift> flattened(const std::vector<Touched>& touched, const Dab& dab)
{
    std::vector<Vec3> places;
    std::vector<double> weights;
    for (const Touched& one : touched)
        if (one.share > 0) {
            places.push_back(one.position);
            weights.push_back(one.share);
        }
    if (places.empty())
        return {};
    const BestPlane plane = bestPlaneOf(places, weights);
    BestPlane image = plane;
    if (dab.mirror)
        image = {mirrored(plane.point, *dab.mirror), reflectionIn(*dab.mirror) * plane.normal};
    std::vector<PointShift> shifts;
    for (const Touched& one : touched)
        shifts.push_back({one.index, nearer(one, dab.strength * one.share * wayTo(plane, one.position),
                                            dab.strength * one.mirrorShare * wayTo(image, one.position))});
    return shifts;
}

Result<void> requireValid(BrushKind brush, const Dab& dab)
{
    if (!(dab.radius > 0) || !std::isfinite(dab.radius))
        return failure("The brush's radius is not above zero", "Make the brush larger");
    const double least = brush == BrushKind::inflate ? -1 : 0;
    if (!(dab.strength >= least && dab.strength <= 1))
        return failure(brush == BrushKind::inflate ? "The brush's strength is not between -1 and 1"
                                                   : "The brush's strength is not between 0 and 1",
                       "Choose another strength");
    return {};
}

}  // namespace

Result<SharedObject> dabbed(const SharedObject& object, BrushKind brush, const Dab& dab)
{
    if (auto valid = requireValid(brush, dab); !valid)
        return tl::unexpected(valid.error());
    const std::vector<Touched> touched = touchedBy(*object, dab);
    switch (brush) {
    case BrushKind::grab:
        return withPointsMoved(object, grabbed(touched, dab));
    case BrushKind::smooth:
        return withPointsMoved(object, smoothed(*object, touched, dab));
    case BrushKind::inflate:
        return withPointsMoved(object, inflated(*object, touched, dab));
    case BrushKind::flatten:
        break;
    }
    return withPointsMoved(object, flattened(touched, dab));
}

Result<Edit> dabbed(const Scene& scene, const std::set<ObjectId>& objects, BrushKind brush, const Dab& dab)
{
    Edit edit;
    for (const ObjectId id : objects) {
        const SharedObject object = scene.find(id);
        if (!object)
            continue;
        auto changed = dabbed(object, brush, dab);
        if (!changed)
            return tl::unexpected(changed.error());
        if (*changed != object)
            edit.set(id, *std::move(changed));
    }
    return edit;
}

}  // namespace knotspan
