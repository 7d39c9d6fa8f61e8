// STEP files made by OpenCASCADE for the tests, and what reading them gave.
#pragma once

#include <TopoDS_Shape.hxx>

#include "model/cad/step_format.h"

namespace knotspan::testing {

void writeStep(const TopoDS_Shape& shape, const std::filesystem::path& path);

// Writes the shape to a STEP file and reads it back through our reader; expects that this works.
[[nodiscard]] formats::Import throughStep(const TopoDS_Shape& shape);

// Every point of a grid over every surface, edges included, with the unit normal there.
struct SampledPoint {
    Vec3 position;
    Vec3 normal;
};
[[nodiscard]] std::vector<SampledPoint> samplesOf(const Scene& scene, int steps = 12);

}  // namespace knotspan::testing
