#include "model/mesh_files/mesh_building.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "model/scene/mesh_object.h"

namespace knotspan::formats {

namespace {

constexpr std::uint32_t kNone = UINT32_MAX;

[[noreturn]] void refuse(const std::string& what, const std::string& remedy = "Export the mesh again")
{
    throw Error{what, {}, remedy};
}

}  // namespace

std::uint32_t MeshBuilding::vertex(const Vec3& position)
{
    if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z))
        refuse("A coordinate of vertex " + std::to_string(vertices()) + " is not finite");
    if (vertices() >= 3 * kMostMeshTriangles)
        refuse("The mesh has more than " + std::to_string(3 * kMostMeshTriangles) + " vertices",
               "Split the mesh into several files");
    mesh_.vertices.push_back(position);
    return static_cast<std::uint32_t>(vertices() - 1);
}

std::uint32_t MeshBuilding::weldedVertex(const Vec3& position)
{
    if (2 * vertices() >= table_.size())
        growTable();
    const Vec3 unsignedZeros = position + 0.0;
    const size_t place = placeOf(unsignedZeros);
    if (table_[place] == kNone)
        table_[place] = vertex(unsignedZeros);
    return table_[place];
}

// Where the vertex is, or would be.
size_t MeshBuilding::placeOf(const Vec3& position) const
{
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(position[axis])) * 0x9E3779B97F4A7C15U;
        hash ^= hash >> 32U;
    }
    size_t place = hash & (table_.size() - 1);
    while (table_[place] != kNone && mesh_.vertices[table_[place]] != position)
        place = (place + 1) & (table_.size() - 1);
    return place;
}

void MeshBuilding::growTable()
{
    table_.assign(std::max<size_t>(1024, 2 * table_.size()), kNone);
    for (std::uint32_t k = 0; k < vertices(); ++k)
        table_[placeOf(mesh_.vertices[k])] = k;
}

void MeshBuilding::polygon(std::span<const std::uint32_t> corners)
{
    if (corners.size() < 3)
        refuse("A polygon has fewer than three corners");
    for (const std::uint32_t corner : corners)
        if (corner >= vertices())
            refuse("A polygon names vertex " + std::to_string(corner) + ", but there are " +
                   std::to_string(vertices()));
    if (mesh_.triangles.size() + corners.size() - 2 > kMostMeshTriangles)
        refuse("The mesh has more than " + std::to_string(kMostMeshTriangles) + " triangles",
               "Split the mesh into several files");
    cut_.clear();
    cutting_.cut(corners, mesh_.vertices, cut_);
    for (const Triangle& triangle : cut_) {
        const auto& [a, b, c] = triangle;
        if (a == b || b == c || c == a)
            ++dropped_;
        else
            mesh_.triangles.push_back(triangle);
    }
}

void MeshBuilding::reserve(size_t vertices, size_t triangles)
{
    mesh_.vertices.reserve(std::min(vertices, 3 * kMostMeshTriangles));
    mesh_.triangles.reserve(std::min(triangles, kMostMeshTriangles));
}

TriangleMesh MeshBuilding::take()
{
    if (mesh_.triangles.empty())
        refuse("The file holds no polygons", "Choose a file with a mesh");
    std::vector<std::uint32_t> number(vertices(), kNone);
    for (const Triangle& triangle : mesh_.triangles)
        for (const std::uint32_t corner : triangle)
            number[corner] = 0;
    std::uint32_t count = 0;
    for (size_t k = 0; k < number.size(); ++k)
        if (number[k] == 0) {
            mesh_.vertices[count] = mesh_.vertices[k];
            number[k] = count++;
        }
    mesh_.vertices.resize(count);
    for (Triangle& triangle : mesh_.triangles)
        for (std::uint32_t& corner : triangle)
            corner = number[corner];
    return std::move(mesh_);
}

}  // namespace knotspan::formats
