// Between scenes and the JSON of .knotspan files: text to values, and objects to text.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "model/scene/scene.h"

namespace knotspan::formats {

// Refuses, naming the object and the member: what is missing, of another type than it should be, or no
// surface.
[[nodiscard]] Result<Scene> sceneFromJson(const nlohmann::json& json);

// JSON on one line; reading it back gives an equal value. A name that is not UTF-8 is made so.
[[nodiscard]] std::string textOf(const SceneObject& object);
[[nodiscard]] std::string textOf(const MeshObject& object);
[[nodiscard]] std::string textOf(const std::string& value);

}  // namespace knotspan::formats
