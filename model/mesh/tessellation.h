// A scene as one mesh of triangles, provably near its surfaces, where trim loops leave them, and welded along
// all edges they share.
//
// Each KSQuad gets its own grid, the fewest cells for which the bound of maths (space_error.h) holds; along
// an edge everyone uses the vertices of whoever asks for the most, so there are neither cracks nor
// T-vertices, poles are one vertex, and what is closed becomes a closed manifold. Trimmed surfaces, and those
// joined to them, are triangulated inside their outlines instead (trimmed_meshing.h).
#pragma once

#include <optional>
#include <string>

#include "model/core/result.h"
#include "model/geometry/ksquad.h"
#include "model/geometry/span_parameter.h"
#include "model/geometry/triangle_mesh.h"
#include "model/mesh/quad_triangles.h"
#include "model/scene/scene.h"

namespace knotspan {

struct TessellationOptions {
    double deviation = 0;  // model units, above zero
    // How far a triangle's normal may be from the surface's, about: sampled, not proved.
    std::optional<double> angleDegrees;
    bool hiddenToo = false;
    size_t mostTriangles = 20'000'000;
    // Without, only edges are one that agree to rounding: nearer to each face, but open where they are apart.
    bool joinsEdges = true;
};

// The triangles of a KSQuad, up to the next patch's first.
struct MeshPatch {
    ObjectId object{};
    KsQuad quad;
    size_t firstTriangle = 0;
};

// An edge of the mesh that stands for a stretch of a face's outline, and places between its ends.
struct OutlineChord {
    ObjectId object{};
    std::array<std::uint32_t, 2> vertices{};
    std::array<std::array<SpanParameter, 2>, 3> places{};
};

struct Tessellation {
    TriangleMesh mesh;
    std::vector<TriangleParameters> parameters;  // by triangle
    std::vector<MeshPatch> patches;
    std::vector<OutlineChord> chords;  // of trimmed faces
    // No point of a surface is further from the mesh, none of the mesh further from a surface: proved.
    double bound = 0;
    size_t uncut = 0;     // trimmed faces that are in it whole, because their loops cannot be followed
    size_t crossing = 0;  // trimmed faces whose outline crosses itself: their sizes are in the bound
    std::vector<std::string> notes;  // sentences for the user

    [[nodiscard]] size_t endOf(size_t patch) const
    {
        return patch + 1 < patches.size() ? patches[patch + 1].firstTriangle : mesh.triangles.size();
    }
};

// Fronts look where S_u x S_v points, mirrored objects' and those of bodies that are inside out turned over.
// Notes name faces whose loops cannot be followed, which are meshed whole, and trimmed ones where the mesh is
// open. Refuses scenes without a (visible) object, and
// deviations that would take more than `mostTriangles`.
[[nodiscard]] Result<Tessellation> tessellate(const Scene& scene, const TessellationOptions& options);

}  // namespace knotspan
