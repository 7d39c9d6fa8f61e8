// One function a sample; sample_list.cpp lists them. How each is built: docs/samples.md.
#pragma once

#include "model/scene/scene.h"

namespace knotspan {

[[nodiscard]] Scene makeSingle100();
[[nodiscard]] Scene makeNine16();
[[nodiscard]] Scene makeSphere();
[[nodiscard]] Scene makeTorus();
[[nodiscard]] Scene makeHull();
[[nodiscard]] Scene makeKnot();
[[nodiscard]] Scene makeExtremes();

}  // namespace knotspan
