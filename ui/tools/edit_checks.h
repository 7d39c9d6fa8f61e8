// What an edit would do to a scene, before it is applied.
#pragma once

#include "model/core/result.h"
#include "model/scene/edit.h"

namespace knotspan {

// Whether some object would be another one than it is.
[[nodiscard]] bool changes(const Scene& scene, const Edit& edit);

// Refuses, with a sentence that names it, an edit that would change a locked object.
[[nodiscard]] Result<void> leavesLockedAlone(const Scene& scene, const Edit& edit);

}  // namespace knotspan
