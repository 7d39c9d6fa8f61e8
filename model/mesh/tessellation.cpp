#include "model/mesh/tessellation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/core/check.h"
#include "model/mesh/cell_counts.h"
#include "model/mesh/facing_out.h"

namespace knotspan {

namespace {

struct Placed {
    std::vector<PlacedSurface> surfaces;
    std::vector<ObjectId> objects;
    size_t trimmed = 0;
};

Placed placedOf(const Scene& scene, bool hiddenToo)
{
    Placed placed;
    for (const auto& [id, object] : scene.objects()) {
        if (!object->visible && !hiddenToo)
            continue;
        placed.surfaces.push_back({&object->surface, object->transform, nullptr});
        placed.objects.push_back(id);
        placed.trimmed += object->trimLoops.empty() ? 0 : 1;
    }
    return placed;
}

std::string shortText(double number)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", number);
    return text;
}

Result<void> isNotTooFine(const CellCounts& counts, size_t most)
{
    double triangles = 0;
    for (const Grid& grid : counts.grids)
        triangles += 2.0 * static_cast<double>(grid.cells());
    if (!counts.failed.empty())
        return failure("A mesh this fine would need more than " + std::to_string(kLargestFactor) +
                           " cells along a side of a knot span",
                       "Choose a larger deviation");
    if (triangles > static_cast<double>(most))
        return failure("A mesh this fine would have about " + shortText(triangles) + " triangles",
                       "Choose a larger deviation");
    return {};
}

class Meshing {
public:
    Meshing(const Placed& placed, const CoincidentEdges& edges, const CellCounts& counts)
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
        turn();
        dropUnused();
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

    void turn()
    {
        const FacingOut facing =
            facingOut(result_.mesh, firstTriangles_, placed_.surfaces, edges_, vertices_.seams());
        for (std::uint32_t s = 0; s < placed_.surfaces.size(); ++s)
            if (facing.turned[s] != 0)
                for (size_t k = firstTriangles_[s]; k < firstTriangles_[s + 1]; ++k) {
                    std::swap(result_.mesh.triangles[k][1], result_.mesh.triangles[k][2]);
                    std::swap(result_.parameters[k][1], result_.parameters[k][2]);
                }
        if (facing.twisted)
            result_.notes.push_back(
                "Some surfaces are joined so that they have only one side; their triangles "
                "cannot all be turned one way.");
    }

    // Vertices that lines which are one point had beside it.
    void dropUnused()
    {
        std::vector<Vec3>& vertices = result_.mesh.vertices;
        std::vector<std::uint32_t> number(vertices.size(), UINT32_MAX);
        for (const Triangle& triangle : result_.mesh.triangles)
            for (const std::uint32_t vertex : triangle)
                number[vertex] = 0;
        std::uint32_t count = 0;
        for (size_t k = 0; k < vertices.size(); ++k)
            if (number[k] == 0) {
                number[k] = count;
                vertices[count++] = vertices[k];
            }
        if (count == vertices.size())
            return;
        vertices.resize(count);
        for (Triangle& triangle : result_.mesh.triangles)
            for (std::uint32_t& vertex : triangle)
                vertex = number[vertex];
    }

    const Placed& placed_;
    const CoincidentEdges& edges_;
    const CellCounts& counts_;
    MeshVertices vertices_;
    std::vector<size_t> firstTriangles_;
    Tessellation result_;
};

}  // namespace

Result<Tessellation> tessellate(const Scene& scene, const TessellationOptions& options)
{
    check(options.deviation > 0, "a deviation is above zero");
    const Placed placed = placedOf(scene, options.hiddenToo);
    if (placed.surfaces.empty())
        return failure("There is nothing to make a mesh of", "Show at least one object");
    const CellCounts counts = cellCounts(placed.surfaces, options.deviation, options.angleDegrees);
    if (const auto fine = isNotTooFine(counts, options.mostTriangles); !fine)
        return tl::unexpected(fine.error());
    const CoincidentEdges edges(placed.surfaces);
    auto result = Meshing(placed, edges, counts).make();
    if (!result)
        return result;
    if (placed.trimmed > 0)
        result->notes.push_back(std::to_string(placed.trimmed) +
                                (placed.trimmed == 1 ? " trimmed face is" : " trimmed faces are") +
                                " in the mesh whole: their holes and outlines are not cut yet.");
    if (result->bound > options.deviation)
        result->notes.push_back("Joined borders are apart, so the mesh is within " +
                                shortText(result->bound) + " of the surfaces, more than was asked.");
    return result;
}

}  // namespace knotspan
