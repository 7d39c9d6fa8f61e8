// What of a scene is other than what the device has.
#include <algorithm>
#include <cstring>

#include <tbb/parallel_for.h>

#include "renderer/scene/gpu_scene.h"

namespace knotspan {

namespace {

template <class T>
std::span<const T> all(const std::vector<T>& elements)
{
    return elements;
}

// The floats stay good while the object is, for its size, near the origin that it was packed with and its
// weights are in range.
bool fits(const PointFrame& packed, const NurbsSurface& surface)
{
    const PointFrame now = PointFrame::of(surface);
    const double distance = glm::length(now.origin - packed.origin);
    const double ratio = now.weight / packed.weight;
    return distance <= 3.0 * now.extent && ratio < 1e6 && ratio > 1e-6;
}

}  // namespace

void GpuScene::sync(const Scene& scene, Joins joins)
{
    if (const auto changed = changesTo(scene))
        replace(scene, *changed, joins);
    else
        rebuild(visibleObjects(scene));
    held_ = scene;
    meshBox_ = {};
    for (const auto& [id, mesh] : scene.meshes())
        if (mesh->visible)
            meshBox_.add(mesh->bounds());
}

std::optional<std::vector<size_t>> GpuScene::changesTo(const Scene& scene) const
{
    if (auto ids = scene.changedSince(held_))
        return exchangedIn(scene, std::move(*ids));
    const VisibleObjects visible = visibleObjects(scene);
    if (visible.size() != residents_.size())
        return std::nullopt;
    std::vector<size_t> changed;
    for (size_t k = 0; k < visible.size(); ++k) {
        const auto& [id, object] = visible[k];
        if (id != residents_[k].id || !isSameShape(*object, *residents_[k].object))
            return std::nullopt;
        if (object != residents_[k].object)
            changed.push_back(k);
    }
    return changed;
}

// All others are those on the device.
std::optional<std::vector<size_t>> GpuScene::exchangedIn(const Scene& scene, std::vector<ObjectId> ids) const
{
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    std::vector<size_t> changed;
    for (const ObjectId id : ids) {
        const SharedObject object = scene.find(id);
        const Resident* const resident = find(id);
        const bool shows = object != nullptr && object->visible;
        if (shows != (resident != nullptr))
            return std::nullopt;
        if (!shows || object == resident->object)
            continue;
        if (!isSameShape(*object, *resident->object))
            return std::nullopt;
        changed.push_back(indexOf(*resident));
    }
    return changed;
}

// `changed` are increasing.
void GpuScene::replace(const Scene& scene, const std::vector<size_t>& changed, Joins joins)
{
    std::vector<Change> changes;
    for (const size_t k : changed) {
        changes.push_back({k, std::exchange(residents_[k].object, scene.find(residents_[k].id))});
        boxes_.set(k, residents_[k].object->bounds());
        log_.add(static_cast<std::uint32_t>(k));
    }
    tbb::parallel_for(size_t{0}, changes.size(), [&](size_t k) { lookAt(changes[k]); });
    if (withNets_)
        for (const Change& change : changes)
            sendChangedPoints(change);
    if (packing_ == Packing::bezier)
        sendRuns(
            changes, [](const Change& change) { return change.moved; },
            [&](size_t first, size_t end) {
                const size_t start = beziers_.firstPoint(first);
                const size_t count = beziers_.firstPoint(end) - start;
                beziers_.make(residents_, first, end,
                              uploader_.room<glm::vec4>(controlPoints_, start, count));
            });
    sendRuns(
        changes, [](const Change& change) { return change.recordDiffers; },
        [&](size_t first, size_t end) {
            uploader_.write(surfaces_, first, all(records_).subspan(first, end - first));
        });
    for (const Change& change : changes)
        unsearched_.insert(change.index);
    if (joins == Joins::anew)
        updateBorders();
}

// Threads may look at different ones at once.
void GpuScene::lookAt(Change& change)
{
    Resident& resident = residents_[change.index];
    const NurbsSurface& surface = resident.object->surface;
    change.moved = change.before->surface.controlPoints() != surface.controlPoints();
    if (change.moved && !fits(resident.frame, surface)) {
        resident.frame = PointFrame::of(surface);
        change.framed = true;
    }
    const gpu::SurfaceRecord wanted = recordOf(resident);
    change.recordDiffers = std::memcmp(&records_[change.index], &wanted, sizeof(wanted)) != 0;
    records_[change.index] = wanted;
}

void GpuScene::sendChangedPoints(const Change& change)
{
    const Resident& resident = residents_[change.index];
    const auto& before = change.before->surface.controlPoints();
    const auto& after = resident.object->surface.controlPoints();
    const size_t start = beziers_.pointCount() + resident.firstPoint;
    // Runs of changed points: a row that was pulled along v costs its points, not all between them.
    for (size_t first = 0; change.moved && first < after.size();) {
        size_t end = first;
        while (end < after.size() && (change.framed || !(before[end] == after[end])))
            ++end;
        const auto packed = packPoints<float>(resident.frame, std::span(after).subspan(first, end - first));
        uploader_.write(controlPoints_, start + first, all(packed));
        first = end + 1;
    }
}

// send(first, end) for each run of surfaces that lie beside each other and satisfy the test.
template <class Test, class Send>
void GpuScene::sendRuns(const std::vector<Change>& changes, const Test& test, const Send& sendOne)
{
    for (size_t first = 0; first < changes.size();) {
        size_t end = first;
        while (end < changes.size() && test(changes[end]) &&
               changes[end].index == changes[first].index + (end - first))
            ++end;
        if (end > first)
            sendOne(changes[first].index, changes[end - 1].index + 1);
        first = std::max(end, first + 1);
    }
}

void GpuScene::updateBorders()
{
    std::vector<CoincidentEdges::Change> moved;
    for (const size_t index : std::exchange(unsearched_, {}))
        moved.push_back({static_cast<std::uint32_t>(index), placedSurface(*residents_[index].object)});
    const auto changes = edges_.update(moved);
    if (changes && changes->before) {
        sendBorders(*changes->before);
    } else if (changes) {
        for (const std::uint32_t side : changes->sides)
            uploader_.write(borderSides_, side, all(edges_.tables().sides).subspan(side, 1));
        for (const std::uint32_t corner : changes->corners)
            uploader_.write(borderCorners_, corner, all(edges_.tables().corners).subspan(corner, 1));
    }
}

}  // namespace knotspan
