// Evaluation by itself: the compute stage at any number of points, in float or double, and the time it takes.
// It holds the scene in buffers of its own, because neither evaluator nor number type are those of the
// picture.
#pragma once

#include <map>

#include "renderer/renderer.h"
#include "renderer/scene/packed_scene.h"
#include "renderer/stats/gpu_clock.h"
#include "renderer/vulkan/pipeline.h"

namespace knotspan {

class PointEvaluation {
public:
    PointEvaluation(const Device& device, GpuClock& clock);

    // In float or double, where the device has it.
    template <class Real>
    [[nodiscard]] Evaluations evaluate(const std::vector<Resident>& residents,
                                       const std::vector<EvaluationPoint>& points, Evaluator evaluator,
                                       int repeats);

private:
    [[nodiscard]] VkPipeline pipelineFor(Evaluator evaluator, Precision precision);
    template <class Real>
    void sendScene(const PackedScene<Real>& packed);
    // The requests are one batch; returns the median of the repeats in milliseconds.
    template <class Real>
    double evaluateBatch(VkPipeline pipeline, std::span<const gpu::RequestRecord<Real>> requests, int repeats,
                         std::vector<EvaluatedPoint>& to);
    template <class T>
    void send(int binding, Buffer& buffer, std::span<const T> elements);
    void giveBack();

    const Device& device_;
    GpuClock& clock_;
    Bindings bindings_;
    Uploader uploader_;
    std::map<std::pair<Evaluator, Precision>, Pipeline> pipelines_;  // made when first needed
    Buffer frame_;
    Buffer surfaces_;
    Buffer ksquads_;
    Buffer spanTables_;
    Buffer controlPoints_;
    Buffer requests_;
    Buffer evaluated_;
};

}  // namespace knotspan
