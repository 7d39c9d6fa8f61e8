// The numbers on surfaces that the shading `deviation` shows, as its stage reads them; made anew only where
// others are shown or surfaces came and went.
#pragma once

#include "model/scene/surface_numbers.h"
#include "renderer/scene/held_residents.h"
#include "renderer/scene/look.h"

namespace knotspan {

class DeviationTable {
public:
    // True where words() are others than before. A surface whose KSQuads are not those that were measured has
    // no numbers. `log`: of the residents; null: all are compared.
    bool follow(const std::vector<Resident>& residents, const SharedSurfaceNumbers& numbers,
                const ResidentChanges* log = nullptr);
    // For each KSQuad where its grid starts, 0: it has none; there its cells each way, then its values (float
    // bits), u outer.
    [[nodiscard]] const std::vector<std::uint32_t>& words() const { return words_; }
    // Of all numbers: from nothing to the largest.
    [[nodiscard]] const NumberRange& range() const { return range_; }
    // The words may not have arrived.
    void forget() { isHeld_ = false; }

private:
    bool isHeld_ = false;
    HeldResidents held_;
    SharedSurfaceNumbers numbers_;
    std::vector<std::uint32_t> words_;
    NumberRange range_;
};

}  // namespace knotspan
