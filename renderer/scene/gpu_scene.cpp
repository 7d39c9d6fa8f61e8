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

// The floats stay good while the object is, for its size, near the origin that it was packed with and its
// weights are in range.
bool fits(const PointFrame& packed, const NurbsSurface& surface)
{
    const PointFrame now = PointFrame::of(surface);
    const double distance = glm::length(now.origin - packed.origin);
    const double ratio = now.weight / packed.weight;
    return distance <= 3.0 * now.extent && ratio < 1e6 && ratio > 1e-6;
}

gpu::SurfaceView viewOf(const Resident& resident, const Camera& camera, const Mat4& rotation)
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
    const VisibleObjects visible = visibleObjects(scene);
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

void GpuScene::rebuild(const VisibleObjects& visible)
{
    auto packed = packScene<float>(makeResidents(visible), evaluator_);
    // Where the device refuses, nothing is left that looks as if it were there.
    forget();
    provide(surfaceViews_, BINDING_SURFACE_VIEWS, packed.surfaces.size() * sizeof(gpu::SurfaceView));
    send(surfaces_, BINDING_SURFACES, packed.surfaces);
    sendTables(packed.tables);
    send(controlPoints_, BINDING_CONTROL_POINTS, packed.points);
    residents_ = std::move(packed.residents);
    ksquadCount_ = static_cast<std::uint32_t>(packed.tables.ksquads.size());
    rebuilt_ = true;
}

void GpuScene::useEvaluator(Evaluator evaluator)
{
    if (evaluator == evaluator_)
        return;
    evaluator_ = evaluator;
    const auto tables = packTables<float>(residents_, evaluator);
    // Where the device refuses, nothing is left that looks as if it were there.
    auto residents = std::exchange(residents_, {});
    ksquadCount_ = 0;
    sendTables(tables);
    residents_ = std::move(residents);
    ksquadCount_ = static_cast<std::uint32_t>(tables.ksquads.size());
}

void GpuScene::sendTables(const PackedTables<float>& tables)
{
    send(ksquads_, BINDING_KSQUADS, tables.ksquads);
    send(spanTables_, BINDING_SPAN_TABLES, tables.spanTables);
}

void GpuScene::replace(Resident& resident, SharedObject object)
{
    const auto& before = resident.object->surface.controlPoints();
    const auto& after = object->surface.controlPoints();
    const auto held = makeSurfaceRecord(*resident.object, resident.frame, resident.firstPoint);
    if (before != after && !fits(resident.frame, object->surface)) {
        resident.frame = PointFrame::of(object->surface);
        const auto packed = packPoints<float>(resident.frame, after);
        uploader_.write(controlPoints_, resident.firstPoint, all(packed));
    } else {
        // Runs of changed points: a row that was pulled along v costs its points, not all between them.
        for (size_t first = 0; first < after.size();) {
            size_t end = first;
            while (end < after.size() && !(before[end] == after[end]))
                ++end;
            const auto packed =
                packPoints<float>(resident.frame, std::span(after).subspan(first, end - first));
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
