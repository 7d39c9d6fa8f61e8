// Meshes as files that other programs read: STL (binary), OBJ (polygons), PLY (binary), OFF, VTP, glTF
// (.glb).
//
// STL and glTF have floats alone, the others keep coordinates to the last bit. glTF is in metres with y up,
// and says so; the others have the mesh's own numbers.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/core/result.h"
#include "model/geometry/triangle_mesh.h"

namespace knotspan::formats {

enum class MeshKind { stl, obj, ply, off, vtp, glb };

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
// over 2^32 triangles, coordinates beyond float's range in STL and glTF. `units`: the mesh's.
[[nodiscard]] Result<void> writeMesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                                     MeshKind kind, const std::string& units = "mm");
// The same, over the file itself and with errors that do not name it.
[[nodiscard]] Result<void> writeMeshTo(const std::filesystem::path& path, const TriangleMesh& mesh,
                                       MeshKind kind, const std::string& units);

// What glTF makes of a unit, which is taken for metres where we do not know it; and a sentence about that.
[[nodiscard]] double metresIn(const std::string& units);
[[nodiscard]] std::string noteOnUnits(const std::string& units);

}  // namespace knotspan::formats
