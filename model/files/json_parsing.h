// JSON from anywhere: no text exhausts memory or the stack.
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "model/core/result.h"

namespace knotspan::formats {

// More than any model that fits into memory; parsed values take 16 bytes and more each.
constexpr std::int64_t kMostJsonValues = 30'000'000;

// Refuses, with the line and column: text that is no JSON; and numbers too large for a double, keys that
// stand twice, values nested deeper or more numerous than a model needs (so that no text exhausts memory).
[[nodiscard]] Result<nlohmann::json> parsedJson(const std::string& text,
                                                std::int64_t mostValues = kMostJsonValues);

}  // namespace knotspan::formats
