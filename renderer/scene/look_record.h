// A look as the stages read it.
#pragma once

#include "renderer/scene/camera.h"
#include "renderer/scene/look.h"
#include "renderer/scene/render_lists.h"
#include "shaders/shared/layouts.h"

namespace knotspan {

// `size`: of the model. `curvature`: the range of that shading.
void fillLook(gpu::FrameRecord& record, Shading shading, const Look& look, const Camera& camera, double size,
              const NumberRange& curvature);

}  // namespace knotspan
