// The units of two models that are compared.
#pragma once

#include <string>

#include "model/scene/scene.h"

namespace knotspan::app {

struct ComparedUnits {
    std::string name;
    double scale = 1;  // so many of them are one of the second model's
};

// A file that says nothing of units is taken to be in the other's; told wherever the user could be mistaken.
[[nodiscard]] ComparedUnits comparedUnits(const std::string& fileA, const Scene& a, const std::string& fileB,
                                          const Scene& b);

}  // namespace knotspan::app
