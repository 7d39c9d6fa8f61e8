// What a part of the renderer holds on the device, by kind.
#pragma once

#include <cstdint>
#include <string>

namespace knotspan {

struct HeldMemory {
    std::string kind;  // "control points"
    std::uint64_t bytes = 0;
};

}  // namespace knotspan
