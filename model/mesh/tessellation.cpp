#include "model/mesh/tessellation.h"

#include <algorithm>

#include "model/core/check.h"
#include "model/mesh/cell_counts.h"
#include "model/mesh/facing_out.h"
#include "model/mesh/mesh_limits.h"
#include "model/mesh/mesh_parts.h"

namespace knotspan {

namespace {

PlacedScene placedOf(const Scene& scene, bool hiddenToo)
{
    PlacedScene placed;
    for (const auto& [id, object] : scene.objects()) {
        if (!object->visible && !hiddenToo)
            continue;
        placed.surfaces.push_back({&object->surface, object->transform, &object->trimLoops});
        placed.objects.push_back(id);
        placed.names.push_back(object->name);
    }
    return placed;
}

class Meshing {
public:
    Meshing(const PlacedScene& placed, const CoincidentEdges& edges, const CellCounts& counts)
        : placed_(placed),
          edges_(edges),
          counts_(counts),
          vertices_(placed.surfaces, edges, counts.grids)
    {
    }

    Result<Tessellation> make()
    {
        if (vertices_.count() > UINT32_MAX)
            return failure("A mesh this fine would have too many vertices", "Choose a larger deviation");
        vertices_.evaluate();
        addTriangles();
        result_.mesh.vertices = vertices_.takePositions();
        turnOut(result_,
                facingOut(result_.mesh, firstTriangles_, placed_.surfaces, vertices_.seams(),
                          closedAllAround(edges_)),
                firstTriangles_);
        dropUnused(result_);
        return std::move(result_);
    }

private:
    void addTriangles()
    {
        size_t cells = 0;
        for (const Grid& grid : counts_.grids)
            cells += static_cast<size_t>(grid.cells());
        result_.mesh.triangles.reserve(5 * cells / 2);
        result_.parameters.reserve(5 * cells / 2);
        result_.patches.reserve(counts_.grids.size());
        QuadTriangles quads(result_.mesh.triangles, result_.parameters);
        for (std::uint32_t s = 0; s < placed_.surfaces.size(); ++s) {
            const BorderNumbers& numbers = edges_.numbers()[s];
            firstTriangles_.push_back(result_.mesh.triangles.size());
            std::uint32_t k = 0;
            for (const KsQuad& quad : ksQuads(*placed_.surfaces[s].surface)) {
                const std::uint32_t ksquad = numbers.firstKsquad + k;
                result_.patches.push_back({placed_.objects[s], quad, result_.mesh.triangles.size()});
                quads.add(vertices_, s, k / numbers.spansV, k % numbers.spansV, ksquad,
                          counts_.rising[ksquad] != 0);
                result_.bound = std::max(result_.bound, counts_.bounds[ksquad] + vertices_.gap(s));
                ++k;
            }
        }
        firstTriangles_.push_back(result_.mesh.triangles.size());
    }

    const PlacedScene& placed_;
    const CoincidentEdges& edges_;
    const CellCounts& counts_;
    MeshVertices vertices_;
    std::vector<size_t> firstTriangles_;
    Tessellation result_;
};

Result<Tessellation> tessellateWhole(const PlacedScene& placed, const TessellationOptions& options)
{
    const CellCounts counts =
        cellCounts(placed.surfaces, std::vector<double>(placed.surfaces.size(), options.deviation),
                   options.angleDegrees);
    if (const auto fine = isNotTooFine(counts, options.mostTriangles); !fine)
        return tl::unexpected(fine.error());
    const CoincidentEdges edges(placed.surfaces);
    return Meshing(placed, edges, counts).make();
}

Result<Tessellation> tessellateMixed(const PlacedScene& placed, const TessellationOptions& options)
{
    const std::vector<std::uint32_t> reached = reachedByTrimming(placed, options);
    const PlacedScene trimmed = partOf(placed, reached, 1);
    const PlacedScene whole = partOf(placed, reached, 0);
    auto result =
        trimmed.surfaces.empty() ? tessellateWhole(whole, options) : tessellateTrimmed(trimmed, options);
    if (!result || trimmed.surfaces.empty() || whole.surfaces.empty())
        return result;
    auto rest = tessellateWhole(whole, options);
    if (!rest)
        return rest;
    return appended(*std::move(result), *std::move(rest));
}

}  // namespace

Result<Tessellation> tessellate(const Scene& scene, const TessellationOptions& options)
{
    check(options.deviation > 0, "a deviation is above zero");
    const PlacedScene placed = placedOf(scene, options.hiddenToo);
    if (placed.surfaces.empty())
        return failure("There is nothing to make a mesh of", "Show at least one object");
    const bool anyTrimmed = std::any_of(placed.surfaces.begin(), placed.surfaces.end(),
                                        [](const auto& surface) { return !surface.trimLoops->empty(); });
    auto result = anyTrimmed ? tessellateMixed(placed, options) : tessellateWhole(placed, options);
    if (result && result->mesh.triangles.empty())
        return failure("Nothing is left of the surfaces inside their trim loops", "Untrim a surface");
    if (result && result->bound > options.deviation && result->crossing == 0)
        result->notes.push_back("Joined borders are apart, so the mesh is within " +
                                shortText(result->bound) + " of the surfaces, more than was asked.");
    return result;
}

}  // namespace knotspan
