// What a Renderer answers beside pictures: what is under a pixel, and what its stages computed.
#include <algorithm>

#include <glm/matrix.hpp>

#include "renderer/renderer_parts.h"

namespace knotspan {

Pick Renderer::Parts::pick(double x, double y, double radiusPx)
{
    Pick result;
    if (!lastFrame)
        return result;
    result.controlPoint = nearestControlPoint({x, y}, radiusPx);
    if (x < 0 || y < 0 || x >= targets->extent().width || y >= targets->extent().height)
        return result;
    const std::uint32_t ksquad =
        targets->ksquadAt(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
    const auto after = std::lower_bound(lastFirstKsquads.begin(), lastFirstKsquads.end(), ksquad);
    if (after != lastFirstKsquads.begin())
        result.object = lastObjects[static_cast<size_t>(after - lastFirstKsquads.begin()) - 1];
    return result;
}

std::optional<PickedControlPoint> Renderer::Parts::nearestControlPoint(const Vec2& pixel,
                                                                       double radiusPx) const
{
    const Frame& frame = *lastFrame;
    std::optional<PickedControlPoint> nearest;
    double nearestDistance = radiusPx;
    double nearestDepth = 0;
    const PixelProjection toPixel(frame.camera, frame.width, frame.height);
    const Vec3 forward = frame.camera.forward();
    const auto look = [&](const Resident& resident) {
        const NurbsSurface& surface = resident.object->surface;
        for (int i = 0; i < surface.countU(); ++i)
            for (int j = 0; j < surface.countV(); ++j) {
                const Vec3 point =
                    transformed(surface.controlPoint(i, j).position, resident.object->transform);
                const auto at = toPixel(point);
                const double distance = at ? glm::length(*at - pixel) : radiusPx + 1;
                const double depth = glm::dot(point - frame.camera.eye, forward);
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

Evaluations Renderer::Parts::evaluate(const std::vector<EvaluationPoint>& points,
                                      const EvaluationOptions& options)
{
    if (!sceneIsHeld_)
        sync(Scene(wanted_));
    const Evaluator evaluator = chosenEvaluator(options.evaluator, largestDegree_, options.precision);
    if (!pointEvaluation_)
        pointEvaluation_ = std::make_unique<PointEvaluation>(device, clock);
    if (options.precision == Precision::float64)
        return pointEvaluation_->evaluate<double>(scene.residents(), points, evaluator, options.repeats);
    return pointEvaluation_->evaluate<float>(scene.residents(), points, evaluator, options.repeats);
}

std::vector<HeldMemory> Renderer::Parts::memory() const
{
    std::vector<HeldMemory> held;
    scene.listMemory(held);
    facing.listMemory(held);
    culling.listMemory(held);
    pyramid.listMemory(held);
    if (noted_)
        held.push_back({"culling verdicts", verdicts_.bytes()});
    sampling.listMemory(held);
    return held;
}

std::vector<CapturedVertex> Renderer::Parts::named(const std::vector<gpu::CapturedRecord>& records) const
{
    std::vector<CapturedVertex> vertices;
    vertices.reserve(records.size());
    for (const gpu::CapturedRecord& record : records) {
        const KsQuadName name = ksquadName(scene.residents(), record.ksquad);
        const ObjectId source = ksquadName(scene.residents(), record.source).object;
        Vec3 position(record.position);
        if (source != name.object) {
            const Resident& from = *scene.find(source);
            const Resident& to = *scene.find(name.object);
            const Vec3 place = transformed(from.frame.origin + position, from.object->transform);
            position = transformed(place, glm::inverse(to.object->transform)) - to.frame.origin;
        }
        vertices.push_back({name.object, name.ksquad.spanU, name.ksquad.spanV, record.t.x, record.t.y,
                            position, Vec3(record.normal), Vec4(record.clip)});
    }
    return vertices;
}

}  // namespace knotspan
