#include "model/sculpting/point_selection.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "model/core/check.h"

namespace knotspan {

namespace {

using Points = std::vector<ControlPointIndex>;

Points allOf(NetSize net)
{
    Points points;
    points.reserve(net.count());
    for (size_t place = 0; place < net.count(); ++place)
        points.push_back(net.indexAt(place));
    return points;
}

std::vector<char> marksOf(const SelectedPoints& selected)
{
    std::vector<char> marks(selected.net.count(), 0);
    for (const ControlPointIndex index : selected.points)
        marks[selected.net.place(index)] = 1;
    return marks;
}

// Calls visit(neighbour) for those that the net has.
template <class Visit>
void forNeighbours(NetSize net, ControlPointIndex index, const Visit& visit)
{
    for (const ControlPointIndex other : {ControlPointIndex{index.i - 1, index.j},
                                          {index.i, index.j - 1},
                                          {index.i, index.j + 1},
                                          {index.i + 1, index.j}})
        if (net.contains(other))
            visit(other);
}

// Points of each object by choose(its selected points).
template <class Choose>
PointSelection byObject(const PointSelection& selection, const Choose& choose)
{
    PointSelection result;
    for (const auto& [id, selected] : selection.objects())
        result.add(PointSelection(id, selected.net, choose(selected)));
    return result;
}

}  // namespace

PointSelection::PointSelection(ObjectId object, NetSize net, std::vector<ControlPointIndex> points)
{
    check(std::all_of(points.begin(), points.end(), [&](auto index) { return net.contains(index); }),
          "selected control points lie inside their net");
    if (points.empty())
        return;
    if (!std::is_sorted(points.begin(), points.end(), comesBefore))
        std::sort(points.begin(), points.end(), comesBefore);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    objects_.emplace(object, SelectedPoints{net, std::move(points)});
}

size_t PointSelection::size() const
{
    size_t size = 0;
    for (const auto& [id, selected] : objects_)
        size += selected.points.size();
    return size;
}

bool PointSelection::contains(const ScenePoint& point) const
{
    const auto found = objects_.find(point.object);
    return found != objects_.end() &&
           std::binary_search(found->second.points.begin(), found->second.points.end(), point.index,
                              comesBefore);
}

template <class Combine>
void PointSelection::combine(const PointSelection& others, const Combine& combine)
{
    for (const auto& [id, other] : others.objects_) {
        SelectedPoints& mine = objects_[id];
        if (mine.net != other.net)
            mine = {other.net, {}};
        Points result;
        combine(mine.points, other.points, std::back_inserter(result));
        mine.points = std::move(result);
        if (mine.points.empty())
            objects_.erase(id);
    }
}

void PointSelection::add(const PointSelection& others)
{
    combine(others, [](const Points& a, const Points& b, auto result) {
        std::set_union(a.begin(), a.end(), b.begin(), b.end(), result, comesBefore);
    });
}

void PointSelection::remove(const PointSelection& others)
{
    combine(others, [](const Points& a, const Points& b, auto result) {
        std::set_difference(a.begin(), a.end(), b.begin(), b.end(), result, comesBefore);
    });
}

void PointSelection::toggle(const PointSelection& others)
{
    combine(others, [](const Points& a, const Points& b, auto result) {
        std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), result, comesBefore);
    });
}

void PointSelection::keepOnly(const Scene& scene)
{
    std::erase_if(objects_, [&](const auto& entry) {
        const SharedObject object = scene.find(entry.first);
        return !object || netSizeOf(object->surface) != entry.second.net;
    });
}

PointSelection pointOf(const Scene& scene, const ScenePoint& point)
{
    const SharedObject object = scene.find(point.object);
    if (!object || !netSizeOf(object->surface).contains(point.index))
        return {};
    return {point.object, netSizeOf(object->surface), {point.index}};
}

PointSelection rowOf(const Scene& scene, ObjectId object, int i)
{
    const SharedObject found = scene.find(object);
    if (!found || i < 0 || i >= found->surface.countU())
        return {};
    Points points;
    for (int j = 0; j < found->surface.countV(); ++j)
        points.push_back({i, j});
    return {object, netSizeOf(found->surface), std::move(points)};
}

PointSelection columnOf(const Scene& scene, ObjectId object, int j)
{
    const SharedObject found = scene.find(object);
    if (!found || j < 0 || j >= found->surface.countV())
        return {};
    Points points;
    for (int i = 0; i < found->surface.countU(); ++i)
        points.push_back({i, j});
    return {object, netSizeOf(found->surface), std::move(points)};
}

PointSelection netOf(const Scene& scene, ObjectId object)
{
    const SharedObject found = scene.find(object);
    if (!found)
        return {};
    return {object, netSizeOf(found->surface), allOf(netSizeOf(found->surface))};
}

PointSelection grown(const PointSelection& selection)
{
    return byObject(selection, [](const SelectedPoints& selected) {
        std::vector<char> marks = marksOf(selected);
        Points points = selected.points;
        for (const ControlPointIndex index : selected.points)
            forNeighbours(selected.net, index, [&](ControlPointIndex other) {
                if (std::exchange(marks[selected.net.place(other)], 1) == 0)
                    points.push_back(other);
            });
        return points;
    });
}

PointSelection shrunk(const PointSelection& selection)
{
    return byObject(selection, [](const SelectedPoints& selected) {
        const std::vector<char> marks = marksOf(selected);
        Points points;
        for (const ControlPointIndex index : selected.points) {
            bool inside = true;
            forNeighbours(selected.net, index, [&](ControlPointIndex other) {
                inside = inside && marks[selected.net.place(other)] != 0;
            });
            if (inside)
                points.push_back(index);
        }
        return points;
    });
}

PointSelection inverted(const PointSelection& selection)
{
    PointSelection result = byObject(selection, [](const SelectedPoints& of) { return allOf(of.net); });
    result.remove(selection);
    return result;
}

PointSelection inverted(const PointSelection& selection, const Scene& scene,
                        const std::set<ObjectId>& objects)
{
    PointSelection kept = selection;
    kept.keepOnly(scene);
    PointSelection result;
    for (const ObjectId id : objects)
        result.add(netOf(scene, id));
    for (const auto& [id, selected] : kept.objects())
        if (objects.count(id) != 0)
            result.remove(PointSelection(id, selected.net, selected.points));
    return result;
}

}  // namespace knotspan
