// Where the spans of each surface lie along its parameters and along its iso-curves: what a checker is laid
// by.
#pragma once

#include "renderer/scene/held_residents.h"
#include "renderer/scene/look.h"
#include "shaders/shared/language.h"

namespace knotspan {

class SpanPlaces {
public:
    // For each surface the starts of its spans along u and the last one's end, then those along v: 0 to 1
    // over the domain, or lengths in model units, means over some iso-curves. Of surface s the first is
    // number firstBorder / 2 + 2 s. Looks again at what changed. `log`: of the residents; null: all are
    // compared.
    const std::vector<float>& of(const std::vector<Resident>& residents, CheckerBy by,
                                 const ResidentChanges* log = nullptr);

private:
    std::optional<CheckerBy> by_;
    HeldResidents held_;
    std::vector<float> places_;
};

}  // namespace knotspan
