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

GpuScene::GpuScene(Bindings& bindings, Uploader& uploader) : bindings_(bindings), uploader_(uploader) {}

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

GpuScene::Packed GpuScene::pack(const std::vector<std::pair<ObjectId, SharedObject>>& visible)
{
    Packed packed;
    for (const auto& [id, object] : visible) {
        const auto surface = static_cast<std::uint32_t>(packed.residents.size());
        const auto firstPoint = static_cast<std::uint32_t>(packed.points.size());
        const auto firstKnot = static_cast<std::uint32_t>(packed.spanKnots.size());
        const PointFrame frame = PointFrame::of(object->surface);
        packed.residents.push_back(
            {id, object, frame, firstPoint, static_cast<std::uint32_t>(packed.ksquads.size())});
        const PatchTable table = makePatchTable(object->surface);
        for (gpu::KsQuadRecord record : table.ksquads) {
            record.surface = surface;
            record.firstPoint += firstPoint;
            record.spanU += firstKnot;
            record.spanV += firstKnot;
            packed.ksquads.push_back(record);
        }
        packed.spanKnots.insert(packed.spanKnots.end(), table.spanKnots.begin(), table.spanKnots.end());
        const auto points = packPoints(frame, object->surface.controlPoints());
        packed.points.insert(packed.points.end(), points.begin(), points.end());
        packed.surfaces.push_back(makeSurfaceRecord(*object, frame, firstPoint));
    }
    return packed;
}

void GpuScene::rebuild(const std::vector<std::pair<ObjectId, SharedObject>>& visible)
{
    Packed packed = pack(visible);
    // Where the device refuses, nothing is left that looks as if it were there.
    residents_.clear();
    views_.clear();
    ksquadCount_ = 0;
    provide(surfaceViews_, BINDING_SURFACE_VIEWS, packed.surfaces.size() * sizeof(gpu::SurfaceView));
    send(surfaces_, BINDING_SURFACES, packed.surfaces);
    send(ksquads_, BINDING_KSQUADS, packed.ksquads);
    send(spanKnots_, BINDING_SPAN_KNOTS, packed.spanKnots);
    send(controlPoints_, BINDING_CONTROL_POINTS, packed.points);
    residents_ = std::move(packed.residents);
    ksquadCount_ = static_cast<std::uint32_t>(packed.ksquads.size());
    rebuilt_ = true;
}

void GpuScene::replace(Resident& resident, SharedObject object)
{
    const auto& before = resident.object->surface.controlPoints();
    const auto& after = object->surface.controlPoints();
    const auto held = makeSurfaceRecord(*resident.object, resident.frame, resident.firstPoint);
    if (before != after && !fits(resident.frame, object->surface)) {
        resident.frame = PointFrame::of(object->surface);
        const auto packed = packPoints(resident.frame, after);
        uploader_.write(controlPoints_, resident.firstPoint, all(packed));
    } else {
        // Runs of changed points: a row that was pulled along v costs its points, not all between them.
        for (size_t first = 0; first < after.size();) {
            size_t end = first;
            while (end < after.size() && !(before[end] == after[end]))
                ++end;
            const auto packed = packPoints(resident.frame, std::span(after).subspan(first, end - first));
            uploader_.write(controlPoints_, resident.firstPoint + first, all(packed));
            first = end + 1;
        }
    }
    const auto wanted = makeSurfaceRecord(*object, resident.frame, resident.firstPoint);
    if (std::memcmp(&held, &wanted, sizeof(held)) != 0)
        uploader_.write(surfaces_, indexOf(resident), std::span(&wanted, 1));
    resident.object = std::move(object);
}

void GpuScene::forget()
{
    residents_.clear();
    views_.clear();
    ksquadCount_ = 0;
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
    if (views.size() == views_.size() &&
        (views.empty() || std::memcmp(views.data(), views_.data(), bytes) == 0))
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

std::optional<std::uint32_t> GpuScene::numberOf(const KsQuadName& name) const
{
    const Resident* resident = find(name.object);
    if (resident == nullptr)
        return std::nullopt;
    const auto& spansU = resident->object->surface.knotsU().spans();
    const auto& spansV = resident->object->surface.knotsV().spans();
    const auto u = std::lower_bound(spansU.begin(), spansU.end(), name.ksquad.spanU);
    const auto v = std::lower_bound(spansV.begin(), spansV.end(), name.ksquad.spanV);
    if (u == spansU.end() || *u != name.ksquad.spanU || v == spansV.end() || *v != name.ksquad.spanV)
        return std::nullopt;
    return resident->firstKsquad +
           static_cast<std::uint32_t>(static_cast<size_t>(u - spansU.begin()) * spansV.size() +
                                      static_cast<size_t>(v - spansV.begin()));
}

void GpuScene::provide(Buffer& buffer, int binding, VkDeviceSize bytes)
{
    uploader_.forget(buffer);
    bindings_.provide(binding, buffer, bytes);
}

template <class T>
void GpuScene::send(Buffer& buffer, int binding, const std::vector<T>& elements)
{
    provide(buffer, binding, elements.size() * sizeof(T));
    uploader_.write(buffer, 0, all(elements));
}

}  // namespace knotspan
