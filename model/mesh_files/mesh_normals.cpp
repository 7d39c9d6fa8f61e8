#include "model/mesh_files/mesh_normals.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace knotspan::formats {

namespace {

constexpr double kCosineOfCrease = 0.8660254037844387;  // 30 degrees

// Which corners meet in each vertex: those of vertex v are corners[first[v]] up to corners[first[v + 1]].
struct Meetings {
    std::vector<std::uint32_t> first;
    std::vector<size_t> corners;  // 3 * triangle + corner, ascending
};

Meetings meetingsOf(const TriangleMesh& mesh)
{
    Meetings result;
    result.first.assign(mesh.vertices.size() + 1, 0);
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            ++result.first[vertex + 1];
    for (size_t v = 0; v < mesh.vertices.size(); ++v)
        result.first[v + 1] += result.first[v];
    std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
    result.corners.resize(3 * mesh.triangles.size());
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
        for (size_t k = 0; k < 3; ++k)
            result.corners[next[mesh.triangles[t][k]]++] = 3 * t + k;
    return result;
}

Vec3 unitOrZero(const Vec3& vector)
{
    const double length = glm::length(vector);
    return length > 0 ? vector / length : Vec3(0);
}

class Shading {
public:
    explicit Shading(const TriangleMesh& mesh) : mesh_(mesh), meetings_(meetingsOf(mesh))
    {
        for (const auto& [a, b, c] : mesh.triangles) {
            const Vec3 along = mesh.vertices[b] - mesh.vertices[a];
            flat_.push_back(unitOrZero(glm::cross(along, mesh.vertices[c] - mesh.vertices[a])));
        }
    }

    ShadedMesh run()
    {
        ShadedMesh result;
        result.triangles.resize(mesh_.triangles.size());
        for (std::uint32_t v = 0; v < mesh_.vertices.size(); ++v) {
            const auto own = static_cast<std::uint32_t>(result.vertices.size());
            for (size_t at = meetings_.first[v]; at < meetings_.first[v + 1]; ++at) {
                const size_t corner = meetings_.corners[at];
                const std::array<float, 3> normal = normalAt(v, corner / 3);
                std::uint32_t number = own;
                while (number < result.vertices.size() && result.normals[number] != normal)
                    ++number;
                if (number == result.vertices.size()) {
                    result.vertices.push_back(v);
                    result.normals.push_back(normal);
                }
                result.triangles[corner / 3][corner % 3] = number;
            }
        }
        return result;
    }

private:
    // Summed in one order, so that corners with the same neighbours have the same bits.
    [[nodiscard]] std::array<float, 3> normalAt(std::uint32_t vertex, size_t triangle) const
    {
        // Where thousands of triangles meet, their own normals will do.
        constexpr std::uint32_t kMany = 4096;
        Vec3 sum(0);
        const bool isFan = meetings_.first[vertex + 1] - meetings_.first[vertex] > kMany;
        for (size_t at = meetings_.first[vertex]; !isFan && at < meetings_.first[vertex + 1]; ++at) {
            const size_t corner = meetings_.corners[at];
            if (glm::dot(flat_[corner / 3], flat_[triangle]) > kCosineOfCrease)
                sum += angleAt(corner) * flat_[corner / 3];
        }
        Vec3 normal = unitOrZero(sum);
        if (normal == Vec3(0))
            normal = flat_[triangle] == Vec3(0) ? Vec3(0, 0, 1) : flat_[triangle];
        return {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)};
    }

    [[nodiscard]] double angleAt(size_t corner) const
    {
        const Triangle& t = mesh_.triangles[corner / 3];
        const Vec3& at = mesh_.vertices[t[corner % 3]];
        const Vec3 a = mesh_.vertices[t[(corner + 1) % 3]] - at;
        const Vec3 b = mesh_.vertices[t[(corner + 2) % 3]] - at;
        return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    }

    const TriangleMesh& mesh_;
    Meetings meetings_;
    std::vector<Vec3> flat_;
};

}  // namespace

ShadedMesh shaded(const TriangleMesh& mesh)
{
    return Shading(mesh).run();
}

}  // namespace knotspan::formats
