#include "model/mesh/facing_out.h"

#include <algorithm>

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
                    const std::vector<PlacedSurface>& surfaces, const std::vector<MeshVertices::Seam>& seams,
                    const std::vector<char>& closed)
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
        const bool isClosed = std::all_of(body.surfaces.begin(), body.surfaces.end(),
                                          [&](std::uint32_t s) { return closed[s] != 0; });
        const bool over = isClosed && !twisted && volume != 0 ? volume < 0 : kept < 0;
        for (size_t k = 0; k < body.surfaces.size(); ++k)
            result.turned[body.surfaces[k]] = (body.against[k] != 0) != over ? 1 : 0;
    }
    return result;
}

std::vector<char> closedAllAround(const CoincidentEdges& edges)
{
    std::vector<char> closed;
    for (const BorderNumbers& numbers : edges.numbers()) {
        closed.push_back(1);
        for (std::uint32_t k = 0; k < numbers.borderCount(); ++k)
            if (!isManifoldSide(edges, numbers.firstBorder + k))
                closed.back() = 0;
    }
    return closed;
}

void turnOut(Tessellation& tessellation, const FacingOut& facing, const std::vector<size_t>& firstTriangles)
{
    for (size_t s = 0; s < facing.turned.size(); ++s)
        if (facing.turned[s] != 0)
            for (size_t k = firstTriangles[s]; k < firstTriangles[s + 1]; ++k) {
                std::swap(tessellation.mesh.triangles[k][1], tessellation.mesh.triangles[k][2]);
                std::swap(tessellation.parameters[k][1], tessellation.parameters[k][2]);
            }
    if (facing.twisted)
        tessellation.notes.push_back(
            "Some surfaces are joined so that they have only one side; their triangles "
            "cannot all be turned one way.");
}

void dropUnused(Tessellation& tessellation)
{
    std::vector<Vec3>& vertices = tessellation.mesh.vertices;
    std::vector<std::uint32_t> number(vertices.size(), UINT32_MAX);
    for (const Triangle& triangle : tessellation.mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            number[vertex] = 0;
    std::vector<OutlineChord>& chords = tessellation.chords;
    chords.erase(std::remove_if(chords.begin(), chords.end(),
                                [&](const OutlineChord& chord) {
                                    return number[chord.vertices[0]] != 0 || number[chord.vertices[1]] != 0;
                                }),
                 chords.end());
    std::uint32_t count = 0;
    for (size_t k = 0; k < vertices.size(); ++k)
        if (number[k] == 0) {
            number[k] = count;
            vertices[count++] = vertices[k];
        }
    if (count == vertices.size())
        return;
    vertices.resize(count);
    for (Triangle& triangle : tessellation.mesh.triangles)
        for (std::uint32_t& vertex : triangle)
            vertex = number[vertex];
    for (OutlineChord& chord : tessellation.chords)
        for (std::uint32_t& vertex : chord.vertices)
            vertex = number[vertex];
}

}  // namespace knotspan
