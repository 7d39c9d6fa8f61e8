#include <array>
#include <cmath>
#include <map>
#include <optional>

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "model/files/text_file.h"
#include "model/mesh_files/gltf_file.h"
#include "model/mesh_files/mesh_building.h"
#include "model/mesh_files/mesh_reading.h"

namespace knotspan::formats {

namespace {

using nlohmann::json;

constexpr std::uint64_t kTriangles = 4;
constexpr std::uint64_t kStrip = 5;
constexpr std::uint64_t kFan = 6;

// Walks the nodes of the file's scene; throws Error, or what nlohmann throws where a member is of another
// type.
class GltfReader {
public:
    GltfReader(std::string_view bytes, const std::filesystem::path& folder) : file_(bytes, folder) {}

    [[nodiscard]] Scene read() &&
    {
        scene_.setUnits("m");
        const Mat4 upright{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, 0, 1}};
        if (file_.root().contains("scenes")) {
            const json& scene = file_.element("scenes", wholeMember(file_.root(), "scene", 0));
            addNodes(scene, "nodes", upright, 0);
        } else {
            for (std::uint64_t k = 0; k < file_.root().value("meshes", json::array()).size(); ++k)
                addMesh(k, upright, {});
        }
        if (scene_.meshes().empty())
            throw Error{"The file holds no polygons", {}, "Choose a file with a mesh"};
        return std::move(scene_);
    }

private:
    void addNodes(const json& parent, const char* list, const Mat4& transform, int depth)
    {
        constexpr int kDeepest = 100;
        if (depth > kDeepest)
            refuseGltf("Nodes are nested too deep, or in a circle");
        const auto nodes = parent.find(list);
        if (nodes == parent.end())
            return;
        for (const json& number : *nodes) {
            if (!number.is_number_unsigned() || ++nodes_ > kMostNodes)
                refuseGltf("The nodes are no tree of a sensible size");
            addNode(file_.element("nodes", number.get<std::uint64_t>()), transform, depth);
        }
    }

    void addNode(const json& node, const Mat4& parent, int depth)
    {
        const Mat4 transform = parent * placeOf(node);
        if (node.contains("mesh"))
            addMesh(wholeMember(node, "mesh"), transform, nameIn(node.value("name", std::string())));
        addNodes(node, "children", transform, depth + 1);
    }

    [[nodiscard]] static Mat4 placeOf(const json& node)
    {
        Mat4 place(1.0);
        if (node.contains("matrix")) {
            const auto numbers = node["matrix"].get<std::array<double, 16>>();
            for (int k = 0; k < 16; ++k)
                place[k / 4][k % 4] = numbers[static_cast<size_t>(k)];
        } else {
            const auto move = node.value("translation", std::array<double, 3>{0, 0, 0});
            const auto turn = node.value("rotation", std::array<double, 4>{0, 0, 0, 1});
            const auto size = node.value("scale", std::array<double, 3>{1, 1, 1});
            place = Mat4(glm::mat4_cast(glm::dquat(turn[3], turn[0], turn[1], turn[2])));
            for (int axis = 0; axis < 3; ++axis)
                place[axis] *= size[static_cast<size_t>(axis)];
            place[3] = {move[0], move[1], move[2], 1};
        }
        for (int column = 0; column < 4; ++column)
            if (place[column][3] != (column == 3 ? 1 : 0))
                refuseGltf("A node's matrix is no affine map");
        return place;
    }

    void addMesh(std::uint64_t number, const Mat4& transform, const std::string& name)
    {
        const double volume = glm::determinant(transform);
        if (!std::isfinite(volume) || volume == 0)  // as programs hide things
            return;
        const auto [known, isNew] = meshes_.try_emplace(number);
        if (isNew)
            known->second = meshOf(file_.element("meshes", number));
        if (!known->second)
            return;
        MeshObject object = *known->second;
        triangles_ += object.mesh->triangles.size();
        if (triangles_ > kMostMeshTriangles)
            throw Error{"The file has more than " + std::to_string(kMostMeshTriangles) + " triangles",
                        {},
                        "Split the mesh into several files"};
        if (!name.empty())
            object.name = name;
        object.transform = transform;
        scene_.addMesh(std::move(object));
    }

    // Nothing where it has lines and points alone.
    [[nodiscard]] std::optional<MeshObject> meshOf(const json& mesh)
    {
        MeshBuilding building;
        for (const json& part : mesh.at("primitives"))
            addPart(part, building);
        if (building.isEmpty())
            return {};
        return meshObject(nameIn(mesh.value("name", std::string())), building.take());
    }

    // Vertices stand as often as they have normals and textures; by their places they are one.
    void addPart(const json& part, MeshBuilding& building)
    {
        const std::uint64_t mode = wholeMember(part, "mode", kTriangles);
        if (mode < kTriangles)  // points and lines
            return;
        std::vector<std::uint32_t> numbers;
        for (const Vec3& position : file_.vectors(wholeMember(part.at("attributes"), "POSITION")))
            numbers.push_back(building.weldedVertex(position));
        std::vector<std::uint32_t> indices;
        if (part.contains("indices"))
            indices = file_.indices(wholeMember(part, "indices"));
        else
            for (std::uint32_t k = 0; k < numbers.size(); ++k)
                indices.push_back(k);
        // A small file may name one list of numbers again and again.
        numbers_ += numbers.size() + indices.size();
        if (numbers_ > kMostNumbers)
            refuseGltf("The file uses its numbers too often");
        const auto add = [&](size_t a, size_t b, size_t c) {
            std::array<std::uint32_t, 3> corners{indices[a], indices[b], indices[c]};
            for (std::uint32_t& corner : corners) {
                if (corner >= numbers.size())
                    refuseGltf("A triangle names a vertex that is not there");
                corner = numbers[corner];
            }
            building.polygon(corners);
        };
        for (size_t k = 2; k < indices.size(); k += mode == kTriangles ? 3 : 1) {
            if (mode == kTriangles)
                add(k - 2, k - 1, k);
            if (mode == kStrip)
                k % 2 == 0 ? add(k - 2, k - 1, k) : add(k - 1, k - 2, k);
            if (mode == kFan)
                add(0, k - 1, k);
        }
    }

    static constexpr int kMostNodes = 100'000;
    static constexpr size_t kMostNumbers = 10 * kMostMeshTriangles;

    GltfFile file_;
    Scene scene_;
    std::map<std::uint64_t, std::optional<MeshObject>> meshes_;
    size_t triangles_ = 0;
    size_t numbers_ = 0;
    int nodes_ = 0;
};

}  // namespace

Result<Scene> sceneFromGltf(std::string_view bytes, const std::filesystem::path& folder)
{
    try {
        return GltfReader(bytes, folder).read();
    } catch (const Error& error) {
        return tl::unexpected(error);
    } catch (const json::exception&) {
        return failure("The file is no glTF: a member is missing or of another type than it should be",
                       "Export the mesh again");
    }
}

}  // namespace knotspan::formats
