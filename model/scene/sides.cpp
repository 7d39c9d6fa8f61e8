#include "model/scene/sides.h"

#include <array>

namespace knotspan {

namespace {

constexpr std::array<const char*, 4> kNames{"automatic", "both", "front", "back"};

}  // namespace

const char* sidesName(Sides sides)
{
    return kNames[static_cast<size_t>(sides)];
}

std::optional<Sides> findSides(std::string_view name)
{
    for (size_t k = 0; k < kNames.size(); ++k)
        if (name == kNames[k])
            return static_cast<Sides>(k);
    return std::nullopt;
}

}  // namespace knotspan
