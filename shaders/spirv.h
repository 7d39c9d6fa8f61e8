// The compiled shader stages, embedded in the program.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace knotspan {

// The sizes of arrays that stages are compiled for: no surface that they draw has a larger degree + 1.
constexpr std::uint32_t kShaderOrders[] = {4, 8, 16};

// The SPIR-V words of a stage by its file name ("surface.frag"); empty where there is no such stage.
[[nodiscard]] std::span<const std::uint32_t> spirv(std::string_view stage, std::uint32_t order);

}  // namespace knotspan
