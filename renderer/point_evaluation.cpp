#include "renderer/point_evaluation.h"

#include <algorithm>
#include <cstring>

#include "model/core/spread.h"

namespace knotspan {

namespace {

constexpr size_t kBatch = 1 << 18;  // points; in double 31 MB of requests and results

template <class Real>
std::vector<gpu::RequestRecord<Real>> requestsFor(const std::vector<Resident>& residents,
                                                  const std::vector<EvaluationPoint>& points)
{
    std::vector<gpu::RequestRecord<Real>> requests;
    requests.reserve(points.size());
    for (const EvaluationPoint& point : points) {
        const auto ksquad = ksquadNumber(residents, {point.object, {point.spanU, point.spanV}});
        if (!ksquad)
            throw VulkanError(
                {"There is no such KSQuad on the device", {}, "Ask for one of a visible object"});
        requests.push_back({*ksquad, {static_cast<Real>(point.u), static_cast<Real>(point.v)}});
    }
    return requests;
}

}  // namespace

PointEvaluation::PointEvaluation(const Device& device, GpuClock& clock)
    : device_(device),
      clock_(clock),
      bindings_(device),
      uploader_(device)
{
}

template <class Real>
Evaluations PointEvaluation::evaluate(const std::vector<Resident>& residents,
                                      const std::vector<EvaluationPoint>& points, Evaluator evaluator,
                                      int repeats)
{
    constexpr bool kDouble = sizeof(Real) == sizeof(double);
    if (kDouble && !device_.abilities().noDouble.empty())
        throw VulkanError({device_.abilities().noDouble, {}, "Evaluate in float"});
    Evaluations result{evaluator, {}, 0};
    if (points.empty())
        return result;
    const auto requests = requestsFor<Real>(residents, points);
    const VkPipeline pipeline = pipelineFor(evaluator, kDouble ? Precision::float64 : Precision::float32);
    result.points.reserve(points.size());
    try {
        sendScene(packScene<Real>(residents, evaluator));
        for (size_t first = 0; first < requests.size(); first += kBatch) {
            const auto batch = std::span(requests).subspan(first, std::min(kBatch, requests.size() - first));
            result.gpuMs += evaluateBatch<Real>(pipeline, batch, std::max(repeats, 1), result.points);
        }
    } catch (...) {
        uploader_.forgetAll();
        throw;
    }
    giveBack();
    return result;
}

VkPipeline PointEvaluation::pipelineFor(Evaluator evaluator, Precision precision)
{
    Pipeline& pipeline = pipelines_[{evaluator, precision}];
    if (pipeline.get() == VK_NULL_HANDLE)
        pipeline = makeComputePipeline(
            device_, bindings_, precision == Precision::float64 ? "evaluate_double.comp" : "evaluate.comp",
            {.evaluator = static_cast<std::uint32_t>(evaluator)});
    return pipeline.get();
}

template <class Real>
void PointEvaluation::sendScene(const PackedScene<Real>& packed)
{
    send(BINDING_SURFACES, surfaces_, std::span(packed.surfaces));
    send(BINDING_KSQUADS, ksquads_, std::span(packed.tables.ksquads));
    send(BINDING_SPAN_TABLES, spanTables_, std::span(packed.tables.spanTables));
    send(BINDING_CONTROL_POINTS, controlPoints_, std::span(packed.points));
}

template <class Real>
double PointEvaluation::evaluateBatch(VkPipeline pipeline, std::span<const gpu::RequestRecord<Real>> requests,
                                      int repeats, std::vector<EvaluatedPoint>& to)
{
    using Evaluated = gpu::EvaluatedRecord<Real>;
    gpu::FrameRecord frame{};
    frame.captureCapacity = static_cast<std::uint32_t>(requests.size());
    send(BINDING_FRAME, frame_, std::span<const gpu::FrameRecord>(&frame, 1));
    send(BINDING_REQUESTS, requests_, requests);
    const VkDeviceSize bytes = requests.size() * sizeof(Evaluated);
    bindings_.provide(BINDING_CAPTURED, evaluated_, bytes);
    const Buffer readBack(device_, bytes, Buffer::Place::readBack);
    const GroupCount groups = groupsFor(frame.captureCapacity, EVALUATE_THREADS);
    std::vector<double> milliseconds;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        device_.execute([&](VkCommandBuffer commands) {
            (void)uploader_.record(commands);
            bindings_.bind(commands, VK_PIPELINE_BIND_POINT_COMPUTE);
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
            clock_.start(commands);
            vkCmdDispatch(commands, groups.x, groups.y, 1);
            clock_.stop(commands);
            if (repeat + 1 < repeats)
                return;
            memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                          VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, VK_PIPELINE_STAGE_2_TRANSFER_BIT,
                          VK_ACCESS_2_TRANSFER_READ_BIT);
            const VkBufferCopy region{0, 0, bytes};
            vkCmdCopyBuffer(commands, evaluated_.get(), readBack.get(), 1, &region);
            memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                          VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
        });
        uploader_.sent();
        milliseconds.push_back(clock_.milliseconds());
    }
    for (size_t k = 0; k < requests.size(); ++k) {
        Evaluated at;
        std::memcpy(&at, readBack.mapped() + k * sizeof(at), sizeof(at));
        to.push_back({Vec3(at.position), Vec3(at.du), Vec3(at.dv), Vec3(at.normal)});
    }
    return spreadOf(std::move(milliseconds)).median;
}

template <class T>
void PointEvaluation::send(int binding, Buffer& buffer, std::span<const T> elements)
{
    uploader_.forget(buffer);
    bindings_.provide(binding, buffer, elements.size_bytes());
    uploader_.write(buffer, 0, elements);
}

void PointEvaluation::giveBack()
{
    bindings_.provide(BINDING_SURFACES, surfaces_, 0);
    bindings_.provide(BINDING_KSQUADS, ksquads_, 0);
    bindings_.provide(BINDING_SPAN_TABLES, spanTables_, 0);
    bindings_.provide(BINDING_CONTROL_POINTS, controlPoints_, 0);
    bindings_.provide(BINDING_REQUESTS, requests_, 0);
    bindings_.provide(BINDING_CAPTURED, evaluated_, 0);
}

template Evaluations PointEvaluation::evaluate<float>(const std::vector<Resident>&,
                                                      const std::vector<EvaluationPoint>&, Evaluator, int);
template Evaluations PointEvaluation::evaluate<double>(const std::vector<Resident>&,
                                                       const std::vector<EvaluationPoint>&, Evaluator, int);

}  // namespace knotspan
