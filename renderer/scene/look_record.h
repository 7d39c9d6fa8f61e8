// A look as the stages read it.
#pragma once

#include "renderer/scene/camera.h"
#include "renderer/scene/look.h"
#include "renderer/scene/render_lists.h"
#include "shaders/shared/layouts.h"

namespace knotspan {

// `size`: of the model. `numbers`: the range of curvatures or of deviations, whichever the shading shows.
void fillLook(gpu::FrameRecord& record, Shading shading, const Look& look, const Camera& camera, double size,
              const NumberRange& numbers);

}  // namespace knotspan
