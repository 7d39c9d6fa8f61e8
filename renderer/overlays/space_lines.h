// Straight lines in the model that surfaces and meshes hide; they travel only where others are shown than
// before, whatever the camera does.
#pragma once

#include "renderer/frame.h"
#include "renderer/overlays/sent_records.h"
#include "shaders/shared/layouts.h"

namespace knotspan {

class SpaceLinesOverlay {
public:
    SpaceLinesOverlay(const Device& device, Bindings& bindings, Uploader& uploader)
        : device_(device),
          bindings_(bindings),
          records_(bindings, uploader, BINDING_SPACE_LINES)
    {
    }

    // Those without length, and with ends that are no numbers, are passed over.
    void prepare(const std::vector<SharedSpaceLines>& lines);
    // What was written may not have arrived.
    void forget()
    {
        records_.forget();
        held_.clear();
    }
    // Inside a rendering, with viewport and bindings set: what prepare() was given.
    void draw(VkCommandBuffer commands, const Camera& camera) const;

private:
    const Device& device_;
    const Bindings& bindings_;
    Pipeline pipeline_;  // made when first needed
    std::vector<SharedSpaceLines> held_;
    Vec3 origin_{0};  // that the ends count from
    SentRecords<gpu::SpaceLineRecord> records_;
};

}  // namespace knotspan
