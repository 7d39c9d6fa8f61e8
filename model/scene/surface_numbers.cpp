#include "model/scene/surface_numbers.h"

#include <algorithm>

namespace knotspan {

double GridNumbers::at(size_t ksquad, const Vec2& t) const
{
    const std::uint32_t count = cells[ksquad];
    const Vec2 place(std::clamp(t.x, 0.0, 1.0) * count, std::clamp(t.y, 0.0, 1.0) * count);
    const auto i = std::min(static_cast<std::uint32_t>(place.x), count - 1);
    const auto j = std::min(static_cast<std::uint32_t>(place.y), count - 1);
    const float* const row = values.data() + first[ksquad] + size_t{i} * (count + 1) + j;
    const float* const next = row + count + 1;
    const double x = place.x - i;
    const double y = place.y - j;
    return (1 - x) * ((1 - y) * row[0] + y * row[1]) + x * ((1 - y) * next[0] + y * next[1]);
}

}  // namespace knotspan
