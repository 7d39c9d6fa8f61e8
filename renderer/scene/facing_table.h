// FacingArrays on the device, sent where they change.
#pragma once

#include "renderer/scene/facing_arrays.h"
#include "renderer/scene/held_memory.h"
#include "renderer/vulkan/pipeline.h"

namespace knotspan {

class FacingTable {
public:
    FacingTable(Bindings& bindings, Uploader& uploader) : bindings_(bindings), uploader_(uploader) {}

    // `log`: of the residents.
    void update(const std::vector<Resident>& residents, FacingArrays::Origins origins,
                FacingStrength strength, const ResidentChanges& log);
    // What was written may not have arrived: the next update() sends everything.
    void forget() { arrays_.clear(); }

    [[nodiscard]] const FacingArrays& arrays() const { return arrays_; }
    void listMemory(std::vector<HeldMemory>& to) const;

private:
    Bindings& bindings_;
    Uploader& uploader_;
    FacingArrays arrays_;
    Buffer boxes_;
    Buffer rays_;
};

}  // namespace knotspan
