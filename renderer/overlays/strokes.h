// Flat pieces and straight lines in the picture itself, in front of everything, with smooth borders; they
// travel only where they changed.
#pragma once

#include "renderer/frame.h"
#include "renderer/overlays/sent_records.h"
#include "shaders/shared/layouts.h"

namespace knotspan {

class Strokes {
public:
    Strokes(const Device& device, Bindings& bindings, Uploader& uploader);

    // Lines come in front of pieces. Lines without length, pieces without area or with a side that has none,
    // and what is no number, are passed over.
    void prepare(const std::vector<Patch>& patches, const std::vector<Stroke>& strokes);
    void forget() { records_.forget(); }
    // Inside a rendering, with viewport and bindings set: what prepare() was given.
    void draw(VkCommandBuffer commands) const;

private:
    Pipeline rectangles_;
    SentRecords<gpu::StrokeRecord> records_;
};

}  // namespace knotspan
