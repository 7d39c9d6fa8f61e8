// Meshes as files that other programs read: STL (binary), OBJ (polygons), PLY (binary), OFF.
//
// OBJ, PLY and OFF keep coordinates to the last bit; STL has float alone.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/core/result.h"
#include "model/mesh/triangle_mesh.h"

namespace knotspan::formats {

enum class MeshKind { stl, obj, ply, off };

struct MeshFormat {
    MeshKind kind;
    std::string name;       // "STL"
    std::string extension;  // without the dot, lower case
};
[[nodiscard]] const std::vector<MeshFormat>& meshFormats();

// By the extension, upper or lower case. An .obj may be surfaces as well (obj_format.h): who calls has to
// know.
[[nodiscard]] std::optional<MeshKind> meshKindOf(const std::filesystem::path& path);

// Moves the vertices to where the file can have them. Returns how far the furthest one moved.
double roundTo(MeshKind kind, TriangleMesh& mesh);

// Writes a temporary file beside `path` and renames it, as write() does. Refuses what the file cannot hold:
// over 2^32 triangles, coordinates beyond float's range in STL.
[[nodiscard]] Result<void> writeMesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                                     MeshKind kind);

}  // namespace knotspan::formats
