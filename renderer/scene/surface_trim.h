// What the trim loops of a surface leave of it, as the stages read it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "model/scene/scene_object.h"
#include "model/trimming/trim_index.h"

namespace knotspan {

struct SurfaceTrim {
    std::optional<TrimIndex> index;  // none: all of the surface is drawn
    std::string refusal;             // a sentence: why the loops cannot be followed; empty where they can
};
using SharedTrim = std::shared_ptr<const SurfaceTrim>;

// Of the object's knots and loops alone. Null where it has no loops.
[[nodiscard]] SharedTrim surfaceTrim(const SceneObject& object);

}  // namespace knotspan
