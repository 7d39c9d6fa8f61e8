// A surface as a camera sees it, made in double.
#pragma once

#include "renderer/scene/camera.h"
#include "renderer/scene/packed_scene.h"
#include "shaders/shared/layouts.h"

namespace knotspan {

// `side` and `shell` as gpu::SurfaceView has them.
[[nodiscard]] gpu::SurfaceView surfaceView(const Resident& resident, const Camera& camera, float side,
                                           std::uint32_t shell);

}  // namespace knotspan
