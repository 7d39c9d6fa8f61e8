// Lines on surfaces, along their edges and outlines and where a parameter has a value, evaluated on the
// device: what travels is which line in the parameters of which KSQuad has which colour, and only where that
// changed.
#pragma once

#include <map>

#include "renderer/frame.h"
#include "renderer/overlays/face_outlines.h"
#include "renderer/overlays/sent_records.h"
#include "renderer/overlays/trim_lines.h"
#include "renderer/scene/gpu_scene.h"

namespace knotspan {

class EdgeLines {
public:
    EdgeLines(const Device& device, Bindings& bindings, Uploader& uploader)
        : device_(device),
          bindings_(bindings),
          records_(bindings, uploader, BINDING_EDGE_LINES)
    {
    }

    // With stages for `specialization`, whose evaluator and order are the scene's. Without lines nothing is
    // made and nothing sent.
    void prepare(const Overlays& overlays, const std::vector<Resident>& residents,
                 const Specialization& specialization);
    // What was written may not have arrived.
    void forget() { records_.forget(); }
    // Inside a rendering, with viewport and bindings set: what prepare() was given.
    void draw(VkCommandBuffer commands) const;

private:
    void add(const EdgeLine& line, const Resident& resident, std::vector<gpu::EdgeLineRecord>& to);

    const Device& device_;
    const Bindings& bindings_;
    std::map<Specialization, Pipeline> pipelines_;  // made when first needed
    Specialization specialization_;
    TrimLines trimLines_;
    FaceOutlines outlines_;
    SentRecords<gpu::EdgeLineRecord> records_;
};

}  // namespace knotspan
