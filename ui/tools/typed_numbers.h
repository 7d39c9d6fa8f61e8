// Numbers typed during a drag, in place of what the hand does: "2.5", "1 0 -3", "=4" for a place.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/core/result.h"
#include "model/core/space.h"
#include "model/sculpting/point_drag.h"

namespace knotspan {

struct DragNumbers {
    bool absolute = false;       // after "="
    std::vector<double> values;  // one to three
};

class TypedNumbers {
public:
    // False where the sign stands in no number: digits . - , = and space do.
    bool type(char sign);
    bool erase();  // the last sign; false where there is none

    [[nodiscard]] bool isEmpty() const { return text_.empty(); }
    [[nodiscard]] const std::string& text() const { return text_; }
    // Spaces and commas part them. Refuses, with a sentence that says what is missing, all else.
    [[nodiscard]] Result<DragNumbers> numbers() const;

private:
    std::string text_;
};

// What they say of something that stands at `start`. Freely: three numbers, missing ones move nothing. Along
// an axis: one, a distance along it; absolute only along the model's axes.
[[nodiscard]] Result<Vec3> movementBy(const DragNumbers& numbers, const Vec3& start);
[[nodiscard]] Result<double> distanceBy(const DragNumbers& numbers, DragAxis axis, const Vec3& start);
// An angle or a factor.
[[nodiscard]] Result<double> singleOf(const DragNumbers& numbers);

// Of x, y and z: 0, 1, 2.
[[nodiscard]] std::optional<int> coordinateOf(DragAxis axis);

}  // namespace knotspan
