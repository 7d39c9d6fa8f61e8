// The culling modes of shaders/shared/cull_list.h as the path cpu applies them: the same texts.
#pragma once

#include "renderer/scene/cpu_scene.h"
#include "renderer/scene/facing_arrays.h"
#include "shaders/shared/pixel_map.glsl"

namespace knotspan {

constexpr int kNotCulled = -1;

// A surface in the picture.
struct CullView {
    gpu::PixelMap<float> map;
    gpu::SurfaceView view;
    float side = 0;                        // that is shown alone, as shownSide() of scene.glsl has it
    const FacingArrays* facing = nullptr;  // where a mode that is on reads it
};

// The bit of the first mode in `cullBits` that drops the KSQuad; `view` is its surface's.
[[nodiscard]] int culledBy(const CpuScene& scene, std::uint32_t ksquad, const CullView& view,
                           std::uint32_t cullBits);

}  // namespace knotspan
