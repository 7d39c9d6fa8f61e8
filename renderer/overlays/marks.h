// Marked control points: round points in front of everything, one draw for all. What travels is which point
// has which colour and size, and only where that changed; where they stand the device knows.
#pragma once

#include "renderer/frame.h"
#include "renderer/overlays/sent_records.h"
#include "renderer/scene/gpu_scene.h"

namespace knotspan {

class Marks {
public:
    Marks(const Device& device, Bindings& bindings, Uploader& uploader);

    // Marks that name no control point of the residents are passed over.
    void prepare(const std::vector<ControlPointMark>& marks, const std::vector<Resident>& residents);
    void forget() { records_.forget(); }
    // Inside a rendering, with viewport and bindings set: what prepare() was given.
    void draw(VkCommandBuffer commands) const;

private:
    Pipeline points_;
    SentRecords<gpu::MarkRecord> records_;
};

}  // namespace knotspan
