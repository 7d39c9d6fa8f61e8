// Bodies that touch each other, as the parts of assemblies do: the mesh of each is closed by itself.
#include <gtest/gtest.h>

#include "model/geometry/primitives.h"
#include "model/mesh/tessellation.h"
#include "tests/model/mesh/half_edge_mesh.h"
#include "tests/model/trimming/loop_samples.h"

namespace knotspan {
namespace {

// Its faces look outwards, each trimmed by its own border.
void addBox(Scene& scene, const Vec3& corner, const Vec3& size)
{
    const Vec3 x(size.x, 0, 0);
    const Vec3 y(0, size.y, 0);
    const Vec3 z(0, 0, size.z);
    const TrimLoop square{true, {testing::polyline({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}})}};
    for (const NurbsSurface& face :
         {plane(corner, y, x), plane(corner, x, z), plane(corner, z, y), plane(corner + z, x, y),
          plane(corner + y, z, x), plane(corner + x, y, z)})
        scene.add({.name = "face", .surface = face, .trimLoops = {square}});
}

void expectClosed(const Scene& scene, double volume, long bodies)
{
    const auto mesh = tessellate(scene, {.deviation = 0.01});
    ASSERT_TRUE(mesh) << mesh.error().sentence();
    const MeshTopology topology = topologyOf(mesh->mesh);
    EXPECT_TRUE(topology.isClosedManifold())
        << topology.boundaryEdges << " open, " << topology.nonManifoldEdges << " of more than two, "
        << topology.turnedEdges << " turned";
    EXPECT_EQ(topology.euler, 2 * bodies);
    EXPECT_TRUE(testing::halfEdgesOf(mesh->mesh).manifold);
    EXPECT_NEAR(volumeOf(mesh->mesh), volume, 1e-9);
    EXPECT_TRUE(mesh->notes.empty()) << mesh->notes.front();
}

TEST(TouchingBodies, AreEachClosedWhereAWholeFaceIsCommon)
{
    Scene scene;
    addBox(scene, {0, 0, 0}, {1, 1, 1});
    addBox(scene, {0, 0, 1}, {1, 1, 2});
    expectClosed(scene, 3, 2);
    addBox(scene, {0, 0, 3}, {1, 1, 1});
    addBox(scene, {1, 0, 3}, {1, 1, 1});
    expectClosed(scene, 5, 4);
}

TEST(TouchingBodies, AreEachClosedWhereAnEdgeOrAPartOfOneIsCommon)
{
    Scene along;
    addBox(along, {0, 0, 0}, {1, 1, 1});
    addBox(along, {1, 1, 0}, {1, 1, 1});
    expectClosed(along, 2, 2);
    Scene on;
    addBox(on, {0, 0, 0}, {3, 3, 1});
    addBox(on, {0, 1, 1}, {1, 1, 1});
    expectClosed(on, 10, 2);
    // Four around an edge, which eight faces have.
    Scene around;
    for (const double x : {-1.0, 0.0})
        for (const double y : {-1.0, 0.0})
            addBox(around, {x, y, 0}, {1, 1, 1});
    expectClosed(around, 4, 4);
}

// Two cells with one wall between them: no body can be told from the other.
TEST(TouchingBodies, ThatShareAFaceStayOne)
{
    Scene scene;
    addBox(scene, {0, 0, 0}, {1, 1, 1});
    addBox(scene, {0, 0, 1}, {1, 1, 1});
    const ObjectId wall = std::next(scene.objects().begin(), 3)->first;
    scene.exchange(wall, nullptr);
    const auto mesh = tessellate(scene, {.deviation = 0.01});
    ASSERT_TRUE(mesh);
    const MeshTopology topology = topologyOf(mesh->mesh);
    EXPECT_EQ(topology.boundaryEdges, 0U);
    EXPECT_EQ(topology.nonManifoldEdges, 4U);
}

}  // namespace
}  // namespace knotspan
