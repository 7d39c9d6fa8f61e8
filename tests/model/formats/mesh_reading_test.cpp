#include "model/mesh_files/mesh_reading.h"

#include <bit>
#include <cstring>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/formats/format_list.h"
#include "model/mesh/tessellation.h"
#include "model/mesh_files/mesh_building.h"
#include "model/mesh_files/mesh_files.h"
#include "model/samples/sample_list.h"
#include "tests/model/mesh/vtk_mesh.h"
#include "tests/support.h"

namespace knotspan::formats {
namespace {

TriangleMesh torusMesh()
{
    const Scene scene = findSample("torus")->make();
    return tessellate(scene, {0.01 * scene.bounds().diagonal(), {}, false, 1'000'000}).value().mesh;
}

TriangleMesh onlyMeshIn(const std::filesystem::path& path)
{
    const auto scene = read(path);
    EXPECT_TRUE(scene) << scene.error().sentence();
    if (!scene || scene->meshes().size() != 1)
        return {};
    const MeshObject& object = *scene->meshes().begin()->second;
    TriangleMesh mesh = *object.mesh;
    for (Vec3& vertex : mesh.vertices)
        vertex = transformed(vertex, object.transform);
    return mesh;
}

double volumeOfCube(const std::string& bytes, Result<TriangleMesh> (*parse)(std::string_view))
{
    const auto mesh = parse(bytes);
    EXPECT_TRUE(mesh) << mesh.error().sentence();
    if (!mesh)
        return 0;
    EXPECT_EQ(mesh->vertices.size(), 8U);
    EXPECT_EQ(mesh->triangles.size(), 12U);
    EXPECT_TRUE(topologyOf(*mesh).isClosedManifold());
    return volumeOf(*mesh);
}

// Of the side 2 around the origin; quadrilaterals that look outwards.
const std::vector<Vec3> kCorners{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                 {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
const std::vector<std::array<int, 4>> kSides{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                             {2, 3, 7, 6}, {1, 2, 6, 5}, {0, 4, 7, 3}};

std::string rowOf(const Vec3& v)
{
    return std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z);
}

std::string cubeAsOff(const std::string& head, const std::string& behind)
{
    std::string text = head;
    for (const Vec3& corner : kCorners)
        text += rowOf(corner) + behind + "\n";
    for (const auto& [a, b, c, d] : kSides)
        text += "4 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + " " +
                std::to_string(d) + " 255 0 0 # red\n";
    return text;
}

template <class Number>
std::string bytesOf(Number number, std::endian order)
{
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    if (order != std::endian::native)
        std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

// With properties and elements that a reader has to step over.
std::string cubeAsPly(std::optional<std::endian> order)
{
    const std::string format = !order                          ? "ascii"
                               : *order == std::endian::little ? "binary_little_endian"
                                                               : "binary_big_endian";
    std::string text =
        "ply\r\nformat " + format +
        " 1.0\ncomment a cube\nelement camera 1\nproperty list uchar float view\nelement vertex 8\n"
        "property uchar red\nproperty double x\nproperty float y\nproperty double z\n"
        "element face 6\nproperty list uchar int vertex_indices\nproperty short material\nend_header\n";
    if (!order) {
        text += "2 0.5 0.25\n";
        for (const Vec3& corner : kCorners)
            text += "255 " + rowOf(corner) + "\n";
        for (const auto& [a, b, c, d] : kSides)
            text += "4 " + std::to_string(a) + " " + std::to_string(b) + "\n" + std::to_string(c) + " " +
                    std::to_string(d) + " -7\n";
        return text;
    }
    text += bytesOf<std::uint8_t>(2, *order) + bytesOf(0.5F, *order) + bytesOf(0.25F, *order);
    for (const Vec3& corner : kCorners)
        text += bytesOf<std::uint8_t>(255, *order) + bytesOf(corner.x, *order) +
                bytesOf(static_cast<float>(corner.y), *order) + bytesOf(corner.z, *order);
    for (const auto& side : kSides) {
        text += bytesOf<std::uint8_t>(4, *order);
        for (const int corner : side)
            text += bytesOf(corner, *order);
        text += bytesOf<std::int16_t>(-7, *order);
    }
    return text;
}

std::string cubeAsStl()
{
    std::string text = "solid facet loop\n";
    for (const auto& [a, b, c, d] : kSides)
        for (const auto& corners : {std::array{a, b, c}, std::array{a, c, d}}) {
            text += "  FACET NORMAL 0 0 nan outer loop\n";
            for (const int corner : corners)
                text += "vertex " + rowOf(kCorners[static_cast<size_t>(corner)]) + "\n";
            text += "endloop endfacet\n";
        }
    return text + "endsolid facet loop\n";
}

TEST(MeshReading, GivesBackWhatWasWrittenVertexForVertex)
{
    const testing::TemporaryFolder folder;
    for (const MeshFormat& format : meshFormats()) {
        TriangleMesh mesh = torusMesh();
        roundTo(format.kind, mesh);
        const auto path = folder / ("torus." + format.extension);
        ASSERT_TRUE(writeMesh(path, mesh, format.kind, "m")) << format.name;
        const TriangleMesh back = onlyMeshIn(path);
        ASSERT_EQ(back.triangles.size(), mesh.triangles.size()) << format.name;
        EXPECT_EQ(back.vertices.size(), mesh.vertices.size()) << format.name;
        EXPECT_EQ(read(path)->meshes().begin()->second->name,
                  format.kind == MeshKind::obj ? "Mesh" : "torus");
        EXPECT_TRUE(topologyOf(back).isClosedManifold()) << format.name;
        double furthest = 0;
        for (size_t k = 0; k < mesh.triangles.size(); ++k)
            for (size_t c = 0; c < 3; ++c)
                furthest = std::max(furthest, glm::distance(back.vertices[back.triangles[k][c]],
                                                            mesh.vertices[mesh.triangles[k][c]]));
        EXPECT_LE(furthest, format.kind == MeshKind::glb ? 1e-15 : 0) << format.name;
    }
}

TEST(MeshFiles, OfVtkAndGltfAreReadByVtkAsTheSameTriangles)
{
    const testing::TemporaryFolder folder;
    TriangleMesh mesh = torusMesh();
    ASSERT_TRUE(writeMesh(folder / "a.vtp", mesh, MeshKind::vtp));
    const TriangleMesh vtp = testing::vtkMeshOf(folder / "a.vtp");
    EXPECT_EQ(vtp.vertices, mesh.vertices);
    EXPECT_EQ(vtp.triangles, mesh.triangles);
    // In metres, y up, and with vertices once for each normal.
    ASSERT_TRUE(writeMesh(folder / "a.glb", mesh, MeshKind::glb, "mm"));
    const TriangleMesh glb = testing::vtkMeshOf(folder / "a.glb");
    ASSERT_EQ(glb.triangles.size(), mesh.triangles.size());
    for (size_t k = 0; k < mesh.triangles.size(); ++k)
        for (size_t c = 0; c < 3; ++c) {
            const Vec3 meant = mesh.vertices[mesh.triangles[k][c]] / 1000.0;
            EXPECT_LE(glm::distance(glb.vertices[glb.triangles[k][c]], Vec3(meant.x, meant.z, -meant.y)),
                      1e-6);
        }
}

TEST(MeshReading, TakesEveryWayOfWritingACube)
{
    EXPECT_NEAR(volumeOfCube(cubeAsOff("OFF\n# a cube\n8 6 12\n", ""), meshFromOff), 8, 1e-14);
    EXPECT_NEAR(volumeOfCube(cubeAsOff("CNOFF 8 6 0\n", " 0 0 1 255 255 0 255"), meshFromOff), 8, 1e-14);
    EXPECT_NEAR(volumeOfCube(cubeAsPly({}), meshFromPly), 8, 1e-14);
    EXPECT_NEAR(volumeOfCube(cubeAsPly(std::endian::little), meshFromPly), 8, 1e-14);
    EXPECT_NEAR(volumeOfCube(cubeAsPly(std::endian::big), meshFromPly), 8, 1e-14);
    EXPECT_NEAR(volumeOfCube(cubeAsStl(), meshFromStl), 8, 1e-14);
}

TEST(MeshReading, KeepsDoublesAndNamesTheMeshAfterTheFile)
{
    const testing::TemporaryFolder folder;
    testing::writeFile(folder / "my part.off",
                       "OFF\n3 1 0\n0.1 1e-300 12345678.87654321\n1 0 0\n0 1 0\n3 0 1 2\n");
    const auto scene = read(folder / "my part.off");
    ASSERT_TRUE(scene) << scene.error().sentence();
    const MeshObject& object = *scene->meshes().begin()->second;
    EXPECT_EQ(object.name, "my part");
    EXPECT_EQ(object.mesh->vertices[0], Vec3(0.1, 1e-300, 12345678.87654321));
}

TEST(MeshReading, CutsPolygonsThatAreNotConvexByTheirEars)
{
    // An L, and a star of five points, both in a slanted plane: the triangles' areas add up to theirs.
    const auto slanted = [](double x, double y) { return Vec3(x, y, 0.5 * x + y); };
    const std::vector<Vec3> shapes[] = {
        {slanted(0, 0), slanted(2, 0), slanted(2, 1), slanted(1, 1), slanted(1, 2), slanted(0, 2)},
        {slanted(0, 3), slanted(-0.7, 1), slanted(-3, 1), slanted(-1.2, -0.4), slanted(-2, -3),
         slanted(0, -1.3), slanted(2, -3), slanted(1.2, -0.4), slanted(3, 1), slanted(0.7, 1)}};
    for (const auto& shape : shapes) {
        MeshBuilding building;
        std::vector<std::uint32_t> corners;
        Vec3 area(0);
        for (size_t k = 0; k < shape.size(); ++k) {
            corners.push_back(building.vertex(shape[k]));
            area += glm::cross(shape[k], shape[(k + 1) % shape.size()]);
        }
        building.polygon(corners);
        const TriangleMesh mesh = building.take();
        EXPECT_EQ(mesh.triangles.size(), shape.size() - 2);
        double sum = 0;
        for (const auto& [a, b, c] : mesh.triangles) {
            const Vec3 normal =
                glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
            EXPECT_GT(glm::dot(normal, area), 0);
            sum += glm::length(normal);
        }
        EXPECT_NEAR(sum, glm::length(area), 1e-12);
    }
}

TEST(MeshReading, TakesAGltfsNodesWithTheirPlaces)
{
    const std::string triangle =
        "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    const auto fileWith = [&](const std::string& nodes) {
        return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
               R"(,"meshes":[{"name":"tile","primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)" +
               R"("componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],)" +
               R"("buffers":[{"byteLength":36,"uri":")" + triangle + "\"}]}";
    };
    const auto scene = sceneFromGltf(
        fileWith(
            R"([{"children":[1,2],"translation":[0,5,0]},{"mesh":0,"scale":[2,2,2]},{"mesh":0,"name":"b"}])"),
        {});
    ASSERT_TRUE(scene) << scene.error().sentence();
    ASSERT_EQ(scene->meshes().size(), 2U);
    EXPECT_EQ(scene->units(), "m");
    const MeshObject& first = *scene->meshes().begin()->second;
    const MeshObject& second = *scene->meshes().rbegin()->second;
    EXPECT_EQ(first.name, "tile");
    EXPECT_EQ(second.name, "b");
    EXPECT_EQ(first.mesh, second.mesh);
    // glTF's y is our z.
    EXPECT_EQ(transformed(first.mesh->vertices[2], first.transform), Vec3(0, 0, 7));
    const auto circle = sceneFromGltf(fileWith(R"([{"children":[0],"mesh":0}])"), {});
    ASSERT_FALSE(circle);
    EXPECT_NE(circle.error().what.find("circle"), std::string::npos);
}

TEST(MeshReading, RefusesWithASentence)
{
    const auto refusal = [](const Result<TriangleMesh>& mesh) { return mesh ? "" : mesh.error().what; };
    EXPECT_EQ(refusal(meshFromOff("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n")),
              "There is no vertex \"3\": the file has 3");
    EXPECT_EQ(refusal(meshFromOff("OFF\n1000000 1 0\n")),
              "The file says that it has 1000000 vertices, but it is too short for them");
    EXPECT_EQ(refusal(meshFromOff("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n")), "The file holds no polygons");
    EXPECT_EQ(refusal(meshFromStl(std::string(84, '\x7f'))),
              "The file should have 2139062143 triangles but ends after 0");
    EXPECT_EQ(refusal(meshFromStl("solid a\nfacet\nvertexes 0 0 0\n")),
              "\"vertexes\" is no word of STL files");
    EXPECT_EQ(
        refusal(meshFromPly("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n1 2 3 ")),
        "The vertices have no coordinate y");
    EXPECT_EQ(
        refusal(meshFromPly("ply\nformat binary_little_endian 1.0\nelement vertex 99999999999\nproperty "
                            "float x\nproperty float y\nproperty float z\nend_header\n")),
        "The file says that it has 99999999999 elements \"vertex\", but it is too short for them");
    std::string infinite = cubeAsPly(std::endian::little);
    infinite.replace(infinite.find("end_header\n") + 11 + 9 + 1, 8, bytesOf(1e308 * 10, std::endian::little));
    EXPECT_EQ(refusal(meshFromPly(infinite)), "A coordinate of vertex 0 is not finite");
}

// In the process itself, so that a crash is a failure of this test.
TEST(MeshReading, OutlivesFilesThatAreCutOrChanged)
{
    const testing::TemporaryFolder folder;
    const TriangleMesh mesh{kCorners, {{0, 3, 2}, {0, 2, 1}, {4, 5, 6}, {4, 6, 7}}};
    std::mt19937 random(5);
    for (const MeshFormat& format : meshFormats()) {
        if (format.kind == MeshKind::vtp)  // in a process of its own
            continue;
        const auto path = folder / ("a." + format.extension);
        ASSERT_TRUE(writeMesh(path, mesh, format.kind));
        const std::string whole = testing::readFile(path);
        const auto readAgain = [&](const std::string& bytes) {
            testing::writeFile(path, bytes);
            const auto scene = read(path);
            EXPECT_TRUE(scene || !scene.error().what.empty());
        };
        for (size_t k = 0; k < 64; ++k)
            readAgain(whole.substr(0, whole.size() * k / 64));
        for (int k = 0; k < 400; ++k) {
            std::string changed = whole;
            changed[random() % changed.size()] = static_cast<char>(random());
            readAgain(changed);
        }
    }
}

}  // namespace
}  // namespace knotspan::formats
