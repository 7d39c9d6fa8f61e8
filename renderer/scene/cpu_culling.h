// The culling modes of shaders/shared/cull_list.h as the path cpu applies them, in double.
#pragma once

#include "renderer/scene/cpu_scene.h"

namespace knotspan {

constexpr int kNotCulled = -1;

// The bit of the first mode in `cullBits` that drops the KSQuad. `eye` as in SurfaceView: in the surface's
// own coordinates, w = 0 of a direction.
[[nodiscard]] int culledBy(const CpuScene& scene, std::uint32_t ksquad, const Vec4& eye,
                           std::uint32_t cullBits);

}  // namespace knotspan
