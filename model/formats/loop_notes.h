// What a user should know of a model's trim loops: which were mended, and which cannot be followed.
#pragma once

#include <string>
#include <vector>

#include "model/scene/scene.h"

namespace knotspan::formats {

// A sentence for each kind of trouble, with the names of some of the surfaces. Gaps narrower than a ten-
// thousandth of the domain are the tolerance of files, and not spoken of; nor is what is only unusual.
[[nodiscard]] std::vector<std::string> loopNotes(const Scene& scene);

}  // namespace knotspan::formats
