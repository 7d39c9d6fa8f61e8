// Between scenes and the JSON of .knotspan files: text to values, and objects to text.
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "model/scene/scene.h"

namespace knotspan::formats {

// More than any model that fits into memory; parsed values take 16 bytes and more each.
constexpr std::int64_t kMostJsonValues = 30'000'000;

// Refuses, with the line and column: text that is no JSON; and numbers too large for a double, keys that
// stand twice, values nested deeper or more numerous than a model needs (so that no text exhausts memory).
[[nodiscard]] Result<nlohmann::json> parsedJson(const std::string& text,
                                                std::int64_t mostValues = kMostJsonValues);

// Refuses, naming the object and the member: what is missing, of another type than it should be, or no
// surface.
[[nodiscard]] Result<Scene> sceneFromJson(const nlohmann::json& json);

// JSON on one line; reading it back gives an equal value. A name that is not UTF-8 is made so.
[[nodiscard]] std::string textOf(const SceneObject& object);
[[nodiscard]] std::string textOf(const std::string& value);

}  // namespace knotspan::formats
