// The scene on the device. sync() compares pointers: an equal one is an unchanged object, and of one whose
// net and knots have the same shape only the control points that differ travel. Objects that come, go, hide
// or get another shape have the whole scene packed anew.
#pragma once

#include "model/scene/scene.h"
#include <optional>
#include <utility>

#include "renderer/scene/camera.h"
#include "renderer/scene/patch_table.h"
#include "renderer/vulkan/pipeline.h"

namespace knotspan {

class GpuScene {
public:
    GpuScene(Bindings& bindings, Uploader& uploader);

    // Refuses, with a sentence, what exceeds the device's buffers; nothing is held then.
    void sync(const Scene& scene);
    // What was written may not have arrived: the next sync() sends everything.
    void forget();
    // Whether everything was packed anew since the last call.
    [[nodiscard]] bool takeRebuilt() { return std::exchange(rebuilt_, false); }

    // Matrices of all surfaces for a camera, made in double; uploaded where they differ from the last ones.
    void updateViews(const Camera& camera, const std::vector<ObjectId>& highlighted);

    // One visible object, in the order of the surface records.
    struct Resident {
        ObjectId id{};
        SharedObject object;
        PointFrame frame;
        std::uint32_t firstPoint = 0;
        std::uint32_t firstKsquad = 0;
    };
    [[nodiscard]] const std::vector<Resident>& residents() const { return residents_; }
    [[nodiscard]] const Resident* find(ObjectId id) const;  // null where it is not on the device
    [[nodiscard]] std::uint32_t indexOf(const Resident& resident) const
    {
        return static_cast<std::uint32_t>(&resident - residents_.data());
    }

    [[nodiscard]] std::uint32_t ksquadCount() const { return ksquadCount_; }
    [[nodiscard]] const Box& bounds() const { return bounds_; }

    // Between the numbers of the records and the model's names of KSQuads.
    struct KsQuadName {
        ObjectId object{};
        KsQuad ksquad;
    };
    [[nodiscard]] KsQuadName nameOf(std::uint32_t ksquad) const;
    [[nodiscard]] std::optional<std::uint32_t>
    numberOf(const KsQuadName& name) const;  // nothing: no such one

private:
    // A whole scene, ready to be sent.
    struct Packed {
        std::vector<Resident> residents;
        std::vector<gpu::SurfaceRecord> surfaces;
        std::vector<gpu::KsQuadRecord> ksquads;
        std::vector<float> spanKnots;
        std::vector<gpu::vec4> points;
    };
    [[nodiscard]] static Packed pack(const std::vector<std::pair<ObjectId, SharedObject>>& visible);
    void rebuild(const std::vector<std::pair<ObjectId, SharedObject>>& visible);
    void replace(Resident& resident, SharedObject object);
    void provide(Buffer& buffer, int binding, VkDeviceSize bytes);
    template <class T>
    void send(Buffer& buffer, int binding, const std::vector<T>& elements);

    Bindings& bindings_;
    Uploader& uploader_;
    std::vector<Resident> residents_;
    std::uint32_t ksquadCount_ = 0;
    bool rebuilt_ = false;
    Box bounds_;
    std::vector<gpu::SurfaceView> views_;
    Buffer surfaces_;
    Buffer surfaceViews_;
    Buffer ksquads_;
    Buffer spanKnots_;
    Buffer controlPoints_;
};

}  // namespace knotspan
