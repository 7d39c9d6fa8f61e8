#include "model/mesh/facing_out.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/analysis/border_cover.h"

namespace knotspan {

namespace {

struct Body {
    std::vector<std::uint32_t> surfaces;
    std::vector<char> against;  // the first one, by surface of the list
};

bool isClosed(const Body& body, const CoincidentEdges& edges)
{
    for (const std::uint32_t s : body.surfaces) {
        const BorderNumbers& numbers = edges.numbers()[s];
        for (std::uint32_t k = 0; k < numbers.borderCount(); ++k)
            if (!isManifoldSide(edges, numbers.firstBorder + k))
                return false;
    }
    return true;
}

// Six times what the triangles of a surface add to the volume, seen from a point.
double swept(const TriangleMesh& mesh, size_t first, size_t end, const Vec3& from)
{
    double sum = 0;
    for (size_t k = first; k < end; ++k) {
        const Triangle& t = mesh.triangles[k];
        sum += glm::dot(mesh.vertices[t[0]] - from,
                        glm::cross(mesh.vertices[t[1]] - from, mesh.vertices[t[2]] - from));
    }
    return sum;
}

}  // namespace

FacingOut facingOut(const TriangleMesh& mesh, const std::vector<size_t>& firstTriangles,
                    const std::vector<PlacedSurface>& surfaces, const CoincidentEdges& edges,
                    const std::vector<MeshVertices::Seam>& seams)
{
    FacingOut result;
    result.turned.assign(surfaces.size(), 0);
    std::vector<std::vector<std::pair<std::uint32_t, bool>>> neighbours(surfaces.size());
    for (const MeshVertices::Seam& seam : seams) {
        neighbours[seam.surface].emplace_back(seam.other, seam.agree);
        neighbours[seam.other].emplace_back(seam.surface, seam.agree);
    }
    std::vector<int> placed(surfaces.size(), -1);  // 1: against the first one of its body
    for (std::uint32_t start = 0; start < surfaces.size(); ++start) {
        if (placed[start] >= 0)
            continue;
        Body body{{start}, {0}};
        placed[start] = 0;
        bool twisted = false;
        for (size_t k = 0; k < body.surfaces.size(); ++k)
            for (const auto& [other, agree] : neighbours[body.surfaces[k]]) {
                const int side = agree ? body.against[k] : 1 - body.against[k];
                if (placed[other] < 0) {
                    placed[other] = side;
                    body.surfaces.push_back(other);
                    body.against.push_back(static_cast<char>(side));
                }
                twisted = twisted || placed[other] != side;
            }
        result.twisted = result.twisted || twisted;
        double volume = 0;
        double kept = 0;
        const Vec3 from = mesh.triangles.size() > firstTriangles[start]
                              ? mesh.vertices[mesh.triangles[firstTriangles[start]][0]]
                              : Vec3(0);
        for (size_t k = 0; k < body.surfaces.size(); ++k) {
            const std::uint32_t s = body.surfaces[k];
            const size_t first = firstTriangles[s];
            const size_t end = firstTriangles[s + 1];
            volume += (body.against[k] != 0 ? -1 : 1) * swept(mesh, first, end, from);
            const bool mirrored = glm::determinant(glm::dmat3(surfaces[s].transform)) < 0;
            kept += (mirrored == (body.against[k] != 0) ? 1.0 : -1.0) * static_cast<double>(end - first);
        }
        const bool over = isClosed(body, edges) && !twisted && volume != 0 ? volume < 0 : kept < 0;
        for (size_t k = 0; k < body.surfaces.size(); ++k)
            result.turned[body.surfaces[k]] = (body.against[k] != 0) != over ? 1 : 0;
    }
    return result;
}

}  // namespace knotspan
