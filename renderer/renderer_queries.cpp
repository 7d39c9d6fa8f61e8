// What a Renderer answers beside pictures: what is under a pixel, and what its stages computed.
#include <algorithm>

#include "model/core/check.h"
#include "renderer/renderer_parts.h"

namespace knotspan {

Pick Renderer::Parts::pick(double x, double y, double radiusPx)
{
    Pick result;
    if (!lastFrame || !targets)
        return result;
    result.controlPoint = nearestControlPoint({x, y}, radiusPx);
    if (x < 0 || y < 0 || x >= targets->extent().width || y >= targets->extent().height)
        return result;
    const std::uint32_t surface =
        targets->surfaceAt(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
    // The scene may have been synchronized with fewer objects since that picture.
    if (surface > 0 && surface <= scene.residents().size())
        result.object = scene.residents()[surface - 1].id;
    return result;
}

std::optional<PickedControlPoint> Renderer::Parts::nearestControlPoint(const Vec2& pixel,
                                                                       double radiusPx) const
{
    const Frame& frame = *lastFrame;
    std::optional<PickedControlPoint> nearest;
    double nearestDistance = radiusPx;
    double nearestDepth = 0;
    const auto look = [&](const GpuScene::Resident& resident) {
        const NurbsSurface& surface = resident.object->surface;
        for (int i = 0; i < surface.countU(); ++i)
            for (int j = 0; j < surface.countV(); ++j) {
                const Vec3 point =
                    transformed(surface.controlPoint(i, j).position, resident.object->transform);
                const auto at = frame.camera.toPixel(point, frame.width, frame.height);
                const double distance = at ? glm::length(*at - pixel) : radiusPx + 1;
                const double depth = glm::dot(point - frame.camera.eye, frame.camera.forward());
                // Among points that fall on the same pixel, the one in front.
                const bool same = nearest && std::abs(distance - nearestDistance) < 0.5;
                if (distance > radiusPx ||
                    (same ? depth >= nearestDepth : distance >= nearestDistance && nearest))
                    continue;
                nearest = PickedControlPoint{resident.id, {i, j}};
                nearestDistance = distance;
                nearestDepth = depth;
            }
    };
    if (frame.overlays.controlNets) {
        std::for_each(scene.residents().begin(), scene.residents().end(), look);
    } else {
        for (const ObjectId id : frame.overlays.netsOf)
            if (const auto* resident = scene.find(id))
                look(*resident);
    }
    return nearest;
}

std::vector<CapturedVertex> Renderer::Parts::captureVertices(const Frame& frame)
{
    // Once to count the vertices, once to note them down.
    counters.reserveCapture(0);
    (void)draw(frame, true);
    const std::uint32_t count = counters.read().captured;
    counters.reserveCapture(count);
    (void)draw(frame, true);
    auto vertices = named(counters.readCapture(counters.read().captured));
    counters.reserveCapture(0);
    return vertices;
}

std::vector<CapturedVertex> Renderer::Parts::evaluate(const std::vector<EvaluationPoint>& points)
{
    if (points.empty())
        return {};
    if (evaluate_.get() == VK_NULL_HANDLE)
        evaluate_ = makeComputePipeline(device, bindings, "evaluate.comp");
    std::vector<gpu::RequestRecord> requests;
    for (const EvaluationPoint& point : points)
        requests.push_back({scene.numberOf({point.object, {point.spanU, point.spanV}}),
                            {static_cast<float>(point.u), static_cast<float>(point.v)}});
    const auto count = static_cast<std::uint32_t>(requests.size());
    requests_ = {};
    requests_ = Buffer(device, count * sizeof(requests[0]), Buffer::Place::device);
    bindings.set(BINDING_REQUESTS, requests_);
    uploader.write(requests_, 0, std::span<const gpu::RequestRecord>(requests));
    counters.reserveCapture(count);
    gpu::FrameRecord record{};
    record.captureCapacity = count;
    uploadRecord(record);
    device.execute([&](VkCommandBuffer commands) {
        uploader.flush(commands);
        bindings.bind(commands, VK_PIPELINE_BIND_POINT_COMPUTE);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, evaluate_.get());
        vkCmdDispatch(commands, (count + EVALUATE_THREADS - 1) / EVALUATE_THREADS, 1, 1);
    });
    auto vertices = named(counters.readCapture(count));
    counters.reserveCapture(0);
    return vertices;
}

std::vector<CapturedVertex> Renderer::Parts::named(const std::vector<gpu::CapturedRecord>& records) const
{
    std::vector<CapturedVertex> vertices;
    vertices.reserve(records.size());
    for (const gpu::CapturedRecord& record : records) {
        const GpuScene::KsQuadName name = scene.nameOf(record.ksquad);
        vertices.push_back({name.object, name.ksquad.spanU, name.ksquad.spanV, record.t.x, record.t.y,
                            Vec3(record.position), Vec3(record.normal)});
    }
    return vertices;
}

}  // namespace knotspan
