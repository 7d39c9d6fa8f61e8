// The compiled shader stages, embedded in the program.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace knotspan {

// The SPIR-V words of a stage by its file name ("surface.frag"); empty where there is no such stage.
[[nodiscard]] std::span<const std::uint32_t> spirv(std::string_view stage);

}  // namespace knotspan
