// The scene on the device. sync() compares pointers: an equal one is an unchanged object, and of one whose
// net and knots have the same shape only the control points that differ travel. Objects that come, go, hide
// or get another shape have the whole scene packed anew.
#pragma once

#include <utility>

#include "renderer/scene/camera.h"
#include "renderer/scene/packed_scene.h"
#include "renderer/vulkan/pipeline.h"

namespace knotspan {

class GpuScene {
public:
    GpuScene(Bindings& bindings, Uploader& uploader);

    // Refuses, with a sentence, what exceeds the device's buffers; nothing is held then.
    void sync(const Scene& scene);
    // What was written may not have arrived: the next sync() sends everything.
    void forget();
    // An evaluator other than `automatic`. Where it changes, the tables of the spans are sent and the KSQuad
    // records, that say where those start; no control point.
    void useEvaluator(Evaluator evaluator);
    [[nodiscard]] Evaluator evaluator() const { return evaluator_; }
    // Whether everything was packed anew since the last call.
    [[nodiscard]] bool takeRebuilt() { return std::exchange(rebuilt_, false); }

    // Matrices of all surfaces for a camera, made in double; uploaded where they differ from the last ones.
    void updateViews(const Camera& camera, const std::vector<ObjectId>& highlighted);

    [[nodiscard]] const std::vector<Resident>& residents() const { return residents_; }
    // Null where it is not on the device.
    [[nodiscard]] const Resident* find(ObjectId id) const { return findResident(residents_, id); }
    [[nodiscard]] std::uint32_t indexOf(const Resident& resident) const
    {
        return static_cast<std::uint32_t>(&resident - residents_.data());
    }

    [[nodiscard]] std::uint32_t ksquadCount() const { return ksquadCount_; }
    [[nodiscard]] const Box& bounds() const { return bounds_; }

private:
    void rebuild(const VisibleObjects& visible);
    void sendTables(const PackedTables<float>& tables);
    void replace(Resident& resident, SharedObject object);
    void provide(Buffer& buffer, int binding, VkDeviceSize bytes);
    template <class T>
    void send(Buffer& buffer, int binding, const std::vector<T>& elements);

    Bindings& bindings_;
    Uploader& uploader_;
    std::vector<Resident> residents_;
    Evaluator evaluator_ = Evaluator::triangular;
    std::uint32_t ksquadCount_ = 0;
    bool rebuilt_ = false;
    Box bounds_;
    std::vector<gpu::SurfaceView> views_;
    Buffer surfaces_;
    Buffer surfaceViews_;
    Buffer ksquads_;
    Buffer spanTables_;
    Buffer controlPoints_;
};

}  // namespace knotspan
