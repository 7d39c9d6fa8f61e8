// What OpenCASCADE by itself makes of a STEP, IGES or BREP file: triangles far finer than a pixel. The second
// opinion on how a file looks, by other code than ours from the file to the picture.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "model/core/result.h"
#include "model/core/space.h"

namespace knotspan::corpus {

struct FineTriangle {
    std::array<Vec3, 3> corners;  // millimetres
    int face = 0;                 // in the file's order, from 0
};

struct FineMesh {
    std::vector<FineTriangle> triangles;
    Box box;
    int faces = 0;
    std::vector<int> unmeshed;   // faces of which OpenCASCADE makes no triangles
    std::vector<double> slacks;  // by face: how far its own edges say that they may be off
};

// No triangle further from its surface than the part `fineness` of the model's diagonal.
[[nodiscard]] Result<FineMesh> fineMeshOf(const std::filesystem::path& path, double fineness);

}  // namespace knotspan::corpus
