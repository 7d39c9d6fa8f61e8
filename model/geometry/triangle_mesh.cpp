#include "model/geometry/triangle_mesh.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace knotspan {

namespace {

// A side of a triangle: both ends, the lesser one first, and whether it runs that way.
struct HalfEdge {
    std::uint64_t ends = 0;
    bool forwards = false;
};

std::vector<HalfEdge> halfEdgesOf(const TriangleMesh& mesh)
{
    std::vector<HalfEdge> result;
    result.reserve(3 * mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles) {
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
            continue;
        for (size_t k = 0; k < 3; ++k) {
            const std::uint64_t from = triangle[k];
            const std::uint64_t to = triangle[(k + 1) % 3];
            result.push_back({std::min(from, to) << 32U | std::max(from, to), from < to});
        }
    }
    std::sort(result.begin(), result.end(),
              [](const HalfEdge& a, const HalfEdge& b) { return a.ends < b.ends; });
    return result;
}

}  // namespace

MeshTopology topologyOf(const TriangleMesh& mesh)
{
    const std::vector<HalfEdge> all = halfEdgesOf(mesh);
    MeshTopology result;
    result.degenerate = mesh.triangles.size() - all.size() / 3;
    for (size_t first = 0; first < all.size();) {
        size_t end = first;
        size_t forwards = 0;
        for (; end < all.size() && all[end].ends == all[first].ends; ++end)
            forwards += all[end].forwards ? 1 : 0;
        ++result.edges;
        result.boundaryEdges += end - first == 1 ? 1 : 0;
        result.nonManifoldEdges += end - first > 2 ? 1 : 0;
        result.turnedEdges += end - first == 2 && forwards != 1 ? 1 : 0;
        first = end;
    }
    std::vector<char> used(mesh.vertices.size(), 0);
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            used[vertex] = 1;
    result.usedVertices = static_cast<size_t>(std::count(used.begin(), used.end(), 1));
    result.euler = static_cast<long>(result.usedVertices) - static_cast<long>(result.edges) +
                   static_cast<long>(all.size() / 3);
    return result;
}

double volumeOf(const TriangleMesh& mesh)
{
    if (mesh.vertices.empty())
        return 0;
    const Vec3 from = mesh.vertices.front();
    double sum = 0;
    for (const Triangle& t : mesh.triangles)
        sum += glm::dot(mesh.vertices[t[0]] - from,
                        glm::cross(mesh.vertices[t[1]] - from, mesh.vertices[t[2]] - from));
    return sum / 6;
}

}  // namespace knotspan
