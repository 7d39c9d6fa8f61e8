#include "model/mesh_files/mesh_files.h"

#include <sstream>

#include <gtest/gtest.h>

#include "model/mesh/tessellation.h"
#include "model/samples/sample_list.h"
#include "tests/model/mesh/half_edge_mesh.h"
#include "tests/support.h"

namespace knotspan::formats {
namespace {

TriangleMesh torusMesh()
{
    const Scene scene = findSample("torus")->make();
    return tessellate(scene, {.deviation = 0.01 * scene.bounds().diagonal()}).value().mesh;
}

TEST(MeshFiles, OpenInAnotherProgramAsTheClosedManifoldTheyAre)
{
    const testing::TemporaryFolder folder;
    const TriangleMesh mesh = torusMesh();
    for (const MeshFormat& format : meshFormats()) {
        if (format.kind == MeshKind::vtp || format.kind == MeshKind::glb)  // VTK reads those, below
            continue;
        const auto path = folder / ("torus." + format.extension);
        ASSERT_TRUE(writeMesh(path, mesh, format.kind)) << format.name;
        const testing::HalfEdgeFigures read = testing::halfEdgesOf(path);
        EXPECT_TRUE(read.read) << format.name;
        EXPECT_EQ(read.triangles, mesh.triangles.size()) << format.name;
        EXPECT_EQ(read.vertices, mesh.vertices.size()) << format.name;
        EXPECT_EQ(read.boundaryEdges, 0U) << format.name;
        EXPECT_TRUE(read.manifold) << format.name;
    }
}

TEST(MeshFiles, KeepCoordinatesToTheLastBitWhereTheFormatCan)
{
    const testing::TemporaryFolder folder;
    const TriangleMesh mesh{{{1.0 / 3, 1e6 + 1.0 / 7, -1e-20}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    ASSERT_TRUE(writeMesh(folder / "a.obj", mesh, MeshKind::obj));
    std::istringstream text(testing::readFile(folder / "a.obj"));
    std::string line;
    std::getline(text, line);
    std::string letter;
    Vec3 first;
    text >> letter >> first.x >> first.y >> first.z;
    EXPECT_EQ(first, mesh.vertices[0]);
    TriangleMesh rounded = mesh;
    EXPECT_EQ(roundTo(MeshKind::ply, rounded), 0);
    EXPECT_EQ(rounded.vertices, mesh.vertices);
    EXPECT_NEAR(roundTo(MeshKind::stl, rounded), 0.0179, 1e-4);  // 1e6 + 1/7 in float is 1e6 + 1/8
    EXPECT_EQ(rounded.vertices[0].y, 1e6 + 0.125);
}

TEST(MeshFiles, RefuseWhatTheyCannotHold)
{
    const testing::TemporaryFolder folder;
    const TriangleMesh huge{{{1e39, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    EXPECT_FALSE(writeMesh(folder / "huge.stl", huge, MeshKind::stl));
    EXPECT_FALSE(std::filesystem::exists(folder / "huge.stl"));
    EXPECT_TRUE(writeMesh(folder / "huge.ply", huge, MeshKind::ply));
    EXPECT_FALSE(writeMesh(folder / "none" / "a.ply", huge, MeshKind::ply));
}

TEST(MeshFiles, AreKnownByTheirExtension)
{
    EXPECT_EQ(meshKindOf("a/b.STL"), MeshKind::stl);
    EXPECT_EQ(meshKindOf("b.obj"), MeshKind::obj);
    EXPECT_FALSE(meshKindOf("b.step"));
    EXPECT_FALSE(meshKindOf("stl"));
}

}  // namespace
}  // namespace knotspan::formats
