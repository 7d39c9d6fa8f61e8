#include "renderer/scene/gpu_scene.h"

#include <algorithm>
#include <cstring>

#include <glm/matrix.hpp>

#include "model/core/check.h"

namespace knotspan {

namespace {

template <class T>
std::span<const T> all(const std::vector<T>& elements)
{
    return elements;
}

// Same records, knots and number of points: only coordinates, weights, colour and transform may differ.
bool sameShape(const NurbsSurface& a, const NurbsSurface& b)
{
    return a.knotsU() == b.knotsU() && a.knotsV() == b.knotsV();
}

// The floats stay good while the object is near the origin it was packed with and its weights are in range.
bool fits(const PointFrame& packed, const NurbsSurface& surface)
{
    const PointFrame now = PointFrame::of(surface);
    const double distance = glm::length(now.origin - packed.origin);
    const double ratio = now.weight / packed.weight;
    return distance + now.extent <= 4.0 * std::max(packed.extent, 1e-30) && ratio < 1e6 && ratio > 1e-6;
}

gpu::SurfaceView viewOf(const GpuScene::Resident& resident, const Camera& camera, const Mat4& rotation)
{
    const Mat4& transform = resident.object->transform;
    const Mat4 inverse = glm::inverse(transform);
    Mat4 toView = rotation * transform;
    toView[3] = rotation * Vec4(transformed(resident.frame.origin, transform) - camera.eye, 1.0);

    gpu::SurfaceView view{};
    view.modelView = gpu::mat4x3(glm::dmat4x3(toView));
    view.eye = camera.orthographic
                   ? gpu::vec4(Vec4(glm::normalize(Vec3(inverse * Vec4(-camera.forward(), 0.0))), 0.0))
                   : gpu::vec4(Vec4(transformed(camera.eye, inverse) - resident.frame.origin, 1.0));
    view.facing = glm::determinant(transform) < 0.0 ? -1.0F : 1.0F;
    return view;
}

}  // namespace

GpuScene::GpuScene(const Device& device, Bindings& bindings, Uploader& uploader)
    : device_(device),
      bindings_(bindings),
      uploader_(uploader)
{
}

void GpuScene::sync(const Scene& scene)
{
    std::vector<std::pair<ObjectId, SharedObject>> visible;
    for (const auto& [id, object] : scene.objects())
        if (object->visible)
            visible.emplace_back(id, object);

    const bool sameObjects = std::equal(visible.begin(), visible.end(), residents_.begin(), residents_.end(),
                                        [](const auto& wanted, const auto& held) {
                                            return wanted.first == held.id &&
                                                   (wanted.second == held.object ||
                                                    sameShape(wanted.second->surface, held.object->surface));
                                        });
    if (!sameObjects) {
        rebuild(visible);
    } else {
        for (size_t k = 0; k < visible.size(); ++k)
            if (visible[k].second != residents_[k].object)
                replace(residents_[k], visible[k].second);
    }
    bounds_ = scene.bounds();
}

void GpuScene::rebuild(const std::vector<std::pair<ObjectId, SharedObject>>& visible)
{
    uploader_.discard();
    residents_.clear();
    views_.clear();
    std::vector<gpu::SurfaceRecord> surfaces;
    std::vector<gpu::KsQuadRecord> ksquads;
    std::vector<float> spanKnots;
    std::vector<gpu::vec4> points;
    for (const auto& [id, object] : visible) {
        const auto surfaceIndex = static_cast<std::uint32_t>(residents_.size());
        const auto firstPoint = static_cast<std::uint32_t>(points.size());
        const auto firstKnot = static_cast<std::uint32_t>(spanKnots.size());
        residents_.push_back({id, object, PointFrame::of(object->surface), firstPoint,
                              static_cast<std::uint32_t>(ksquads.size())});
        const PointFrame& frame = residents_.back().frame;
        PatchTable table = makePatchTable(object->surface);
        for (gpu::KsQuadRecord record : table.ksquads) {
            record.surface = surfaceIndex;
            record.firstPoint += firstPoint;
            record.spanU += firstKnot;
            record.spanV += firstKnot;
            ksquads.push_back(record);
        }
        spanKnots.insert(spanKnots.end(), table.spanKnots.begin(), table.spanKnots.end());
        const auto packed = packPoints(frame, object->surface.controlPoints());
        points.insert(points.end(), packed.begin(), packed.end());
        surfaces.push_back(makeSurfaceRecord(*object, frame, firstPoint));
    }
    ksquadCount_ = static_cast<std::uint32_t>(ksquads.size());

    require(surfaces_, BINDING_SURFACES, surfaces.size() * sizeof(surfaces[0]));
    require(surfaceViews_, BINDING_SURFACE_VIEWS, surfaces.size() * sizeof(gpu::SurfaceView));
    require(ksquads_, BINDING_KSQUADS, ksquads.size() * sizeof(ksquads[0]));
    require(spanKnots_, BINDING_SPAN_KNOTS, spanKnots.size() * sizeof(spanKnots[0]));
    require(controlPoints_, BINDING_CONTROL_POINTS, points.size() * sizeof(points[0]));
    uploader_.write(surfaces_, 0, all(surfaces));
    uploader_.write(ksquads_, 0, all(ksquads));
    uploader_.write(spanKnots_, 0, all(spanKnots));
    uploader_.write(controlPoints_, 0, all(points));
}

void GpuScene::replace(Resident& resident, SharedObject object)
{
    const auto& before = resident.object->surface.controlPoints();
    const auto& after = object->surface.controlPoints();
    auto first = static_cast<size_t>(std::mismatch(before.begin(), before.end(), after.begin()).first -
                                     before.begin());
    auto last = before.size();  // one past the last that differs
    while (last > first && before[last - 1] == after[last - 1])
        --last;
    if (first < last && !fits(resident.frame, object->surface)) {
        resident.frame = PointFrame::of(object->surface);
        first = 0;
        last = after.size();
    }

    const auto held = makeSurfaceRecord(*resident.object, resident.frame, resident.firstPoint);
    const auto wanted = makeSurfaceRecord(*object, resident.frame, resident.firstPoint);
    if (std::memcmp(&held, &wanted, sizeof(held)) != 0)
        uploader_.write(surfaces_, indexOf(resident), std::span(&wanted, 1));
    // Runs of changed points: a row that was pulled in v costs its points, not all between them.
    while (first < last) {
        size_t end = first;
        while (end < last && !(before[end] == after[end]))
            ++end;
        if (end == first)
            ++end;  // only where everything is packed anew
        const auto packed = packPoints(resident.frame, std::span(after).subspan(first, end - first));
        uploader_.write(controlPoints_, resident.firstPoint + first, all(packed));
        first = end;
        while (first < last && before[first] == after[first])
            ++first;
    }
    resident.object = std::move(object);
}

void GpuScene::updateViews(const Camera& camera, const std::vector<ObjectId>& highlighted)
{
    std::vector<gpu::SurfaceView> views;
    views.reserve(residents_.size());
    const Mat4 rotation = camera.rotation();
    for (const Resident& resident : residents_) {
        views.push_back(viewOf(resident, camera, rotation));
        if (std::find(highlighted.begin(), highlighted.end(), resident.id) != highlighted.end())
            views.back().highlight = 1.0F;
    }
    const size_t bytes = views.size() * sizeof(gpu::SurfaceView);
    if (views.size() == views_.size() && std::memcmp(views.data(), views_.data(), bytes) == 0)
        return;
    views_ = std::move(views);
    uploader_.write(surfaceViews_, 0, all(views_));
}

const GpuScene::Resident* GpuScene::find(ObjectId id) const
{
    const auto found =
        std::lower_bound(residents_.begin(), residents_.end(), id,
                         [](const Resident& resident, ObjectId wanted) { return resident.id < wanted; });
    return found != residents_.end() && found->id == id ? &*found : nullptr;
}

GpuScene::KsQuadName GpuScene::nameOf(std::uint32_t ksquad) const
{
    check(ksquad < ksquadCount_, "the KSQuad is one of the scene");
    const auto next =
        std::upper_bound(residents_.begin(), residents_.end(), ksquad,
                         [](std::uint32_t k, const Resident& resident) { return k < resident.firstKsquad; });
    const Resident& resident = *(next - 1);
    const auto& spansU = resident.object->surface.knotsU().spans();
    const auto& spansV = resident.object->surface.knotsV().spans();
    const size_t local = ksquad - resident.firstKsquad;
    return {resident.id, {spansU[local / spansV.size()], spansV[local % spansV.size()]}};
}

std::uint32_t GpuScene::numberOf(const KsQuadName& name) const
{
    const Resident* resident = find(name.object);
    check(resident != nullptr, "the object is on the device");
    const auto& spansU = resident->object->surface.knotsU().spans();
    const auto& spansV = resident->object->surface.knotsV().spans();
    const auto a = std::lower_bound(spansU.begin(), spansU.end(), name.ksquad.spanU) - spansU.begin();
    const auto b = std::lower_bound(spansV.begin(), spansV.end(), name.ksquad.spanV) - spansV.begin();
    return resident->firstKsquad +
           static_cast<std::uint32_t>(static_cast<size_t>(a) * spansV.size() + static_cast<size_t>(b));
}

void GpuScene::require(Buffer& buffer, int binding, VkDeviceSize bytes)
{
    if (bytes > device_.limits().maxStorageBufferRange)
        throw VulkanError({"The model needs a buffer of " + std::to_string(bytes >> 20U) + " MB and " +
                               device_.name() + " takes at most " +
                               std::to_string(device_.limits().maxStorageBufferRange >> 20U),
                           {},
                           "Hide or remove some objects, or choose another device with --device"});
    if (buffer.bytes() >= bytes && buffer.bytes() > 0 && buffer.bytes() / 4 <= bytes)
        return;
    buffer = {};  // first, so that both never live at once
    buffer = Buffer(device_, std::max<VkDeviceSize>(bytes, 256), Buffer::Place::device);
    bindings_.set(binding, buffer);
}

}  // namespace knotspan
