// Which range of curvatures a model's colours should span: nearly all of what its surfaces have, around zero.
#pragma once

#include "renderer/scene/held_residents.h"
#include "renderer/scene/look.h"

namespace knotspan {

class CurvatureRange {
public:
    // What the look asks for; where it leaves that to the model: from samples of its surfaces, taken anew of
    // those that changed. What bends a thousand times less than a ball of the model's `size` counts as flat.
    // `log`: of the residents; null: all are compared.
    NumberRange of(const std::vector<Resident>& residents, const Look& look, double size,
                   const ResidentChanges* log = nullptr);

private:
    std::optional<CurvatureKind> kind_;
    HeldResidents held_;
    std::vector<std::vector<double>> samples_;  // sizes of figures, by resident
    NumberRange range_;
};

}  // namespace knotspan
