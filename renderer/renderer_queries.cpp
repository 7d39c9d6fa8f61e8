// What a Renderer answers beside pictures: what its stages computed, and what lies on the device.
#include <glm/matrix.hpp>

#include "renderer/renderer_parts.h"

namespace knotspan {

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
    meshes.listMemory(held);
    facing.listMemory(held);
    culling.listMemory(held);
    pyramid.listMemory(held);
    trimEdges.listMemory(held);
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
