// The sample models that ship: generated, so that each is exact and can be made again (docs/samples.md).
#pragma once

#include <string>
#include <vector>

#include "model/scene/scene.h"

namespace knotspan {

struct Sample {
    std::string name;         // "knot"
    std::string description;  // one line for `knotspan sample` and the window's menu
    Scene (*make)();
};

[[nodiscard]] const std::vector<Sample>& samples();
[[nodiscard]] const Sample* findSample(const std::string& name);  // null where there is none

}  // namespace knotspan
