#include "model/mesh_files/glb_writing.h"

#include <nlohmann/json.hpp>

#include "model/mesh_files/mesh_normals.h"

namespace knotspan::formats {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t kFloat = 5126;
constexpr std::uint32_t kInt = 5125;
constexpr int kVertices = 34962;
constexpr int kIndices = 34963;

std::array<float, 3> stored(const Vec3& position, const Vec3& origin)
{
    const Vec3 from = position - origin;
    return {static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(from.z)};
}

Json rowOf(const std::array<float, 3>& numbers)
{
    return {numbers[0], numbers[1], numbers[2]};
}

Json accessor(int view, std::uint32_t type, size_t count, const char* shape)
{
    return {{"bufferView", view}, {"componentType", type}, {"count", count}, {"type", shape}};
}

Json headOf(const ShadedMesh& shaded, const std::vector<std::array<float, 3>>& positions, const Vec3& origin,
            double metres)
{
    std::array<float, 3> low = positions.front();
    std::array<float, 3> high = low;
    for (const auto& position : positions)
        for (size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], position[axis]);
            high[axis] = std::max(high[axis], position[axis]);
        }
    Json place = accessor(0, kFloat, positions.size(), "VEC3");
    place["min"] = rowOf(low);
    place["max"] = rowOf(high);
    const size_t vectors = 12 * positions.size();
    const size_t indices = 12 * shaded.triangles.size();
    const Json matrix{metres,
                      0,
                      0,
                      0,
                      0,
                      0,
                      -metres,
                      0,
                      0,
                      metres,
                      0,
                      0,
                      metres * origin.x,
                      metres * origin.z,
                      -metres * origin.y,
                      1};
    const auto view = [](size_t start, size_t length, int target) {
        return Json{{"buffer", 0}, {"byteOffset", start}, {"byteLength", length}, {"target", target}};
    };
    const Json paint{
        {"baseColorFactor", {0.48, 0.51, 0.57, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 0.6}};
    const Json part{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}, {"indices", 2}, {"material", 0}};
    return {{"asset", {{"version", "2.0"}, {"generator", "Knotspan"}}},
            {"scene", 0},
            {"scenes", Json::array({Json{{"nodes", Json::array({0})}}})},
            {"nodes", Json::array({Json{{"mesh", 0}, {"matrix", matrix}}})},
            {"meshes", Json::array({Json{{"primitives", Json::array({part})}}})},
            {"materials", Json::array({Json{{"pbrMetallicRoughness", paint}, {"doubleSided", true}}})},
            {"accessors", Json::array({place, accessor(1, kFloat, positions.size(), "VEC3"),
                                       accessor(2, kInt, 3 * shaded.triangles.size(), "SCALAR")})},
            {"bufferViews", Json::array({view(0, vectors, kVertices), view(vectors, vectors, kVertices),
                                         view(2 * vectors, indices, kIndices)})},
            {"buffers", Json::array({Json{{"byteLength", 2 * vectors + indices}}})}};
}

}  // namespace

Vec3 glbOrigin(const TriangleMesh& mesh)
{
    return mesh.vertices.empty() ? Vec3(0) : mesh.vertices.front();
}

bool fitsGlb(const TriangleMesh& mesh)
{
    // Each corner a vertex of its own, at the worst.
    constexpr double kMost = 4294967295.0 - 65536;
    return 84.0 * static_cast<double>(mesh.triangles.size()) < kMost;
}

void writeGlb(MeshOutput& out, const TriangleMesh& mesh, double metres)
{
    const ShadedMesh parts = shaded(mesh);
    const Vec3 origin = glbOrigin(mesh);
    std::vector<std::array<float, 3>> positions;
    positions.reserve(parts.vertices.size());
    for (const std::uint32_t vertex : parts.vertices)
        positions.push_back(stored(mesh.vertices[vertex], origin));
    std::string head = headOf(parts, positions, origin, metres).dump();
    head.resize((head.size() + 3) / 4 * 4, ' ');
    const size_t size = 24 * positions.size() + 12 * parts.triangles.size();
    const auto whole = [&](size_t number) { out.bytes(static_cast<std::uint32_t>(number)); };
    out.text("glTF");
    whole(2);
    whole(12 + 8 + head.size() + 8 + size);
    whole(head.size());
    out.text("JSON").text(head);
    whole(size);
    out.text(std::string_view("BIN\0", 4));
    const auto writeAll = [&](const std::vector<std::array<float, 3>>& vectors) {
        for (const auto& vector : vectors)
            for (const float number : vector)
                out.bytes(number);
    };
    writeAll(positions);
    writeAll(parts.normals);
    for (const Triangle& triangle : parts.triangles)
        for (const std::uint32_t vertex : triangle)
            out.bytes(vertex);
}

}  // namespace knotspan::formats
